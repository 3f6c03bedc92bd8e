"""Numbers over time to few key frames with eased ways between them, none of which leaves a given limit."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from facescript.backends.svg.limit import Limit, apart
from facescript.backends.svg.track import STRAIGHT

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Singles = NDArray[np.float32]

GRID = 128
"""Steps at which the eases are known; between them they are read off straight."""

SLOPES = (0.0, 0.15, 0.3, 0.45, 0.6, 0.8, 1.0, 1.25, 1.5, 1.8, 2.2, 2.7, 3.2, 4.5)
"""How steep an ease may begin and end; 1 is straight."""

PULLS = (0.1, 0.22, 0.35, 0.5, 0.65, 0.8, 1.0)
"""How far along the way its handles lie."""

LOOKS = 12
"""Rows by which an ease is chosen; all rows are held to the tolerance afterwards."""

TRIES = 8
"""The eases that come nearest by those rows and are tried on all."""

LITTLE = 2.0
"""Whole units: where no number has changed by more it is tried first whether all can stand still."""

BACK = (1, 2, 4, 6)
"""By how many moments a way may end sooner for the sake of the next."""

Spline = tuple[float, float, float, float]
"""x1 y1 x2 y2 of a `keySplines` entry, all in 0..1."""


@dataclass(slots=True)
class Keys:
    """The key frames of one outline: times, whole numbers, and the ease of the way to each from the one before."""

    times: list[float] = field(default_factory=list)
    values: list[Ints] = field(default_factory=list)
    eases: list[Spline] = field(default_factory=list)

    def follow(self, times: Floats, rows: Floats, limit: Limit) -> None:
        """Go on through more rows, array[moment, coordinate] with x and y in turn, to the last of them.

        What is drawn keeps to `limit` at every row. A way goes as far as one ease can carry all points at once, which
        is far: what moves a face moves it along straight lines, quicker or slower. It ends a little sooner where the
        next way goes farther from there.
        """
        if not self.times:
            self._set(times[0], np.rint(rows[0]), None)
        road = _Road(times, rows, limit)
        place = _Place(-1 if self.times[-1] < times[0] else 0, self.times[-1], self.values[-1].astype(np.float64))
        way = road.farthest(place)
        while way is not None:
            way, then = road.better(place, way)
            place = road.end(place, way)
            self._set(place.time, place.row, way.ease)
            way = then

    def at(self, times: Floats) -> Floats:
        """What is drawn at moments not before the first key frame, array[moment, coordinate]."""
        keys, values = np.array(self.times), np.array(self.values, dtype=np.float64)
        if len(keys) == 1:
            return np.repeat(values, len(times), axis=0)
        way = np.clip(np.searchsorted(keys, times, side="right") - 1, 0, len(keys) - 2)
        span = np.maximum(keys[way + 1] - keys[way], 1e-12)
        part = np.clip((times - keys[way]) / span, 0, 1)
        drawn = _read(np.array([_numbers()[ease] for ease in self.eases])[way], part)
        return np.asarray(values[way] + (values[way + 1] - values[way]) * drawn[:, None])

    def _set(self, time: float, row: Floats, ease: Spline | None) -> None:
        values = row.astype(np.int64)
        if ease is not None:
            still = len(self.values) > 1 and np.array_equal(self.values[-2], self.values[-1])
            if still and np.array_equal(self.values[-1], values):
                self.times[-1] = time
                return
            self.eases.append(STRAIGHT if np.array_equal(self.values[-1], values) else ease)
        self.times.append(float(time))
        self.values.append(values)


class _Place(NamedTuple):
    """A key frame: the number of its moment (-1: before the first), its time and its row."""

    at: int
    time: float
    row: Floats


class _Way(NamedTuple):
    """A way from a key frame: the number of the moment it ends at, its ease, and its step in whole units."""

    last: int
    ease: Spline
    step: Floats


@dataclass(frozen=True, slots=True)
class _Road:
    """Rows over time, and the ways through them that keep to a limit."""

    times: Floats
    rows: Floats
    limit: Limit

    def end(self, place: _Place, way: _Way) -> _Place:
        return _Place(way.last, float(self.times[way.last]), place.row + way.step)

    def farthest(self, place: _Place, least: int = 0) -> _Way | None:
        """The longest way from a place; None where there are no more moments, or it does not reach `least`."""
        count = len(self.times)
        good, bad, step = max(place.at + 1, least), count, 1
        if good >= count:
            return None
        found = self._way(place, good)
        if found is None:
            if least:
                return None
            found = _Way(good, STRAIGHT, np.rint(self.rows[good] - place.row))
        while good + 1 < bad:
            step = min(step, bad - good - 1)
            longer = self._way(place, good + step)
            if longer is None:
                bad = good + step
                step = max(1, step // 2)
            else:
                good, found = good + step, longer
                step = step * 2 if bad == count else max(1, (bad - good) // 2)
        return found

    def better(self, place: _Place, way: _Way) -> tuple[_Way, _Way | None]:
        """Of a longest way and somewhat shorter ones the one after which the next goes farthest; and that next one."""
        best, then = way, self.farthest(self.end(place, way))
        for back in BACK:
            if then is None or way.last - back <= place.at:
                break
            shorter = self._way(place, way.last - back)
            farther = shorter and self.farthest(self.end(place, shorter), then.last + 1)
            if shorter and farther:
                best, then = shorter, farther
        return best, then

    def _way(self, place: _Place, last: int) -> _Way | None:
        """The way from a place to a moment that keeps to the limit; None where none does.

        Its end is what fits all rows best and not just the last: that makes ways longer at the same limit.
        """
        moments = slice(place.at + 1, last + 1)
        away = self.rows[moments] - place.row
        goal = away[-1]
        reach = self.limit.way(moments, place.row)
        if np.abs(goal).max() <= LITTLE:
            none = np.zeros_like(goal)
            if reach.holds(np.zeros(len(away)), none):
                return _Way(last, STRAIGHT, none)
        length = goal @ goal
        if length < 1:
            return None
        shares = away @ goal / length
        if apart(away - shares[:, None] * goal) > self.limit.rough:
            return None
        along = (self.times[moments] - place.time) / (self.times[last] - place.time)
        for number in _likely(along, shares):
            course = _read(number, along)
            step = np.rint(course @ away / (course @ course))
            if reach.holds(course, step):
                return _Way(last, _eases()[0][number], step)
        return None


def _likely(along: Floats, shares: Floats) -> Ints:
    """The TRIES eases that come nearest to the shares of the way at some of the moments."""
    some = np.arange(LOOKS) * (len(along) - 1) // (LOOKS - 1)
    misses = _eases()[1][np.rint(along[some] * GRID).astype(np.intp)]
    misses -= shares[some, None].astype(np.float32)
    worst = np.maximum(misses.max(axis=0), -misses.min(axis=0))
    return np.argpartition(worst, TRIES)[:TRIES]


def _read(ease: int | Ints, along: Floats) -> Floats:
    """An ease, by its number, or each moment's own, at parts of the way."""
    place = along * GRID
    below = np.minimum(place.astype(np.intp), GRID - 1)
    courses = _eases()[1]
    first = courses[below, ease]
    return np.asarray(first + (courses[below + 1, ease] - first) * (place - below))


@cache
def _numbers() -> dict[Spline, int]:
    return {ease: number for number, ease in enumerate(_eases()[0])}


@cache
def _eases() -> tuple[tuple[Spline, ...], Singles]:
    """The eases tried, straight first, and their courses, array[GRID + 1, ease]."""
    tried: dict[Spline, None] = {STRAIGHT: None}
    for first in SLOPES:
        for last in SLOPES:
            for pull in PULLS:
                for push in PULLS:
                    handles = (pull, pull * first, 1 - push, 1 - push * last)
                    if all(0 <= value <= 1 for value in handles):
                        x1, y1, x2, y2 = (round(value, 1) for value in handles)
                        tried[x1, y1, x2, y2] = None
    return tuple(tried), np.array([_course(ease) for ease in tried], dtype=np.float32).T.copy()


def _course(ease: Spline) -> Floats:
    """A cubic Bezier's height at even steps of its way, as SMIL defines it (keySplines)."""
    t = np.linspace(0.0, 1.0, 2001)
    x1, y1, x2, y2 = ease
    along = 3 * t * (1 - t) ** 2 * x1 + 3 * t**2 * (1 - t) * x2 + t**3
    height = 3 * t * (1 - t) ** 2 * y1 + 3 * t**2 * (1 - t) * y2 + t**3
    return np.interp(np.linspace(0.0, 1.0, GRID + 1), along, height)
