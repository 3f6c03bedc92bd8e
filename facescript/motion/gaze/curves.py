"""Movements one after another, each blended over the one before, to values at any times."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.space.main_sequence import position_series

Floats = NDArray[np.float64]

Course = Callable[[Floats], Floats]
"""Times (s) to values: array[n] to array[n, k]."""


@dataclass(frozen=True, slots=True)
class Movement:
    """From what was before to `course`, between `onset` and `done` by `weight` (times to 0..1)."""

    onset: float
    done: float
    weight: Callable[[Floats], Floats]
    course: Course


class Blend:
    """A first course and the movements that follow it, in order.

    A movement that is interrupted goes on under the next, whose weight has it wholly replaced when that is done: no
    jump, no jolt, and each lands where it is bound for.
    """

    def __init__(self, first: Course, movements: Sequence[Movement]) -> None:
        self.first, self.movements = first, movements
        self.onsets = np.array([movement.onset for movement in movements])
        self.untils = np.array([movement.done for movement in movements[1:]] + [np.inf] * bool(movements))

    def at(self, times: Floats) -> Floats:
        """The values at `times`, which are sorted: array[n, k]."""
        values = np.array(self.first(times))
        if not len(times):
            return values
        for index in self._shown(times[0], times[-1]):
            low, high = np.searchsorted(times, [self.onsets[index], self.untils[index]])
            self._lay(self.movements[index], times[low:high], values[low:high])
        return values

    def laid(self, time: float) -> list[tuple[int, float]]:
        """The movements that show at `time`, in their order: number, and how far each has replaced what was before."""
        at = np.array([time])
        return [(index, float(self.movements[index].weight(at)[0])) for index in self._shown(time, time)]

    def _shown(self, first: float, last: float) -> list[int]:
        found: list[int] = np.flatnonzero((self.untils > first) & (self.onsets <= last)).tolist()
        return found

    @staticmethod
    def _lay(movement: Movement, times: Floats, values: Floats) -> None:
        weight = movement.weight(times)[:, None]
        values += weight * (movement.course(times) - values)


def saccade_curve(times: Floats, onset: float, done: float) -> Floats:
    """How far a saccade between `onset` and `done` is at `times`, 0..1 (`main_sequence.position_series`)."""
    part = (times >= done).astype(np.float64)
    flying = (times > onset) & (times < done)
    if done > onset and flying.any():
        part[flying] = _flown((times[flying] - onset) / (done - onset), done - onset)
    return part


def _flown(x: Floats, lasts: float) -> Floats:
    """How far a saccade that `lasts` so many seconds is after the parts `x` of it, 0..1."""
    (a, scale, first), (b, _, second) = position_series(lasts)
    early, late = np.minimum(x, 0.5), np.minimum(1.0 - x, 0.5)
    rising = scale * early**a * _polynomial(early, first)
    falling = 1.0 - scale * late**b * _polynomial(late, second)
    return np.where(x <= 0.5, rising, falling)


def _polynomial(x: Floats, terms: Sequence[float]) -> Floats:
    """The series by its powers at once: a saccade has few moments, and each step of Horner's rule would cost as much
    as all of them."""
    powers = x[:, None] ** np.arange(len(terms))
    total: Floats = (powers * np.array(terms)).sum(axis=1)
    return total


def minimum_jerk_curve(times: Floats, onset: float, done: float) -> Floats:
    """How far a minimum-jerk movement between `onset` and `done` is at `times`, 0..1."""
    if done <= onset:
        return (times >= onset).astype(np.float64)
    x = np.clip((times - onset) / (done - onset), 0.0, 1.0)
    return x**3 * (10.0 - 15.0 * x + 6.0 * x * x)


def still(value: Sequence[float]) -> Course:
    """The course that stays at `value`."""
    row = np.array(value, dtype=np.float64)
    return lambda times: np.broadcast_to(row, (len(times), len(row)))


def through(start: float, step: float, values: Floats) -> Course:
    """The smooth course through `values` (array[m, k]) at `start`, `start + step`, ..., still outside."""
    slopes = np.zeros_like(values)
    slopes[1:-1] = (values[2:] - values[:-2]) / 2.0

    def course(times: Floats) -> Floats:
        place = np.clip((times - start) / step, 0.0, len(values) - 1.0)
        index = np.minimum(place.astype(np.int64), len(values) - 2)
        u = (place - index)[:, None]
        low, high = values[index], values[index + 1]
        out: Floats = low + (high - low) * u * u * (3.0 - 2.0 * u)
        out += slopes[index] * u * (1.0 - u) ** 2 - slopes[index + 1] * u * u * (1.0 - u)
        return out

    return course
