"""A face on the stage: its rig's shapes and points, set where it stands in the picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from facescript.ir.play import Face, Film
from facescript.performance.performance import REST, Frames
from facescript.rig.picture import Contour, Paint, Shape
from facescript.rig.rigs import rig
from facescript.space.layout import Standing

Floats = NDArray[np.float64]

BACKDROP = "background"
"""The group of those shapes of a face's art that stand behind all faces."""


class Actor:
    """One face: `shapes` without the part of its backdrop that fills the whole art box, which is `ground` (None where
    it has none). Points of the shapes are rows of what `draw` gives."""

    def __init__(self, face: Face, standing: Standing, film: Film) -> None:
        self.name = face.name
        self._rig = rig(face)
        self._standing = standing
        rest = self._rig.draw(REST[None]).points[0]
        backs = [shape.group == BACKDROP for shape in self._rig.shapes]
        fills = [back and self._fills(rest[_rows(shape)]) for back, shape in zip(backs, self._rig.shapes, strict=True)]
        self._kept = [place for place, fill in enumerate(fills) if not fill]
        self.shapes: tuple[Shape, ...] = tuple(self._rig.shapes[place] for place in self._kept)
        self.ground: Paint | None = self._rig.shapes[fills.index(True)].fill if any(fills) else None
        self.count = len(rest)
        self._hem = self._hung(rest, film)

    def draw(self, frames: Frames) -> tuple[Floats, Floats]:
        """Points array[frame, point, 2] in picture px and opacity array[frame, shape] of poses."""
        picture = self._rig.draw(frames)
        points = picture.points * self._standing.scale + (self._standing.left, self._standing.top)
        points[..., 1] += self._hem
        return points, picture.opacity[:, self._kept]

    def _fills(self, points: Floats) -> bool:
        """Whether an outline goes all around the art box."""
        near = 0.5
        low, high = points.min(axis=0), points.max(axis=0)
        return bool((low <= near).all() and (high >= np.array(self._rig.box) - near).all())

    def _hung(self, rest: Floats, film: Film) -> Floats:
        """How much lower each point hangs than drawn: a bust that is cut off goes down to the film's edge."""
        own = np.zeros(len(rest), dtype=bool)
        for shape in self.shapes:
            own[_rows(shape)] |= shape.group != BACKDROP
        lowest = float(rest[own, 1].max(initial=self._rig.box[1]))
        bottom = self._standing.top + lowest * self._standing.scale
        return np.where(own & (rest[:, 1] >= lowest - 0.5), max(0.0, film.height - bottom), 0.0)


def moved(shapes: Sequence[Shape], first: int, prefix: str, moving: bool) -> list[Shape]:
    """Shapes for a longer list of points, theirs from row `first` on, with a prefix to all ids."""
    return [
        replace(
            shape,
            id=prefix + shape.id,
            contours=tuple(Contour(first + each.first, each.count) for each in shape.contours),
            clip=tuple(prefix + name for name in shape.clip),
            moving=shape.moving or moving,
        )
        for shape in shapes
    ]


def _rows(shape: Shape) -> NDArray[np.intp]:
    return np.concatenate([np.arange(each.first, each.first + each.count) for each in shape.contours])
