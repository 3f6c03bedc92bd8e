"""Frames of a face's points to a mean and few ways of moving, of which each frame is a sum within a part of a pixel.

A face's thousands of points move together: some forty ways of moving, weighed anew in each frame, give all of them.
The ways are found as the film is gone through, so that its length does not matter: what a stretch has and none before
it had is added to them.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

OFF = 0.35
"""Pixels by which a point that is seen may be off before the numbers are rounded."""

WEIGHT = 1 / 32
"""Pixels: the step of a weight, which is how far it moves the point that it moves farthest."""

FINE = 1 / 40
"""Pixels: as far as the step of a way of moving moves a point at its greatest weight."""

PLACE = 1 / 64
"""Pixels: the step of a point's mean place."""

MOST_WAYS, LEAST_WAYS = 32, 4
"""Ways of moving added before all is looked at again."""

MOST_FRAMES = 240
"""Frames that new ways of moving are found in, at most."""


class Basis:
    """The mean places and the ways of moving of points, found in the frames it is asked the weights of."""

    def __init__(self, sample: Floats, seen: Floats) -> None:
        """`sample` is array[frame, point, xy] of frames from all over the film; `seen` as in `weights`."""
        flat = _flat(sample)
        self.mean: Ints = np.rint(flat.mean(axis=0) / PLACE).astype(np.int64)
        self._fit = np.zeros((0, flat.shape[1]))
        self._reach = np.zeros(0)
        self._most = np.zeros(0)
        self.weights(sample, seen)

    def __len__(self) -> int:
        """How many ways of moving there are."""
        return len(self._fit)

    def weights(self, points: Floats, seen: Floats) -> Ints:
        """The weights array[frame, way] of frames array[frame, point, xy], in steps; new ways are added until all
        that is seen is near enough. `seen` is by how much each point is enlarged, array[frame, point]."""
        moved = _flat(points) - self.mean * PLACE
        weights = moved @ self._fit.T
        rest = moved - weights @ self._fit
        while len(bad := _far(rest, seen)):
            fresh = self._grown(rest[bad])
            more = rest @ fresh.T
            rest -= more @ fresh
            weights = np.concatenate([weights, more], axis=1)
        pixels = weights * self._reach
        self._most = np.maximum(self._most, np.abs(pixels).max(axis=0, initial=0.0))
        return np.rint(pixels / WEIGHT).astype(np.int64)

    def ways(self) -> tuple[Ints, Floats]:
        """The ways of moving in whole steps, array[way, 2 * point] (all x, then all y), and each one's step in pixels
        for one step of weight; the last of all to be asked for."""
        steps = FINE / np.maximum(self._most, 1.0)
        ways = np.rint(self._fit / self._reach[:, None] / steps[:, None]).astype(np.int64)
        return ways, steps * WEIGHT

    def moves(self, first: int) -> Floats:
        """The ways from `first` on as they are, array[way, 2 * point]: pixels for one step of weight. They stay."""
        return self._fit[first:] / self._reach[first:, None] * WEIGHT

    def points(self, weights: Ints) -> Floats:
        """The points array[frame, point, xy] that a page makes of weights."""
        ways, steps = self.ways()
        flat = self.mean * PLACE + weights * steps[: weights.shape[1]] @ ways[: weights.shape[1]]
        return flat.reshape(len(weights), 2, -1).transpose(0, 2, 1)

    def _grown(self, rest: Floats) -> Floats:
        """Add the ways in which what is left of some frames moves most; they are square to those there are."""
        some = rest[np.unique(np.linspace(0, len(rest) - 1, MOST_FRAMES).astype(np.intp))]
        _, axes = np.linalg.eigh(some @ some.T)
        found = axes[:, : -MOST_WAYS - 1 : -1].T @ some
        moving = np.abs(found).max(axis=1) * np.abs(axes[:, : -MOST_WAYS - 1 : -1]).max(axis=0)
        found = np.linalg.qr(found[: max(LEAST_WAYS, int((moving > OFF).sum()))].T)[0].T
        reach = np.abs(found).max(axis=1)
        self._fit = np.concatenate([self._fit, found])
        self._reach = np.concatenate([self._reach, reach])
        self._most = np.pad(self._most, (0, len(found)))
        return found


def _flat(points: Floats) -> Floats:
    """Frames as rows: all x, then all y."""
    return points.transpose(0, 2, 1).reshape(len(points), -1)


def _far(rest: Floats, seen: Floats) -> NDArray[np.intp]:
    """The frames in which something seen is off by too much."""
    count = seen.shape[1]
    off = np.hypot(rest[:, :count], rest[:, count:])
    return np.flatnonzero((off * seen).max(axis=1, initial=0.0) > OFF)
