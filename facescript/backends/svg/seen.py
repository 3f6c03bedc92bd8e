"""Frames of shapes to when each can be seen: what is hidden need not be written."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.rig.picture import Shape

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Ints = NDArray[np.int64]

MARGIN = 1.0
"""Pixels by which a shape may miss its clip and is still taken as seen."""

AROUND = 2
"""Moments before and after it is seen in which a shape is still followed, while it fades."""


def inside_clips(shapes: Sequence[Shape], columns: Sequence[Ints], points: Floats) -> Floats:
    """1 where a shape's box meets the box of what clips it, or nothing clips it; else 0: array[moment, shape].

    `points` is array[moment, point, xy] in pixels, `columns` the points of each shape.
    """
    low = np.stack([points[:, column].min(axis=1) for column in columns], axis=1)
    high = np.stack([points[:, column].max(axis=1) for column in columns], axis=1)
    place = {shape.id: number for number, shape in enumerate(shapes)}
    inside = np.ones((*points.shape[:1], len(shapes)))
    for number, shape in enumerate(shapes):
        if shape.clip:
            clips = [place[name] for name in shape.clip]
            meets = (high[:, [number]] + MARGIN >= low[:, clips]) & (low[:, [number]] - MARGIN <= high[:, clips])
            inside[:, number] = np.any(np.all(meets, axis=2), axis=1)
    return inside


def around(seen: Bools) -> Bools:
    """The moments to follow a shape at: where it is seen, AROUND moments before and after, and both ends."""
    near: Bools = np.convolve(seen, np.ones(2 * AROUND + 1))[AROUND : AROUND + len(seen)] > 0
    near[[0, -1]] = True
    return near
