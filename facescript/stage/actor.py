"""A face on the stage: its rig's shapes and points, set where it stands in the picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from facescript.ir.play import Face, Film
from facescript.performance.performance import REST, Frames
from facescript.rig.cartoon.backdrop import backdrop
from facescript.rig.picture import Contour, Paint, Picture, Shape
from facescript.rig.rigs import rig, style
from facescript.space.layout import Standing

Floats = NDArray[np.float64]

BACKDROP = "background"
"""The group of those shapes of a face's art that stand behind all faces."""


def scenery(face: Face) -> tuple[tuple[Shape, ...], Picture]:
    """The shapes behind a face's bust, and their one frame."""
    return backdrop(style(face))


class Actor:
    """One face and its backdrop: `shapes` are rows of what `draw` gives. The part of the backdrop that fills the whole
    art box is not among them but `ground` (None where it has none)."""

    def __init__(self, face: Face, standing: Standing, film: Film) -> None:
        self.name = face.name
        self._rig = rig(face)
        self._standing = standing
        behind, picture = scenery(face)
        fills = [self._fills(picture.points[0][_rows(shape)]) for shape in behind]
        self._kept = [place for place, fill in enumerate(fills) if not fill]
        self.ground: Paint | None = behind[fills.index(True)].fill if any(fills) else None
        self._behind = picture.points[0], picture.opacity[0, self._kept]
        rest = self._rig.draw(REST[None]).points[0]
        backs = moved([behind[place] for place in self._kept], len(rest))
        self.shapes: tuple[Shape, ...] = (*backs, *self._rig.shapes)
        self.count = len(rest) + len(self._behind[0])
        self._hem = self._hung(rest, film)

    def draw(self, frames: Frames) -> Picture:
        """The geometry of poses, its points in picture px."""
        picture = self._rig.draw(frames)
        points, opacity = (np.repeat(part[None], len(frames), axis=0) for part in self._behind)
        upright = np.zeros_like(opacity)
        joined = np.concatenate([picture.points, points], axis=1)
        joined *= self._standing.scale
        joined += self._standing.left, self._standing.top
        joined[:, : len(self._hem), 1] += self._hem
        shades = np.concatenate([opacity, picture.opacity], axis=1)
        return Picture(joined, shades, np.concatenate([upright, picture.turns], axis=1))

    def _fills(self, points: Floats) -> bool:
        """Whether an outline goes all around the art box."""
        near = 0.5
        low, high = points.min(axis=0), points.max(axis=0)
        return bool((low <= near).all() and (high >= np.array(self._rig.box) - near).all())

    def _hung(self, rest: Floats, film: Film) -> Floats:
        """How much lower each point hangs than drawn: a bust that is cut off, for it goes beyond the art box,
        goes down to the film's edge; a head without one ends where it is drawn."""
        lowest = float(rest[:, 1].max())
        if lowest < self._rig.box[1]:
            return np.zeros(len(rest))
        bottom = self._standing.top + lowest * self._standing.scale
        return np.where(rest[:, 1] >= lowest - 0.5, max(0.0, film.height - bottom), 0.0)


def moved(shapes: Sequence[Shape], first: int, prefix: str = "", moving: bool = False) -> list[Shape]:
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
