"""The looks of a `face` definition to colours, choices and amounts; a seed draws those that are not written."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal, TypeVar

from facescript.ir.kind import KindHead, Tint
from facescript.ir.random import between, chance
from facescript.resolve.kinds.words import AMOUNTS, LOOKS, TINTED
from facescript.resolve.lines import Line
from facescript.resolve.project import Project, Refused
from facescript.resolve.units import COUNT, SHARE
from facescript.syntax.tree import Colour, Name, Word

T = TypeVar("T")

NONE = "none"
"""The choice of nothing."""

COLOURS: Mapping[str, str] = {"eyebrows": "brows"}
"""Looks whose colours have another name, for `brows` are raised."""

WITHOUT = 0.6
"""How often a stranger has none of what may be none."""

DRAWN: Mapping[str, tuple[float, float]] = {
    "age": (0.0, 0.7),
    "width": (0.2, 0.8),
    "make-up": (0.0, 0.5),
    "freckles": (-0.8, 0.6),
}
"""Between which amounts a stranger's lie, below 0 none."""


@dataclass(slots=True)
class Looks:
    """What is chosen: colours by family, choices and amounts by name, and whether the hair is `still`."""

    hair: Literal["", "still"] = ""

    _colours: dict[str, str] = field(default_factory=dict)
    _choices: dict[str, str] = field(default_factory=dict)
    _amounts: dict[str, float] = field(default_factory=dict)

    @property
    def colours(self) -> tuple[tuple[str, str], ...]:
        return tuple(self._colours.items())

    @property
    def choices(self) -> tuple[tuple[str, str], ...]:
        return tuple(self._choices.items())

    @property
    def amounts(self) -> tuple[tuple[str, float], ...]:
        return tuple(self._amounts.items())


def looks(project: Project, line: Line, kind: str, head: KindHead) -> Looks:
    """The looks of a face of a kind. What it cannot have is warned of and left out; a slip is reported."""
    reader = _Reader(project, line, kind, head)
    for name in dict.fromkeys((*LOOKS, *TINTED)):
        reader.look(name)
    for name in AMOUNTS:
        reader.amount(name)
    reader.stranger()
    return reader.found


class _Reader:
    """The looks read so far, and what there is to choose from."""

    def __init__(self, project: Project, line: Line, kind: str, head: KindHead) -> None:
        self.project, self.line, self.kind, self.head = project, line, kind, head
        self.choices, self.usual, self.tints = dict(head.looks), dict(head.amounts), dict(head.tints)
        self.found = Looks()

    def look(self, name: str) -> None:
        """The choice and the colour of one look, as far as they are written."""
        words = self.line.parts.get(name)
        if words is None:
            return
        family = self._family(name)
        if family is None and name not in self.choices:
            self.project.report("FS248", self.line.spans[name], kind=self.kind, name=name)
            return
        for word in words:
            if name == "hair" and isinstance(word, Name) and word.text == "still":
                self.found.hair = "still"
            else:
                self._word(name, family, word)

    def _word(self, name: str, family: str | None, word: Word) -> None:
        if isinstance(word, Colour) and family is not None:
            self.found._colours[family] = word.text.lower()
        elif isinstance(word, Name) and word.text in self.choices.get(name, ()):
            self.found._choices[name] = word.text
        elif isinstance(word, Name) and family is not None and (tint := self._tint(name, word.text)):
            self.found._colours[family] = tint.colour
        else:
            self._unknown(name, word)

    def _unknown(self, name: str, word: Word) -> None:
        there = [*self.choices.get(name, ()), *(tint.name for tint in self.tints.get(name, ()))]
        text = word.text if isinstance(word, Name) else word.span.text
        clause, fixes = self.project.meant(text, there, word.span)
        if not fixes and there:
            clause = "; there are " + ", ".join(f"`{each}`" for each in there) + " and colours such as `#5b3a22`."
        self.project.report("FS249", word.span, fixes=fixes, text=text, name=name, kind=self.kind, meant=clause)

    def _family(self, name: str) -> str | None:
        """The family of colours that a look tints: its own, or an animal's fur."""
        name = COLOURS.get(name, name)
        if name in self.head.families:
            return name
        return "fur" if name in ("hair", "skin") and "fur" in self.head.families else None

    def _tint(self, name: str, text: str) -> Tint | None:
        return next((tint for tint in self.tints.get(name, ()) if tint.name == text), None)

    def amount(self, name: str) -> None:
        """One amount, if it is written."""
        if name not in self.line.parts:
            return
        if name not in self.usual:
            self.project.report("FS248", self.line.spans[name], kind=self.kind, name=name)
            return
        try:
            value = self.line.factor(name, SHARE)
        except Refused:
            return
        if value is not None:
            self.found._amounts[name] = min(value, 1.0)

    # -------------------------------------------------------------------------------------------- strangers

    def stranger(self) -> None:
        """Draw all that is not written, if there is a seed: the same for ever."""
        try:
            seed = self.line.factor("seed", COUNT)
        except Refused:
            return
        if seed is None:
            return
        number = int(seed)
        for name, options in self.choices.items():
            self.found._choices.setdefault(name, self._drawn_choice(number, name, options))
        skin = self._drawn_skin(number)
        for name, family, tints in self._families():
            fitting = [tint for tint in tints if not tint.goes or skin is None or skin in tint.goes]
            if name != "skin" and fitting:
                self.found._colours.setdefault(family, _picked(fitting, number, self.kind, name).colour)
        for name in self.usual:
            drawn = max(between(*DRAWN[name], number, self.kind, name), 0.0)
            self.found._amounts.setdefault(name, round(drawn, 3))

    def _drawn_choice(self, seed: int, name: str, options: tuple[str, ...]) -> str:
        some = [option for option in options if option != NONE]
        if NONE in options and chance(seed, self.kind, name, NONE) < WITHOUT:
            return NONE
        return _picked(some, seed, self.kind, name)

    def _drawn_skin(self, seed: int) -> str | None:
        """The skin's name, drawn where it is not written; None where it has none."""
        tints = self.tints.get("skin", ())
        family = self._family("skin")
        if not tints or family is None:
            return None
        written = self.found._colours.get(family)
        if written is not None:
            return next((tint.name for tint in tints if tint.colour == written), None)
        skin = _picked(tints, seed, self.kind, "skin")
        self.found._colours[family] = skin.colour
        return skin.name

    def _families(self) -> Iterator[tuple[str, str, tuple[Tint, ...]]]:
        """The looks that have colours with names: look, family, colours."""
        for name, tints in self.tints.items():
            family = self._family(name)
            if family is not None:
                yield name, family, tints


def _picked(options: Sequence[T], seed: int, *place: object) -> T:
    return options[int(chance(seed, *place) * len(options))]
