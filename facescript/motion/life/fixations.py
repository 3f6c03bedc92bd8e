"""Turns fixations about the target into the line of sight that jumps between them and drifts in each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facescript.motion.drivers import Floats
from facescript.motion.gaze.curves import saccade_curve
from facescript.performance.easing import smooth
from facescript.space.main_sequence import saccade_time

Offset = tuple[float, float]
"""Where the line of sight is beside the target, deg: yaw (+ the viewer's right) and pitch (+ up)."""

TARGET: Offset = (0.0, 0.0)
"""The target itself."""


@dataclass(frozen=True, slots=True)
class Fixation:
    """A saccade that sets off at `onset` (s) to `landed`; from there the eyes drift to `left` until `end`."""

    onset: float
    landed: Offset
    left: Offset
    end: float


def fixation(onset: float, place: Offset) -> Fixation:
    """One without drift."""
    return Fixation(onset, place, place, onset)


def jump_time(here: Offset, there: Offset) -> float:
    """Seconds that a saccade takes (bar S1), in whole milliseconds, so that few are of one length each."""
    return round(1000.0 * saccade_time(float(np.hypot(there[0] - here[0], there[1] - here[1])))) / 1000.0


@dataclass(frozen=True, slots=True)
class Fixations:
    """One axis of fixations in time order, deg; the target before the first. No saccade begins in another.

    `onsets`, `lengths`, `before`, `landed`, `left` and `ends` have one value a fixation: when its saccade sets off and
    how long it takes, from where it comes and where it lands; where and when its drift ends.
    """

    onsets: Floats
    lengths: Floats
    before: Floats
    landed: Floats
    left: Floats
    ends: Floats

    def at(self, times: Floats) -> Floats:
        which = np.searchsorted(self.onsets, times, side="right") - 1
        values = np.zeros_like(times)
        begun = np.flatnonzero(which >= 0)
        if not len(begun):
            return values
        which, since = which[begun], times[begun] - self.onsets[which[begun]]
        lengths, landed = self.lengths[which], self.landed[which]
        stay = np.maximum(self.ends[which] - self.onsets[which] - lengths, 1e-9)
        rested = landed + (self.left[which] - landed) * smooth((since - lengths) / stay)
        flying = np.flatnonzero(since < lengths)
        before = self.before[which[flying]]
        rested[flying] = before + (landed[flying] - before) * _flown(since[flying], lengths[flying])
        values[begun] = rested
        return values


def _flown(since: Floats, lengths: Floats) -> Floats:
    """How far saccades are `since` seconds after they set off: the profile of each length (bars S4, S6)."""
    part = np.empty_like(since)
    for length in np.unique(lengths):
        alike = lengths == length
        part[alike] = saccade_curve(since[alike], 0.0, float(length))
    return part


def line_of_sight(found: Sequence[Fixation]) -> tuple[Fixations, Fixations]:
    """Both axes of `found`."""
    onsets = np.array([item.onset for item in found])
    places = [TARGET, *(item.left for item in found)]
    lengths = np.array([jump_time(here, item.landed) for here, item in zip(places, found, strict=False)])
    ends = np.array([item.end for item in found])

    def axis(number: int) -> Fixations:
        left = np.array([place[number] for place in places])
        landed = np.array([item.landed[number] for item in found])
        return Fixations(onsets, lengths, left[:-1], landed, left[1:], ends)

    return axis(0), axis(1)
