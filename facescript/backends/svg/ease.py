"""Numbers over time to few key frames with eased ways between them, none of which leaves a given limit."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache

import numpy as np
from numpy.typing import NDArray

from facescript.backends.svg.limit import Limit, apart
from facescript.backends.svg.track import STRAIGHT

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

GRID = 128
"""Steps at which the eases are known; between them they are read off straight."""

SLOPES = (0.0, 0.3, 0.6, 1.0, 1.5, 2.2, 3.2)
"""How steep an ease may begin and end; 1 is straight."""

PULLS = (0.1, 0.22, 0.35, 0.5, 0.65, 0.8, 1.0)
"""How far along the way its handles lie."""

LOOKS = 12
"""Rows by which an ease is chosen; all rows are held to the tolerance afterwards."""

TRIES = 5
"""The eases that come nearest by those rows and are tried on all."""

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
        is far: what moves a face moves it along straight lines, quicker or slower.
        """
        if not self.times:
            self._set(times[0], np.rint(rows[0]), None)
        at = -1 if self.times[-1] < times[0] else 0
        while at < len(times) - 1:
            at = self._way(times, rows, at, limit)

    def at(self, times: Floats) -> Floats:
        """What is drawn at moments not before the first key frame, array[moment, coordinate]."""
        keys, values = np.array(self.times), np.array(self.values, dtype=np.float64)
        if len(keys) == 1:
            return np.repeat(values, len(times), axis=0)
        way = np.clip(np.searchsorted(keys, times, side="right") - 1, 0, len(keys) - 2)
        span = np.maximum(keys[way + 1] - keys[way], 1e-12)
        part = np.clip((times - keys[way]) / span, 0, 1)
        eases, curves = _eases()
        number = np.array([eases.index(ease) for ease in self.eases])
        drawn = _read(curves, part)[number[way], np.arange(len(times))]
        return np.asarray(values[way] + (values[way + 1] - values[way]) * drawn[:, None])

    def _way(self, times: Floats, rows: Floats, at: int, limit: Limit) -> int:
        """One way from the last key frame, `at` being its row; gives the row it ends at."""
        start, anchor = self.times[-1], self.values[-1].astype(np.float64)
        good, bad, step = at + 1, len(times), 1
        found = STRAIGHT, np.rint(rows[good] - anchor)
        while good + step < bad:
            way = slice(at + 1, good + step + 1)
            fit = _fit(times[way] - start, rows, way, anchor, limit)
            if fit is None:
                bad = good + step
                step = max(1, step // 2)
            else:
                good, found = good + step, fit
                step = step * 2 if bad == len(times) else max(1, (bad - good) // 2)
        self._set(times[good], anchor + found[1], found[0])
        return good

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


def _fit(times: Floats, rows: Floats, way: slice, anchor: Floats, limit: Limit) -> tuple[Spline, Floats] | None:
    """The ease, and the step in whole units, of one way from `anchor` that keeps to the limit; None where none does.

    The end is what fits all rows best and not just the last: that makes ways longer at the same limit.
    """
    away = rows[way] - anchor
    goal = away[-1]
    length = goal @ goal
    if length < 1:
        still = np.broadcast_to(anchor, away.shape)
        return (STRAIGHT, np.zeros_like(goal)) if limit.holds(way, still) else None
    shares = away @ goal / length
    if apart(away - shares[:, None] * goal) > limit.rough:
        return None
    eases, curves = _eases()
    along = times / times[-1]
    some = np.unique(np.linspace(0, len(times) - 1, LOOKS).astype(np.intp))
    misses = np.abs(_read(curves, along[some]) - shares[some]).max(axis=1)
    for number in np.argpartition(misses, TRIES)[:TRIES]:
        course = _read(curves[number : number + 1], along)[0]
        step = np.rint(course @ away / (course @ course))
        if limit.holds(way, anchor + course[:, None] * step):
            return eases[number], step
    return None


def _read(curves: Floats, along: Floats) -> Floats:
    """All eases at parts of the way, array[ease, moment]."""
    place = along * GRID
    below = np.minimum(place.astype(np.intp), GRID - 1)
    part = place - below
    return np.asarray(curves[:, below] * (1 - part) + curves[:, below + 1] * part)


@cache
def _eases() -> tuple[tuple[Spline, ...], Floats]:
    """The eases tried, straight first, and their courses, array[ease, GRID + 1]."""
    tried: dict[Spline, None] = {STRAIGHT: None}
    for first in SLOPES:
        for last in SLOPES:
            for pull in PULLS:
                for push in PULLS:
                    handles = (pull, pull * first, 1 - push, 1 - push * last)
                    if all(0 <= value <= 1 for value in handles):
                        x1, y1, x2, y2 = (round(value, 1) for value in handles)
                        tried[x1, y1, x2, y2] = None
    return tuple(tried), np.array([_course(ease) for ease in tried])


def _course(ease: Spline) -> Floats:
    """A cubic Bezier's height at even steps of its way, as SMIL defines it (keySplines)."""
    t = np.linspace(0.0, 1.0, 2001)
    x1, y1, x2, y2 = ease
    along = 3 * t * (1 - t) ** 2 * x1 + 3 * t**2 * (1 - t) * x2 + t**3
    height = 3 * t * (1 - t) ** 2 * y1 + 3 * t**2 * (1 - t) * y2 + t**3
    return np.interp(np.linspace(0.0, 1.0, GRID + 1), along, height)
