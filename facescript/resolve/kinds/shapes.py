"""The `shape` rows of a kind to its shapes."""

from __future__ import annotations

from collections.abc import Collection
from typing import Literal, cast

from facescript.ir.kind import Fill, KindOutline, KindPoint, KindShape
from facescript.resolve.kinds.fills import fill
from facescript.resolve.kinds.row import Row, Words, spelled
from facescript.resolve.kinds.words import LAWS, LAYERS, LIVE
from facescript.text import Span

Form = Literal["outline", "half", "stroke", "spot", "disc"]

NUMBERS: dict[Form, int] = {"outline": 2, "half": 2, "stroke": 3, "spot": 4, "disc": 4}
"""How many numbers a point of each form of outline has."""

LEAST: dict[Form, int] = {"outline": 3, "half": 3, "stroke": 2, "spot": 1, "disc": 1}
"""How many points each form has at least."""


def shape(row: Row, palette: Collection[str], looks: dict[str, tuple[str, ...]]) -> KindShape:
    """One shape; `looks` are the kind's choices by name. Raises `Refused`."""
    name = row.name(row.one(row.phrases[0].words[1:], row.span), "shape")
    found = _Found(row, palette, looks)
    for phrase, (word, words) in zip(row.phrases[1:], row.clauses(), strict=True):
        found.take(word, words, phrase.span)
    return found.shape(name)


class _Found:
    """What the clauses of a shape have said so far."""

    def __init__(self, row: Row, palette: Collection[str], looks: dict[str, tuple[str, ...]]) -> None:
        self.row, self.palette, self.looks = row, palette, looks
        self.group, self.law, self.sides = "", "", ""
        self.fill: Fill | None = None
        self.depth: float | None = None
        self.opacity = 1.0
        self.clip: tuple[str, ...] = ()
        self.outlines: list[KindOutline] = []
        self.when: list[tuple[str, tuple[str, ...]]] = []

    def take(self, word: str, words: Words, span: Span) -> None:
        """One clause: its first word, the words after it, and where it stands."""
        row = self.row
        if word in NUMBERS:
            self._outline(word, words, span)
        elif word == "in":
            self.group = row.name(row.one(words, span), "layer", LAYERS)
        elif word == "law":
            self.law = row.name(row.one(words[:1], span), "law of depth", LAWS)
            self.depth = row.numbers(words[1:], 1, span)[0] if len(words) > 1 else None
        elif word == "fill":
            self.fill = fill(row, words, self.palette, span)
        elif word == "opacity":
            self.opacity = row.share(row.one(words, span))
        elif word == "clip" and words:
            self.clip = tuple(row.name(each, "shape") for each in words)
        elif word in ("both", "each") and [spelled(each) for each in words] in (["sides"], ["side"], ["eye"]):
            self.sides = word
        elif word == "when" and len(words) > 1:
            self._when(words)
        else:
            raise row.refuse(span)

    def _when(self, words: Words) -> None:
        name = self.row.name(words[0], "look of this kind", self.looks)
        choices = [each for each in words[1:] if spelled(each) != "or"]
        self.when.append((name, tuple(self.row.name(each, name, self.looks[name]) for each in choices)))

    def _outline(self, form: Form, words: Words, span: Span) -> None:
        points = self.row.spots(words, NUMBERS[form], span)
        if len(points) < LEAST[form] or any(_flat(form, point) for point in points):
            raise self.row.refuse(span)
        self.outlines.append(KindOutline(form, points))

    def shape(self, name: str) -> KindShape:
        """The shape, if nothing is missing."""
        row = self.row
        live = LIVE.get(name)
        group, law = self.group or live or "", self.law or ("eye" if live == "eye" else "mouth" if live else "")
        for what, there in (("in LAYER", group), ("law LAW", law), ("fill COLOUR", self.fill)):
            if not there:
                raise row.project.refuse("FS244", row.span, what=f"`{what}`", name=name, form=row.form)
        if live is not None and (group != live or self.outlines):
            raise row.project.refuse("FS245", row.span, name=name, layer=live)
        if live is None and not self.outlines:
            raise row.project.refuse("FS244", row.span, what="`outline POINTS`", name=name, form=row.form)
        assert self.fill is not None
        return KindShape(
            name, group, law, self.fill, row.span, tuple(self.outlines), self.opacity, self.clip,
            cast("Literal['', 'both', 'each']", self.sides), self.depth, tuple(self.when),
        )  # fmt: skip


def _flat(form: Form, point: KindPoint) -> bool:
    """Whether a stroke or an ellipse has no breadth there."""
    return form in ("stroke", "spot", "disc") and min(point.numbers[2:]) <= 0.0
