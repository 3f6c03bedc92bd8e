"""A fill to what it means for its edge: how opaque it is there, and how far its box may be off without being seen."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.rig.picture import Linear, Paint, Stop

Floats = NDArray[np.float64]

LEVELS = 2.0
"""Of 255: by how much a pixel's colour may change when a gradient stretches with its box."""


def opaque(fill: Paint) -> bool:
    """Whether nothing shows through a fill."""
    return isinstance(fill, str) or all(stop.opacity == 1 for stop in fill.stops)


def edge_opacity(fill: Paint, where: Floats, low: Floats, high: Floats) -> Floats:
    """How opaque a fill is at places array[moment, place, xy] of boxes from `low` to `high`, array[moment, xy]."""
    if opaque(fill) or isinstance(fill, str):
        return np.ones(where.shape[:2])
    part = (where - low[:, None]) / np.maximum(high - low, 1e-9)[:, None]
    if isinstance(fill, Linear):
        start, way = np.array(fill.start), np.subtract(fill.end, fill.start)
        along = (part - start) @ way / (way @ way)
    else:
        along = np.linalg.norm(part - np.array(fill.centre), axis=2) / fill.radius
    opacities: Floats = np.interp(along, [stop.offset for stop in fill.stops], [stop.opacity for stop in fill.stops])
    return opacities


def most_stretch(fill: Paint, extent: Floats) -> Floats:
    """Pixels by which one side of a fill's box, `extent` long, may be off."""
    if isinstance(fill, str):
        return np.full(len(extent), np.inf)
    colours = np.array([_levels(stop) for stop in fill.stops])
    contrast = np.ptp(colours, axis=0).max()
    return extent * LEVELS / max(float(contrast), 1e-9)


def _levels(stop: Stop) -> list[float]:
    """A stop's red, green, blue and opacity, 0..255."""
    return [*(float(int(stop.colour[at : at + 2], 16)) for at in (1, 3, 5)), 255 * stop.opacity]
