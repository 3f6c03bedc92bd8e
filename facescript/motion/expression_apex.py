"""Turns what a spontaneous show or add asks into an apex that is smaller, and lives: a slow and irregular ripple."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facescript.motion.dice import Dice
from facescript.motion.drivers import Floats
from facescript.performance.easing import smooth

SMALLER = 0.8
"""What a spontaneous expression shows of what is asked: at the same request it is smaller than a posed one
(motion.md 6.1 and bar E1 give the direction; the size is ours)."""

RIPPLE = 0.06
"""How far its apex rises and sinks at most, as a part of it (its apex is "more irregular", motion.md 6.1; the size is
ours)."""

WAVES = ((0.9, 0.7), (0.37, 0.3))
"""Seconds between the knots of the ripple's noise and their share of it: slower than the onset."""


@dataclass(frozen=True, slots=True)
class Ripple:
    """The part of its apex that an expression gains or loses from `start` (s) on: 0 until then, continuous in speed,
    the same on both sides of the face (asymmetry does not differ, motion.md 6.1). Its knots are hashed one by one."""

    start: float
    dice: Dice

    def at(self, times: Floats) -> Floats:
        """Parts of the apex at `times` (s), within `RIPPLE` of 0."""
        waves = (share * self._wave(times, spacing) for spacing, share in WAVES)
        return RIPPLE * sum(waves, np.zeros_like(times))

    def _wave(self, times: Floats, spacing: float) -> Floats:
        """Noise in -1..1, minimum jerk between knots, the first of which is 0."""
        place = np.maximum((times - self.start) / spacing, 0.0)
        which = place.astype(np.int64)
        first = int(which.min())
        knots = np.array([self._knot(spacing, index) for index in range(first, int(which.max()) + 2)])
        before, after = knots[which - first], knots[which - first + 1]
        wave: Floats = before + (after - before) * smooth(place - which)
        return wave

    def _knot(self, spacing: float, index: int) -> float:
        return self.dice.between(-1.0, 1.0, "ripple", index, f"{spacing}") if index else 0.0
