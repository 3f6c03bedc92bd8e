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

UNSEEN = np.radians(3.0)
"""A gradient tilted by less is drawn upright, which is faster and looks the same; tilted twice as much it is whole."""

FINE = 4096.0
"""Steps of a radian: a gradient turned by less looks the same."""


class Slants:
    """The frames of shapes' gradients, which turn with the head. Those that stand upright need no box from here."""

    def __init__(self, shapes: Sequence[Shape], starts: NDArray[np.intp]) -> None:
        """`starts` are the first points of the shapes in the array of points, contour after contour."""
        self._graded = np.array([not isinstance(shape.fill, str) for shape in shapes], dtype=bool)
        self._turns = np.zeros(len(shapes))
        filled = np.flatnonzero(self._graded).tolist()
        firsts = [_segments(shapes[number], int(starts[number])) for number in filled]
        self._curves = np.concatenate([np.zeros(0, dtype=np.intp), *firsts])[:, None] + np.arange(4)
        counts = [len(first) for first in firsts]
        self._begins = np.cumsum([0, *counts[:-1]]) if counts else np.zeros(0, dtype=np.intp)
        self._box = np.repeat(np.arange(len(filled)), counts)
        self._owner = np.array(filled, dtype=np.intp)

    def take(self, turns: Floats) -> Bools:
        """Take a frame's turns, array[shape], radians clockwise; which shapes look other than before."""
        before = self._turns
        seen = turns * np.clip(np.abs(turns) / UNSEEN - 1, 0, 1)
        self._turns = np.where(self._graded, np.rint(seen * FINE) / FINE, 0.0)
        changed: Bools = self._turns != before
        return changed

    def places(self, points: Singles, due: Bools) -> dict[int, Place]:
        """Where the gradients lie of those shapes that are `due` and do not stand upright; points array[point, 2]."""
        wanted = (due & (self._turns != 0))[self._owner]
        if not wanted.any():
            return {}
        turns = self._turns[self._owner]
        cos, sin = np.cos(turns), np.sin(turns)
        low, high = self._boxes(points, cos[self._box, None], sin[self._box, None])
        found = _matrices(low, np.maximum(high - low, THIN), cos, sin)
        return {number: found[box] for box, number in enumerate(self._owner.tolist()) if wanted[box]}

    def _boxes(self, points: Singles, cos: Floats, sin: Floats) -> tuple[Floats, Floats]:
        """The corners array[xy, box] of all boxes in their frames, cosine and sine array[curve, 1]."""
        x, y = np.ascontiguousarray(points.T, dtype=np.float64)[:, self._curves]
        turned = np.stack([x * cos + y * sin, y * cos - x * sin])
        begin, one, other, end = turned.transpose(2, 0, 1)
        low = np.minimum.reduceat(np.minimum(begin, end), self._begins, axis=1)
        high = np.maximum.reduceat(np.maximum(begin, end), self._begins, axis=1)
        # Only a curve with a handle outside the box of the joints can go beyond it.
        beyond = (np.minimum(one, other) < low[:, self._box]) | (np.maximum(one, other) > high[:, self._box])
        axis, curve = np.nonzero(beyond)
        least, most = _ends(turned[axis, curve])
        np.minimum.at(low, (axis, self._box[curve]), least)
        np.maximum.at(high, (axis, self._box[curve]), most)
        return low, high


def _segments(shape: Shape, start: int) -> NDArray[np.intp]:
    """The first points of a shape's curves."""
    counts = [contour.count for contour in shape.contours]
    begins = np.cumsum([start, *counts[:-1]])
    return np.concatenate([np.arange(at, at + count - 1, 3) for at, count in zip(begins, counts, strict=True)])


def _ends(curves: Floats) -> tuple[Floats, Floats]:
    """The least and the most of cubics in one axis, array[curve, 4]."""
    begin, one, other, end = curves.T
    cubed, squared, once = end - begin + 3 * (one - other), begin - 2 * one + other, one - begin
    # The slope is none where cubed t t + 2 squared t + once is 0; any other t from 0 to 1 does no harm.
    root = np.sqrt(np.maximum(squared * squared - cubed * once, 0.0))
    both = -(squared + np.copysign(root, squared))
    with np.errstate(divide="ignore", invalid="ignore"):
        times = np.fmin(np.fmax([both / cubed, once / both], 0.0), 1.0)
    between = begin + times * (3 * once + times * (3 * squared + times * cubed))
    return between.min(axis=0), between.max(axis=0)


def _matrices(low: Floats, size: Floats, cos: Floats, sin: Floats) -> list[Place]:
    """Boxes array[xy, box] in frames turned clockwise, as places."""
    (left, top), (wide, high) = low, size
    rows = (cos * wide, -sin * high, cos * left - sin * top, sin * wide, cos * high, sin * left + cos * top)
    return list(zip(*(row.tolist() for row in rows), strict=True))
