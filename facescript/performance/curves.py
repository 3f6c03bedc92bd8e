"""The shapes a channel takes over time, each a pure function from seconds to values."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.performance.easing import Easing, smooth

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Ramp:
    """From exactly 0 at `start` to exactly 1 at `end` (seconds); a step where they are the same."""

    start: float
    end: float
    ease: Easing = smooth

    def at(self, times: Floats) -> Floats:
        if self.end <= self.start:
            return (times >= self.start).astype(np.float64)
        return self.ease((times - self.start) / (self.end - self.start))


@dataclass(frozen=True, slots=True)
class Pulses:
    """Movements there and back: `heights * profile` over `lengths` seconds from `starts`, else 0.

    They are sorted and do not overlap; `profile` takes the share of the length and is 0 at both ends.
    """

    starts: Floats
    lengths: Floats
    heights: Floats
    profile: Easing

    def at(self, times: Floats) -> Floats:
        if not len(self.starts):
            return np.zeros_like(times)
        which = np.maximum(np.searchsorted(self.starts, times, side="right") - 1, 0)
        share = (times - self.starts[which]) / self.lengths[which]
        inside = (share > 0.0) & (share < 1.0)
        return np.where(inside, self.heights[which] * self.profile(share), 0.0)


@dataclass(frozen=True, slots=True)
class Steps:
    """Movements from pose to pose: `values[k]` is reached `lengths[k]` seconds after `starts[k]`.

    They are sorted and do not overlap; before the first the pose is 0.
    """

    starts: Floats
    lengths: Floats
    values: Floats
    ease: Easing = smooth

    def at(self, times: Floats) -> Floats:
        if not len(self.starts):
            return np.zeros_like(times)
        which = np.searchsorted(self.starts, times, side="right") - 1
        poses = np.concatenate([[0.0], self.values])
        before, after = poses[np.maximum(which, 0)], poses[which + 1]
        share = (times - self.starts[np.maximum(which, 0)]) / self.lengths[np.maximum(which, 0)]
        pose: Floats = before + (after - before) * self.ease(share)
        return pose


@dataclass(frozen=True, slots=True)
class Wander:
    """Band-limited noise from `start` on: minimum jerk between `knots`, one every `spacing` seconds; 0 before."""

    start: float
    spacing: float
    knots: Floats

    def at(self, times: Floats) -> Floats:
        place = np.clip((times - self.start) / self.spacing, 0.0, len(self.knots) - 1.0)
        which = np.minimum(place.astype(np.int64), len(self.knots) - 2)
        before, after = self.knots[which], self.knots[which + 1]
        drift: Floats = before + (after - before) * smooth(place - which)
        return drift


@dataclass(frozen=True, slots=True)
class Spline:
    """A smooth line near `knots`, one every `spacing` seconds from `start` on (uniform cubic B-spline: its acceleration
    is continuous); 0 from two spacings beyond them."""

    start: float
    spacing: float
    knots: Floats

    def at(self, times: Floats) -> Floats:
        place = np.clip((times - self.start) / self.spacing, -3.0, len(self.knots) + 2.0)
        which = np.floor(place).astype(np.int64)
        x = place - which
        rest = 1.0 - x
        padded = np.concatenate([np.zeros(4), self.knots, np.zeros(5)])
        bells = rest * rest * rest, 4.0 - 3.0 * x * x * (1.0 + rest), 4.0 - 3.0 * rest * rest * (1.0 + x), x * x * x
        line: Floats = sum(bell * padded[which + 3 + step] for step, bell in enumerate(bells)) / 6.0
        return line


Curve = Ramp | Pulses | Steps | Wander | Spline
