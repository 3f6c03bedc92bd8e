"""Spoken lines to the mouth's channels over time, and to how much speech owns the mouth."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import MOUTH
from facescript.schedule.score import TimedLine
from facescript.speech.mouth.mouthing import (
    DECAY,
    FOLLOWED,
    GAP,
    PAUSE,
    MouthShape,
    arranged,
    breath,
    lead,
    mouth_shapes,
)
from facescript.speech.mouth.visemes import SHAPES, Values

Floats = NDArray[np.float64]

RISE, FALL = 0.12, 0.2
"""Seconds in which speech takes the mouth before its first movement, and gives it back after it has come to rest."""

LET_GO = 0.5
"""A rest as long as this inside speech gives the mouth back."""

WIDE, ROUND = MOUTH.index("wide"), MOUTH.index("round")


class MouthTrack:
    """The mouth of one face over the whole film, a pure function of time.

    Every moment lies on a shape or on the way from one to the next, so that at most two weigh, the second rising by
    a smooth curve as the first falls: their dominances overlap, normalised. Curves have no corner.
    """

    def __init__(self, lines: Sequence[TimedLine]) -> None:
        self.shapes = _with_rests(lines)
        self._on = np.array([shape.on for shape in self.shapes])
        self._off = np.array([shape.off for shape in self.shapes])
        self._values = np.array([values(shape) for shape in self.shapes]).reshape(-1, len(MOUTH))
        self._active = np.array(_active(self.shapes)).reshape(-1, 2)

    def sample(self, times: Floats) -> tuple[Floats, Floats]:
        """At `times` (seconds, any order): array[n, 8] in the order and units of `channels.MOUTH`, and array[n], 0..1,
        how far speech owns the mouth."""
        first, second, share = self.weights(times)
        if not self.shapes:
            return np.zeros((len(times), len(MOUTH))), np.zeros(len(times))
        part = share[:, np.newaxis]
        return (1 - part) * self._values[first] + part * self._values[second], self._activity(times)

    def weights(self, times: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp], Floats]:
        """The two shapes (numbers of `self.shapes`) that weigh at each time, and the second one's weight; the first
        one's is the rest."""
        last = len(self.shapes) - 1
        first = np.clip(np.searchsorted(self._on, times, side="right") - 1, 0, max(last, 0))
        second = np.minimum(first + 1, max(last, 0))
        if last < 1:
            return first, second, np.zeros(len(times))
        way = np.maximum(self._on[second] - self._off[first], 1e-9)
        return first, second, _smooth((times - self._off[first]) / way) * (second > first)

    def _activity(self, times: Floats) -> Floats:
        starts, ends = self._active[:, 0], self._active[:, 1]
        near = np.clip(np.searchsorted(starts, times, side="right") - 1, 0, len(starts) - 1)
        return _smooth((times - starts[near]) / RISE) * (1 - _smooth((times - ends[near]) / FALL))


def values(shape: MouthShape) -> Values:
    """The channels of a shape at its degree, its corners with those of the rounded vowel that it precedes."""
    found = [shape.degree * value for value in SHAPES[shape.name]]
    if shape.follows:
        vowel = SHAPES[shape.follows]
        for index in (WIDE, ROUND):
            found[index] += FOLLOWED * (vowel[index] - found[index])
    opened, wide, rounded, upper, lower, jaw, teeth, tongue = found
    return opened, wide, rounded, upper, lower, jaw, teeth, tongue


def _smooth(share: Floats) -> Floats:
    """0 to 1 without a corner at either end."""
    kept = np.clip(share, 0, 1)
    return kept * kept * (3 - 2 * kept)


def _with_rests(lines: Sequence[TimedLine]) -> tuple[MouthShape, ...]:
    """The shapes of all lines in the film's time, the mouth at rest before, between and after them."""
    found: list[MouthShape] = []
    rested = 0.0
    for line in sorted(lines, key=lambda line: line.start):
        shapes = _in_film(line)
        if not shapes:
            continue
        sounding = [phone for phone in line.spoken.phones if phone.symbol]
        begins = min(line.start + sounding[0].start - lead(sounding[0]), shapes[0].on - 2 * GAP)
        rest = _rest(found, rested, begins, shapes[0].on)
        parted = breath(begins, shapes[0].on, sounding[0]) if rest else []
        found += [*rest, *parted, *shapes]
        rested = max(min(line.start + sounding[-1].end, line.end), shapes[-1].off) + DECAY
    return arranged([*found, MouthShape("rest", rested, rested)] if found else [])


def _rest(before: Sequence[MouthShape], rested: float, begins: float, on: float) -> list[MouthShape]:
    """The rest between the shapes `before`, after which the mouth could be still from `rested` on, and the next shape
    at `on`, for which it begins to move at `begins`."""
    if not before:
        return [MouthShape("rest", begins, begins)]
    if rested <= begins:
        return [MouthShape("rest", rested, begins)]
    middle = (before[-1].off + on) / 2
    return [MouthShape("rest", middle, middle)] if on - before[-1].off >= PAUSE else []


def _in_film(line: TimedLine) -> list[MouthShape]:
    """A line's shapes at their times, from its first sound on; none begins after a cut."""
    limit = line.end
    kept = [s.later(line.start, limit) for s in mouth_shapes(line.spoken.phones) if s.on + line.start < limit]
    moving = [index for index, shape in enumerate(kept) if shape.name != "rest"]
    return kept[moving[0] : moving[-1] + 1] if moving else []


def _active(shapes: Sequence[MouthShape]) -> list[tuple[float, float]]:
    """For each stretch of speech between long rests: when activity begins to rise, and when it begins to fall."""
    rests = [s for s in shapes if s.name == "rest" and (s in (shapes[0], shapes[-1]) or s.off - s.on >= LET_GO)]
    return [(before.off - RISE, after.on) for before, after in pairwise(rests)]
