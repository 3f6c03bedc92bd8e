"""Lanes of bars to marks: each act a bar with its slopes and its phrase, those that overlap below one another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from facescript.plot.acts import Bar, Lane
from facescript.plot.axis import Scale
from facescript.plot.font import fit, width
from facescript.plot.looks import GREY, INK, tint
from facescript.plot.marks import SMALL, Area, Mark, Text, level

ROW, THICK = 19, 16
"""A row of bars, and a bar in it, px."""

GAP = 5
"""Pixels between lanes."""

MOST_ROWS = 8
"""Rows of one lane; bars for which there is no room are counted beside it."""

NARROW = 2.0
"""A bar is drawn this wide at least, px; several so narrow that stand closer than this are drawn as one."""

LABEL = 4
"""Pixels from a bar's edge to its text."""


@dataclass(frozen=True, slots=True)
class LaneStrip:
    """One lane of the picture."""

    lane: Lane
    rows: tuple[tuple[Bar, ...], ...]
    left_out: int
    weight: float = 0.0

    @property
    def fixed(self) -> float:
        return len(self.rows) * ROW + GAP

    def marks(self, scale: Scale, top: float, height: float) -> Iterator[Mark]:
        """The lane's name and its bars."""
        y = top + GAP / 2
        more = f" (+{self.left_out})" if self.left_out else ""
        yield Text(scale.left - 8, y + 12, self.lane.name + more, SMALL, "end", GREY)
        for row in self.rows:
            for index, bar in enumerate(row):
                free = scale.x(row[index + 1].start) if index + 1 < len(row) else scale.right
                yield from _bar(bar, scale, y, self.lane.colour, free)
            y += ROW
        yield level(scale.left, scale.right, top + self.fixed, "#ececec")


def strip(lane: Lane, scale: Scale) -> LaneStrip | None:
    """A lane's bars in the stretch, in rows; None where there are none."""
    rows: list[list[Bar]] = []
    left_out = 0
    for bar in lane.bars:
        if not (scale.shows(bar.start, bar.end) or scale.start <= bar.start == bar.end <= scale.end):
            continue
        row = next((row for row in rows if _until(row[-1], scale) <= bar.start), None)
        if row is not None:
            row.append(bar)
        elif len(rows) < MOST_ROWS:
            rows.append([bar])
        else:
            left_out += 1
    if not rows:
        return None
    return LaneStrip(lane, tuple(tuple(_merged(row, scale)) for row in rows), left_out)


def _until(bar: Bar, scale: Scale) -> float:
    """When a bar leaves its row to the next; what happens in an instant keeps it for its text."""
    return bar.release if bar.end > bar.start else bar.start + 60 / scale.second


def _merged(row: Sequence[Bar], scale: Scale) -> Iterator[Bar]:
    """The bars, with runs of such as are too narrow to be told apart drawn as one."""
    run: list[Bar] = []
    for bar in row:
        narrow = 0 < (bar.end - bar.start) * scale.second < NARROW
        if run and not (narrow and (bar.start - run[-1].end) * scale.second < NARROW):
            yield _one(run)
            run = []
        if narrow:
            run.append(bar)
        else:
            yield bar
    if run:
        yield _one(run)


def _one(run: Sequence[Bar]) -> Bar:
    if len(run) == 1:
        return run[0]
    start, end = run[0].start, run[-1].end
    return Bar(start, start, end, end, "", f"{len(run)} acts\n{start:.3f} s to {end:.3f} s")


def _bar(bar: Bar, scale: Scale, top: float, colour: str, free: float) -> Iterator[Mark]:
    """The bar, its slopes cut where the stretch begins or ends, and as much of its phrase as there is room for."""
    if bar.start == bar.end:
        yield from _instant(bar, scale, top, colour, free)
        return
    left, right = scale.x(bar.start), max(scale.x(bar.end), scale.x(bar.start) + NARROW)
    bottom = top + THICK
    apex, release = max(scale.x(bar.apex), left), min(max(scale.x(bar.release), scale.x(bar.apex)), right)
    points = ((left, bottom), (apex, top), (max(apex, release), top), (right, bottom))
    yield Area(points, tint(colour, 0.78), tint(colour, 0.35), bar.note)
    yield from _phrase(bar.label, (left, right), (apex, release), free, bottom - 4)


def _phrase(label: str, bar: tuple[float, float], flat: tuple[float, float], free: float, y: float) -> Iterator[Mark]:
    """A bar's text: on its flat top, else near the middle of that, else behind the bar, else as much as fits."""
    left, right = bar
    long, room = width(label, SMALL), right - left - 2 * LABEL
    start = flat[0] + LABEL
    if long + 2 * LABEL > flat[1] - flat[0]:
        start = max(left + LABEL, min(sum(flat) / 2 - long / 2, right - LABEL - long))
    if long > room and room < long / 2 and free - right - 2 * LABEL >= long:
        start, room = right + LABEL, long
    text = fit(label, SMALL, room)
    if text:
        yield Text(start, y, text, SMALL, "start", INK)


def _instant(bar: Bar, scale: Scale, top: float, colour: str, free: float) -> Iterator[Mark]:
    """What happens in no time: a mark, and its text behind it."""
    x, middle = scale.x(bar.start), top + THICK / 2
    yield Area(((x - 4, middle), (x, middle - 5), (x + 4, middle), (x, middle + 5)), colour, colour, bar.note)
    text = fit(bar.label, SMALL, free - x - 3 * LABEL)
    if text:
        yield Text(x + 2 * LABEL, top + THICK - 4, text, SMALL, "start", INK)
