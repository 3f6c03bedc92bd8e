"""Heads, one moment after another, to how hair trails behind them: the springs of `motion.hair` without a grid.

A film knows how the head will move, and runs the springs once over it. A run does not, and what it shows may change
at any frame; so here they take the step that has passed since the last one.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.motion.hair import RATES, SPRINGS, aside, seen
from facescript.performance.channels import HAIR, INDEX

Floats = NDArray[np.float64]

HEAD = [INDEX[f"head.{name}"] for name in ("yaw", "pitch", "roll", "x", "y")]

LONGEST = 0.1
"""Seconds: after a longer pause hair hangs at rest, as nobody saw it move."""


class Trail:
    """The hair of one face, which hangs at rest at first."""

    def __init__(self) -> None:
        self._at, self._place = -np.inf, np.zeros(2)
        self._speed: Floats | None = None
        self._state = np.zeros((len(RATES), 2), dtype=np.complex128)

    def follow(self, pose: Floats, time: float) -> None:
        """Sets the channels `HAIR` of a pose (array[channel]) at a time, s, later than the last one."""
        place, passed = aside(pose[None, HEAD])[0], time - self._at
        if 0.0 < passed <= LONGEST:
            speed = (place - self._place) / passed
            push = 0.0 if self._speed is None else speed - self._speed
            self._state = self._state * np.exp(SPRINGS * passed)[:, None] - push
            self._speed = speed
        else:
            self._speed, self._state = None, np.zeros_like(self._state)
        self._at, self._place = time, place
        pose[-len(HAIR) :] = seen(self._state[None], np.zeros(1))[0]
