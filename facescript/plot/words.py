"""The time axis and the spoken words under it, none over another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from facescript.plot.axis import Scale
from facescript.plot.font import width
from facescript.plot.looks import GREY, INK
from facescript.plot.marks import SMALL, Mark, Text, level, upright
from facescript.schedule.score import TimedLine

AXIS = 20
"""Height of the axis, px."""

ROW = 15
"""Height of a row of words, px."""

MOST_ROWS = 3
"""Rows of words; those for which there is no room are left out, and how many stand there is told."""

ENOUGH = 0.5
"""Where there is room for fewer of the words than this, one row of them is as good."""

FREE = 6
"""Pixels between two words."""


@dataclass(frozen=True, slots=True)
class AxisStrip:
    """The time axis."""

    fixed: float = AXIS
    weight: float = 0.0

    def marks(self, scale: Scale, top: float, height: float) -> Iterator[Mark]:
        ticks = scale.ticks()
        unit = "time, min:s" if ":" in ticks[0][1] else "time, s"
        yield level(scale.left, scale.right, top, GREY)
        yield Text(scale.left - 20, top + 14, unit, SMALL, "end", GREY)
        for time, label in ticks:
            yield upright(scale.x(time), top, top + 4, GREY)
            yield Text(scale.x(time), top + 14, label, SMALL, "middle", GREY)


@dataclass(frozen=True, slots=True)
class WordStrip:
    """Words at their places: x in px, their row, their text; `count` are all that are spoken in the stretch."""

    words: tuple[tuple[float, int, str], ...]
    count: int
    weight: float = 0.0

    @property
    def fixed(self) -> float:
        thinned = 1 if len(self.words) < self.count else 0
        return ROW * (1 + max([thinned, *(row for _, row, _ in self.words)])) + 4

    def marks(self, scale: Scale, top: float, height: float) -> Iterator[Mark]:
        """Each word begins where it is spoken, or at the right edge ends there."""
        yield Text(scale.left - 8, top + 11, "words", SMALL, "end", GREY)
        if len(self.words) < self.count:
            yield Text(scale.left - 8, top + 11 + ROW, f"{len(self.words)} of {self.count}", SMALL, "end", GREY)
        for x, row, text in self.words:
            yield Text(x, top + 11 + row * ROW, text, SMALL, "start", INK)


def word_strip(lines: Sequence[TimedLine], scale: Scale) -> WordStrip | None:
    """The words of a face's lines in the stretch; None where nothing is said."""
    spoken = sorted(
        (line.start + word.start, word.text)
        for line in lines
        for word in line.spoken.words
        if line.start + word.start < line.end and scale.shows(line.start + word.start, line.start + word.end)
    )
    placed = tuple(_placed(spoken, scale, MOST_ROWS))
    if len(placed) < ENOUGH * len(spoken):
        placed = tuple(_placed(spoken, scale, 1))
    return WordStrip(placed, len(spoken)) if spoken else None


def _placed(spoken: Sequence[tuple[float, str]], scale: Scale, rows: int) -> Iterator[tuple[float, int, str]]:
    """The words that find room in so many rows, each in the first that is free."""
    free = [scale.left] * rows
    for time, text in spoken:
        long = width(text, SMALL)
        x = min(scale.x(time), scale.right - long)
        row = next((row for row, until in enumerate(free) if until <= x), None)
        if row is not None:
            free[row] = x + long + FREE
            yield x, row, text
