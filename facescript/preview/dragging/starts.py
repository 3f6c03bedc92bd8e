"""A statement to the ways in which it can be made to start earlier or later, the smallest edit first.

That is another number of the `at` that it stands in or of the `wait` before it, or a new `wait`. Where it starts
together with others, or where nothing comes behind it, it can be given a moment of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import inf

from facescript.preview.dragging.amounts import Change, Literal, Stuck, literal, number, time, written
from facescript.preview.dragging.standing import Level, Standing, above, commented, margin, row
from facescript.resolve.lines import segments
from facescript.syntax import tree
from facescript.text import Source

PAUSE = 0.25
"""Seconds between two lines of speech that follow each other, which a `wait` between them does away with."""


@dataclass(frozen=True, slots=True)
class Way:
    """How a start is moved: `edit` gives the change that moves it by so many seconds; `least` is how far it can come
    forward. `edit` raises `Stuck`."""

    edit: Callable[[float], Change]
    least: float = -inf


@dataclass(frozen=True, slots=True)
class Starts:
    """The ways for one statement of a script; `began` is when it starts now, seconds from its scene's start."""

    script: tree.Script
    standing: Standing
    began: float

    @property
    def source(self) -> Source:
        return self.script.source

    def ways(self) -> Iterator[Way]:
        """In the order in which they are tried. Raises `Stuck` where there is none."""
        passed: list[Level] = []
        for level in self.standing.levels:
            passed.append(level)
            if level.before is not None:
                yield from self._behind(passed, level.before)
                return
            if isinstance(level.block, tree.Moment):
                yield self._moment(level.block.time)
                return
            if not isinstance(level.block, tree.Cast | tree.Group) or level.beside:
                yield from self._first(passed)
                return

    # -------------------------------------------------------------------------------------------- in a sequence

    def _behind(self, passed: list[Level], before: tree.Item | tree.On) -> Iterator[Way]:
        """The ways of what follows something."""
        wait = _wait(before)
        if wait is not None:
            yield self._waited(before, wait)
            return
        if (until := _until(before)) is not None:
            yield self._moment(until)
            return
        yield from self._inserted(passed)
        if passed[-1].after is None:
            yield self._at(passed[-1])

    def _first(self, passed: list[Level]) -> Iterator[Way]:
        """The ways of what comes first in its block."""
        block = passed[-1].block
        beside = passed[-1].beside
        if isinstance(block, tree.On) and margin(self.source, self.standing.act) is None:
            raise Stuck(f"it starts on the word “{block.word.value}” of the line above it: change that in the text.")
        inside = passed[:-1] if beside else passed
        yield from self._inserted(inside)
        if beside:
            yield self._at(passed[-1])
        elif not any(self._can_wait(level) for level in inside):
            raise Stuck(
                "no line of its own begins with it, before which a `wait` could stand: give it one in the text."
            )

    def _waited(self, unit: tree.Item | tree.On, words: tuple[tree.Word, ...]) -> Way:
        """By the `wait` before it, which goes where nothing is left of it."""
        found = number(words, self.script, f"the `wait` before it (line {self._line(unit)})")
        speaks = _verb(self.standing.act) == "say"

        def edit(by: float) -> Change:
            left = found.value + by
            if left < -0.005:
                raise Stuck(f"the `wait` before it is only {found.word.span.text}.")
            bare = written(max(left, 0.0), "ms") == "0ms" and found.first is None
            if bare and not speaks and not commented(self.source, unit):
                return Change(*row(self.source, unit), "")
            return found.changed(max(left, 0.0) if found.first is None else left)

        return Way(edit, -found.value)

    def _inserted(self, passed: list[Level]) -> Iterator[Way]:
        """By a `wait` in a line of its own before it, or before the outermost of the blocks that it begins."""
        level = next((level for level in reversed(passed) if self._can_wait(level)), None)
        if level is not None:
            pause = PAUSE if _verb(self.standing.act) == "say" and _ends_in_line(passed[-1].before) else 0.0
            yield self._before(level.unit, margin(self.source, level.unit) or "", pause)

    def _can_wait(self, level: Level) -> bool:
        """Whether a line with a `wait` can stand before what stands here."""
        return not level.apart and margin(self.source, level.unit) is not None

    def _before(self, unit: tree.Item | tree.On, spaces: str, pause: float) -> Way:
        """By a `wait` before a statement; `pause` is what it does away with."""
        place = above(self.source, unit)

        def edit(by: float) -> Change:
            length = by + pause
            if length < (-0.005 if pause else 0.005):
                raise Stuck("it starts as soon as what stands before it has settled, and cannot come sooner.")
            return Change(place, place, f"{spaces}wait {time(max(length, 0.0))}\n")

        return Way(edit, -pause)

    # -------------------------------------------------------------------------------------------- at a moment

    def _moment(self, phrase: tree.Phrase) -> Way:
        """By the moment that it is set at."""
        words = phrase.words
        found: Literal | None = literal(words)
        if found is None and not _names_moment(words):
            number(words, self.script, f"its moment (line {self.source.position(phrase.span.start)[0]})")

        def edit(by: float) -> Change:
            if found is None:
                end = words[-1].span.end
                return Change(end, end, f" {'-' if by < 0 else '+'} {time(abs(by))}")
            if found.first is None and found.value + by < -0.005:
                raise Stuck("its block has not begun yet then: nothing in it can start sooner.")
            moment = found.value + by
            return found.changed(max(moment, 0.0) if found.first is None else moment)

        return Way(edit, -found.value if found is not None and found.first is None else -inf)

    def _at(self, level: Level) -> Way:
        """By a moment of its own."""

        def edit(by: float) -> Change:
            if self.began + by < -0.005:
                raise Stuck("its block has not begun yet then: nothing in it can start sooner.")
            start = level.unit.span.start
            return Change(start, start, f"at {time(max(self.began + by, 0.0))}: ")

        return Way(edit, -self.began)

    def _line(self, unit: tree.Item | tree.On) -> int:
        return self.source.position(unit.span.start)[0]


def _verb(act: tree.Act) -> str:
    word = act.phrases[0].words[0]
    return word.text if isinstance(word, tree.Name) else ""


def _ends_in_line(unit: tree.Item | tree.On | None) -> bool:
    """Whether a line of speech is the last that a statement does."""
    while isinstance(unit, tree.Cast | tree.Group) and not (isinstance(unit, tree.Group) and unit.kind == "together"):
        unit = unit.body[-1]
    return isinstance(unit, tree.Act) and _verb(unit) == "say"


def waiting(unit: tree.Item | tree.On | None) -> tree.Act | None:
    """The line that waits, with or without a face before it."""
    while isinstance(unit, tree.Cast) and len(unit.body) == 1:
        unit = unit.body[0]
    return unit if isinstance(unit, tree.Act) and _verb(unit) == "wait" else None


def _wait(unit: tree.Item | tree.On | None) -> tuple[tree.Word, ...] | None:
    """The amount that a `wait` waits."""
    act = waiting(unit)
    if act is None or len(act.phrases) > 1:
        return None
    words = segments(act.phrases[0].words)[0][1:]
    return None if _is_until(words) else words


def _until(unit: tree.Item | tree.On | None) -> tree.Phrase | None:
    act = waiting(unit)
    if act is None or not _is_until(act.phrases[0].words[1:]):
        return None
    words = segments(act.phrases[0].words)[0][2:]
    return tree.Phrase(words, words[0].span.to(words[-1].span))


def _is_until(words: tuple[tree.Word, ...]) -> bool:
    return bool(words) and isinstance(words[0], tree.Name) and words[0].text == "until"


def _names_moment(words: tuple[tree.Word, ...]) -> bool:
    """Whether words are the moment of something named, alone."""
    return len(words) == 1 and isinstance(words[0], tree.Dotted)
