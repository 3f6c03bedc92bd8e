"""A head over time to how its hair trails behind: damped springs, run once on a fixed grid in blocks.

A lock hangs on the head by a spring. With u how far it trails, u'' + 2 d w u' + w^2 u = -a, a the head's acceleration
(w = 2 pi times `RATES`, d = `DAMPING`). The head is taken as straight between the moments of the grid, so that a is a
push at each of them and the lock swings freely in between: that is solved exactly. With s = -d w + i w sqrt(1 - d^2),
the number z = (u' - Re(s) u) + i Im(s) u is multiplied by exp(s t) in a time t, and a push is added to it.

A block is run from rest at the start of the block before it, of which nothing is left then but 1e-11 of a degree. So
what comes out is a function of time: it does not matter what was asked for before, and in which order.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import accumulate
from math import inf, nextafter, pi, sqrt

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import HAIR

Floats = NDArray[np.float64]
States = NDArray[np.complex128]
Heads = Callable[[Floats], Floats]
"""Times (s, sorted) to the head as it is drawn: array[n, 5], yaw, pitch, roll (deg), x, y (cm)."""

STEP = 1.0 / 120.0
"""The grid, s."""

BLOCK = 1200
"""Steps of a block: ten seconds, in which the slowest lock comes to rest."""

KEPT = 4
"""Blocks that are kept."""

RATES = (1.5, 2.4, 3.4)
"""How often slow, middle and quick locks would swing, Hz."""

DAMPING = 0.3
"""Of each lock, as a share of the damping at which it would not swing."""

ROLL = 0.5
"""How much a tilt of the head counts beside a turn: it takes the roots along less."""

SHIFT = 7.6
"""Degrees of turn that a shift of 1 cm is like, at 1.2 eye distances from the neck's axis."""

MOST = 10.0
"""A lock trails less than this, deg, whatever the head does: a cut or a jump of the head does not fling it."""

LEAST = 0.3
"""By so much, deg, a lock trails less: what is not more than half a pixel at a tip is none, and costs no key frame."""

SPRINGS: States = np.array([2.0 * pi * rate * complex(-DAMPING, sqrt(1.0 - DAMPING * DAMPING)) for rate in RATES])
"""What z turns with and dies away by, 1/s, for slow, middle and quick locks."""

_TURNS: list[complex] = np.exp(SPRINGS * STEP).tolist()


class Hair:
    """The hair of one face. It hangs at rest where one of `scenes` (start, end in seconds, in order) begins, and where
    the face is in none."""

    def __init__(self, heads: Heads, scenes: Sequence[tuple[float, float]]) -> None:
        self._heads = heads
        self._scenes = tuple(scenes)
        self._block = lru_cache(maxsize=KEPT)(self._run)

    def sample(self, times: Floats) -> Floats:
        """The channels `HAIR` at `times` (s, any order): array[n, 6], deg."""
        out = np.zeros((len(times), len(HAIR)))
        for number, (start, end) in enumerate(self._scenes):
            here = np.flatnonzero((times >= start) & (times < end))
            steps = np.floor((times[here] - start) / STEP).astype(np.int64)
            for block in np.unique(steps // BLOCK).tolist():
                rows = steps // BLOCK == block
                states = self._block(number, block)[steps[rows] - block * BLOCK]
                out[here[rows]] = seen(states, times[here[rows]] - start - steps[rows] * STEP)
        return out

    def _run(self, number: int, block: int) -> States:
        """The states z at the moments of a block of a scene: array[BLOCK, lock, axis]."""
        start, end = self._scenes[number]
        first = max(0, block - 1) * BLOCK
        times = start + np.arange(first, (block + 1) * BLOCK + 1) * STEP
        last = nextafter(end, -inf)
        pushes = _pushes(self._heads(np.minimum(times, last)))
        states = np.empty((len(pushes), len(RATES), 2), dtype=np.complex128)
        for axis in range(2):
            for lock, turn in enumerate(_TURNS):
                states[:, lock, axis] = _swung(pushes[:, axis].tolist(), turn)
        return states[-BLOCK:]


def _pushes(heads: Floats) -> Floats:
    """What each moment but the last pushes the locks by, array[n, axis], deg/s; at the first they are at rest."""
    speeds = np.diff(aside(heads), axis=0) / STEP
    return -np.diff(speeds, axis=0, prepend=speeds[:1])


def aside(heads: Floats) -> Floats:
    """How far heads array[n, 5] take their roots along, to the side and up: array[n, axis], deg of a turn."""
    sideways = heads[:, 0] + ROLL * heads[:, 2] + SHIFT * heads[:, 3]
    return np.stack([sideways, heads[:, 1] + SHIFT * heads[:, 4]], axis=1)


def _swung(pushes: list[float], turn: complex) -> list[complex]:
    """The state after each push."""
    return list(accumulate(pushes, lambda state, push: state * turn + push, initial=0j))[1:]


def seen(states: States, later: Floats) -> Floats:
    """How far locks trail `later` seconds after they were in `states` array[n, lock, axis]: array[n, lock * axis]."""
    swung = states * np.exp(later[:, None] * SPRINGS)[:, :, None]
    trails = MOST * np.tanh(swung.imag / SPRINGS.imag[:, None] / MOST)
    trails -= np.clip(trails, -LEAST, LEAST)
    found: Floats = trails.reshape(len(states), -1)
    return found
