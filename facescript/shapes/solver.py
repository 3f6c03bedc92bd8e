"""Rows of a table of shapes to the matrix that makes shapes of channels, and to what finds channels for shapes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.shapes.rows import terms

Floats = NDArray[np.float64]

ROUNDS = 40
"""Steps of the search for what lies within limits; most frames need none."""


def matrix(made: Iterable[str], columns: Sequence[str]) -> Floats:
    """The factors of rows in the order of `columns`: array[row, column]."""
    index = {name: number for number, name in enumerate(columns)}
    texts = tuple(made)
    found = np.zeros((len(texts), len(columns)))
    for row, text in enumerate(texts):
        for name, factor in terms(text).items():
            found[row, index[name]] = factor
    return found


class Solver:
    """What makes given shapes: `x` within `low` and `high`, with `factors` array[shape, column], so that x times the
    factors is as near to the shapes as may be (least squares). Of several it is the smallest, as the pseudo-inverse has
    it; where that leaves the limits, projected gradients go on from its nearest point within.
    """

    def __init__(self, factors: Floats, low: Floats, high: Floats) -> None:
        """Columns are weighed by how much they do, so that a degree and a share are alike."""
        norm = np.linalg.norm(factors, axis=0)
        self.scale = np.where(norm > 0.0, 1.0 / np.where(norm > 0.0, norm, 1.0), 0.0)
        scaled = factors * self.scale
        self.inverse = np.linalg.pinv(scaled)
        self.scaled, self.gram = scaled, scaled.T @ scaled
        self.step = 1.0 / max(float(np.linalg.eigvalsh(self.gram)[-1]), 1e-12)
        self.low, self.high = low / np.where(norm > 0.0, self.scale, 1.0), high / np.where(norm > 0.0, self.scale, 1.0)

    def __call__(self, shapes: Floats) -> Floats:
        """array[n, shape] to array[n, column], a function of each row alone."""
        free = shapes @ self.inverse.T
        found = np.clip(free, self.low, self.high)
        beyond = np.any(np.abs(found - free) > 1e-12, axis=1)
        if np.any(beyond):
            found[beyond] = self._within(shapes[beyond] @ self.scaled, found[beyond])
        return found * self.scale

    def _within(self, wanted: Floats, found: Floats) -> Floats:
        """Projected gradients with Nesterov's momentum (Beck and Teboulle 2009)."""
        ahead, pace = found, 1.0
        for _ in range(ROUNDS):
            after = np.clip(ahead - self.step * (ahead @ self.gram - wanted), self.low, self.high)
            faster = (1.0 + math.sqrt(1.0 + 4.0 * pace * pace)) / 2.0
            ahead = after + (pace - 1.0) / faster * (after - found)
            found, pace = after, faster
        return found
