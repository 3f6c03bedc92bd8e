"""Outlines over time to how deep places lie inside of them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]

PARTS = 3
"""Straight pieces that stand for a cubic."""

AT_ONCE = 400_000
"""Pairs of a place and a piece looked at in one go: they stay in the processor's own cache."""

T = np.arange(PARTS) / PARTS
BERNSTEIN = np.stack([(1 - T) ** 3, 3 * T * (1 - T) ** 2, 3 * T**2 * (1 - T), T**3], axis=1)


def depths(places: Floats, outlines: Floats) -> Floats:
    """How far (px) places array[moment, place, xy] lie inside of a contour of cubics array[moment, point, xy]; outside
    it is negative. Cubics count as PARTS straight pieces."""
    corners = traced(outlines).astype(np.float32)
    found = np.empty(places.shape[:2])
    step = max(1, AT_ONCE // (places.shape[1] * corners.shape[1]))
    for first in range(0, len(places), step):
        some = slice(first, first + step)
        found[some] = _depths(places[some].astype(np.float32), corners[some])
    return found


def traced(outlines: Floats) -> Floats:
    """Places along a contour of cubics array[moment, point, xy], PARTS a cubic: array[moment, place, xy]."""
    segments = (outlines.shape[1] - 1) // 3
    pieces = np.stack([outlines[:, part : part + 3 * segments : 3] for part in range(4)], axis=2)
    corners: Floats = np.matmul(BERNSTEIN, pieces).reshape(len(outlines), segments * PARTS, 2)
    return corners


def _depths(places: Singles, corners: Singles) -> Singles:
    ends = np.roll(corners, -1, axis=1)
    way_x, way_y = ((ends - corners)[:, None, :, axis] for axis in (0, 1))
    from_x, from_y = (places[:, :, None, axis] - corners[:, None, :, axis] for axis in (0, 1))
    part = (from_x * way_x + from_y * way_y) / np.maximum(way_x * way_x + way_y * way_y, 1e-9)
    np.clip(part, 0, 1, out=part)
    nearest = ((from_x - part * way_x) ** 2 + (from_y - part * way_y) ** 2).min(axis=2)
    between = (corners[:, None, :, 1] > places[:, :, None, 1]) != (ends[:, None, :, 1] > places[:, :, None, 1])
    crossed = between & ((from_x * way_y < way_x * from_y) == (way_y > 0))
    inside = crossed.sum(axis=2) % 2 == 1
    deep: Singles = np.sqrt(nearest)
    return np.where(inside, deep, -deep)
