"""Outlines of a drawn picture as polygons, for the rig's tests."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.picture import Picture

Floats = NDArray[np.float64]


def anchors(rig: CartoonRig, picture: Picture, shape: str, loop: int = 0) -> Floats:
    """A contour's anchors without the repeated last one: array[frame, anchor, 2]."""
    contour = next(one for one in rig.shapes if one.id == shape).contours[loop]
    return picture.points[:, contour.first : contour.first + contour.count : 3][:, :-1]


def polygon(rig: CartoonRig, picture: Picture, shape: str, loop: int = 0, steps: int = 12) -> Floats:
    """A contour, flattened: array[frame, point, 2]."""
    contour = next(one for one in rig.shapes if one.id == shape).contours[loop]
    points = picture.points[:, contour.first : contour.first + contour.count]
    t = np.linspace(0, 1, steps, endpoint=False)[:, None]
    a, b, c, d = (points[:, k : len(points[0]) - 3 + k : 3, None, :] for k in range(4))
    curve: Floats = (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d
    return curve.reshape(len(points), -1, 2)


def area(outline: Floats) -> Floats:
    """Area of polygons array[frame, point, 2], px^2."""
    x, y = outline[..., 0], outline[..., 1]
    doubled: Floats = (x * np.roll(y, -1, axis=-1) - y * np.roll(x, -1, axis=-1)).sum(axis=-1)
    return np.abs(doubled) / 2


def inside(point: Floats, outline: Floats) -> bool:
    """Whether a point lies in a polygon array[point, 2] (even-odd)."""
    x, y = outline.T
    next_x, next_y = np.roll(x, -1), np.roll(y, -1)
    crosses = (y > point[1]) != (next_y > point[1])
    with np.errstate(divide="ignore", invalid="ignore"):
        at = x + (point[1] - y) / (next_y - y) * (next_x - x)
    return bool((crosses & (point[0] < at)).sum() % 2)
