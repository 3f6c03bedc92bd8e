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


def outside(points: Floats, outline: Floats) -> float:
    """How far (px) the farthest of points array[n, 2] lies outside a polygon array[point, 2]; 0 if all are inside."""
    return max((_distance(point, outline) for point in points if not inside(point, outline)), default=0.0)


def _distance(point: Floats, outline: Floats) -> float:
    along = np.roll(outline, -1, axis=0) - outline
    length = np.maximum((along**2).sum(axis=1), 1e-12)
    t = np.clip(((point - outline) * along).sum(axis=1) / length, 0, 1)
    return float(np.hypot(*(point - outline - t[:, None] * along).T).min())


def folded(outline: Floats) -> float:
    """Area (px^2) of the largest loop where a polygon array[point, 2] crosses itself; 0 if it does not."""
    along = np.roll(outline, -1, axis=0) - outline
    gap = outline[None] - outline[:, None]
    across = _cross(along[:, None], along[None])
    with np.errstate(divide="ignore", invalid="ignore"):
        here, there = _cross(gap, along[None]) / across, _cross(gap, along[:, None]) / across
    hit = np.triu((here > 0) & (here < 1) & (there > 0) & (there < 1), 2)
    largest = 0.0
    for i, j in np.argwhere(hit):
        meeting = outline[i] + here[i, j] * along[i]
        loops = (outline[i + 1 : j + 1], np.concatenate([outline[j + 1 :], outline[: i + 1]]))
        largest = max(largest, min(float(area(np.vstack([meeting, loop]))) for loop in loops))
    return largest


def _cross(a: Floats, b: Floats) -> Floats:
    out: Floats = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return out
