"""Outlines in turned frames to the places of their gradients: the exact boxes of the curves, of all shapes at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.rig.picture import Shape

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Bools = NDArray[np.bool_]

Place = tuple[float, float, float, float, float, float]
"""The first two rows of a matrix that makes px of fractions of a box."""

THIN = 1e-3
"""Px: no box is taken to be narrower."""

FINE = 4096.0
"""Steps of a radian: a gradient turned by less looks the same."""


class Slants:
    """The frames of shapes' gradients, which turn with the head. Those that stand upright need no box from here."""

    def __init__(self, shapes: Sequence[Shape], starts: NDArray[np.intp]) -> None:
        """`starts` are the first points of the shapes in the array of points, contour after contour."""
        self._graded = np.array([not isinstance(shape.fill, str) for shape in shapes], dtype=bool)
        firsts = [_segments(shape, int(start)) for shape, start in zip(shapes, starts, strict=True)]
        self._first = np.concatenate([np.zeros(0, dtype=np.intp), *firsts])
        self._owner = np.repeat(np.arange(len(shapes)), [len(first) for first in firsts])
        self._turns = np.zeros(len(shapes))

    def take(self, turns: Floats) -> Bools:
        """Take a frame's turns, array[shape], radians clockwise; which shapes look other than before."""
        before = self._turns
        self._turns = np.where(self._graded, np.rint(turns * FINE) / FINE, 0.0)
        changed: Bools = self._turns != before
        return changed

    def places(self, points: Singles, due: Bools) -> dict[int, Place]:
        """Where the gradients lie of those shapes that are `due` and do not stand upright; points array[point, 2]."""
        which = np.flatnonzero(due & (self._turns != 0))
        if not len(which):
            return {}
        chosen = np.isin(self._owner, which)
        owner = self._owner[chosen]
        curves = points[self._first[chosen, None] + np.arange(4)].astype(np.float64)
        cos, sin = np.cos(self._turns), np.sin(self._turns)
        ends = [_ends(part) for part in _turned(curves, cos[owner, None], -sin[owner, None])]
        begins = np.flatnonzero(np.diff(owner, prepend=-1))
        low = [np.minimum.reduceat(least, begins) for least, _ in ends]
        size = [
            np.maximum(np.maximum.reduceat(most, begins) - at, THIN) for at, (_, most) in zip(low, ends, strict=True)
        ]
        return dict(zip(which.tolist(), _matrices(low, size, cos[which], sin[which]), strict=True))


def _segments(shape: Shape, start: int) -> NDArray[np.intp]:
    """The first points of a shape's curves."""
    counts = [contour.count for contour in shape.contours]
    begins = np.cumsum([start, *counts[:-1]])
    return np.concatenate([np.arange(at, at + count - 1, 3) for at, count in zip(begins, counts, strict=True)])


def _turned(points: Floats, cos: Floats, sin: Floats) -> tuple[Floats, Floats]:
    """x and y of points array[..., 2], turned clockwise about the origin."""
    x, y = points[..., 0], points[..., 1]
    return x * cos - y * sin, x * sin + y * cos


def _ends(curves: Floats) -> tuple[Floats, Floats]:
    """The least and the most of cubics in one axis, array[curve, 4]."""
    p, q, r, s = curves.T
    cubed, squared, once = s - p + 3 * (q - r), p - 2 * q + r, q - p
    # The slope is none where cubed t t + 2 squared t + once is 0; any other t from 0 to 1 does no harm.
    root = np.sqrt(np.maximum(squared * squared - cubed * once, 0.0))
    both = -(squared + np.copysign(root, squared))
    with np.errstate(divide="ignore", invalid="ignore"):
        times = np.fmin(np.fmax([both / cubed, once / both], 0.0), 1.0)
    between = p + times * (3 * once + times * (3 * squared + times * cubed))
    least = np.minimum(np.minimum(p, s), between.min(axis=0))
    most = np.maximum(np.maximum(p, s), between.max(axis=0))
    return least, most


def _matrices(low: list[Floats], size: list[Floats], cos: Floats, sin: Floats) -> list[Place]:
    """Boxes in frames turned clockwise, as places."""
    (left, top), (wide, high) = low, size
    rows = (cos * wide, -sin * high, cos * left - sin * top, sin * wide, cos * high, sin * left + cos * top)
    return list(zip(*(row.tolist() for row in rows), strict=True))
