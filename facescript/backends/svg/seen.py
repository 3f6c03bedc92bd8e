"""Frames of shapes to when each can be seen: what is hidden need not be written."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

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


FAINT = 0.25
"""An edge this opaque or less is allowed to be off by more, so that it changes pixels as much as one this opaque."""

FAINTEST = 4.0
"""By how much more at most."""


@dataclass(frozen=True, slots=True)
class Sight:
    """What of some frames can be seen. `points` is array[moment, point, xy] in pixels, `columns` the points of each
    shape, `opacity` array[moment, shape]."""

    shapes: Sequence[Shape]
    columns: Sequence[Ints]
    points: Floats
    opacity: Floats

    def shown(self) -> Floats:
        """The opacity where a shape's box meets the box of what clips it, or nothing clips it; else 0."""
        shown = self.opacity.copy()
        for number, shape in enumerate(self.shapes):
            if shape.clip:
                mine = self.points[:, self.columns[number]]
                shown[:, number] *= self._hidden(number, mine.min(axis=1), mine.max(axis=1)) <= MARGIN
        return shown

    def tolerances(self, number: int, spots: Floats, off: float) -> Floats:
        """How far spots (sums of the shape's points) may be off, array[moment, spot], where at least `off` is allowed:
        more where the shape is faint, and by as much as they are hidden outside of what clips it."""
        opacity = np.clip(self.opacity[:, number], FAINT / FAINTEST, FAINT)
        allowed = np.repeat(off * FAINT / opacity[:, None], len(spots), axis=1)
        if not self.shapes[number].clip:
            return allowed
        where = spots @ self.points[:, self.columns[number]]
        return np.asarray(np.maximum(allowed, self._hidden(number, where, where) - MARGIN))

    def _hidden(self, number: int, low: Floats, high: Floats) -> Floats:
        """Pixels between boxes array[moment, ..., xy] and the box of what clips a shape, the nearest of several."""
        gaps = []
        for place, shape in enumerate(self.shapes):
            if shape.id in self.shapes[number].clip:
                clip = self.points[:, self.columns[place]]
                first, last = clip.min(axis=1), clip.max(axis=1)
                if low.ndim > 2:
                    first, last = first[:, None], last[:, None]
                gaps.append(np.maximum(low - last, first - high).max(axis=-1))
        return np.asarray(np.min(gaps, axis=0))


def around(seen: Bools) -> Bools:
    """The moments to follow a shape at: where it is seen, AROUND moments before and after, and both ends."""
    near: Bools = np.convolve(seen, np.ones(2 * AROUND + 1))[AROUND : AROUND + len(seen)] > 0
    near[[0, -1]] = True
    return near
