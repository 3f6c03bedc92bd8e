"""What a rig draws: shapes of constant topology, and their points and opacities over frames."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from facescript.performance.performance import Frames

Floats = NDArray[np.float64]


class Tone(str):
    """A colour `#rrggbb` that knows its `name` in the palette, `family.tone`, or of which tones it is a `mixture`:
    (one, the other, the other's share). Outputs with names of their own can keep it."""

    name: str
    mixture: tuple[str, str, float] | None

    def __new__(cls, colour: str, name: str, mixture: tuple[str, str, float] | None = None) -> Tone:
        tone = super().__new__(cls, colour)
        tone.name, tone.mixture = name, mixture
        return tone


@dataclass(frozen=True, slots=True)
class Stop:
    """A gradient's stop: place 0..1, colour `#rrggbb`, opacity 0..1."""

    offset: float
    colour: str
    opacity: float = 1.0


@dataclass(frozen=True, slots=True)
class Linear:
    """A gradient along a line, in fractions of the shape's bounding box, which is rolled with the head."""

    stops: tuple[Stop, ...]
    start: tuple[float, float] = (0.0, 0.0)
    end: tuple[float, float] = (0.0, 1.0)


@dataclass(frozen=True, slots=True)
class Radial:
    """A gradient around a centre, in fractions of the shape's bounding box, which is rolled with the head."""

    stops: tuple[Stop, ...]
    centre: tuple[float, float] = (0.5, 0.5)
    radius: float = 0.5


Paint = str | Linear | Radial
"""A colour `#rrggbb`, or a gradient."""


@dataclass(frozen=True, slots=True)
class Contour:
    """One closed outline of cubic Beziers: points first .. first + count of the rig's point array, in the order
    start, (handle, handle, anchor) repeated; count == 1 + 3 * segments."""

    first: int
    count: int


@dataclass(frozen=True, slots=True)
class Shape:
    """A filled path. `group` is the layer's name (`hair-front`, `eye-left`), `clip` the id of the shape(s) that bound
    it. `moving` is False where no channel ever moves it. Fill rule is nonzero."""

    id: str
    group: str
    contours: tuple[Contour, ...]
    fill: Paint
    clip: tuple[str, ...] = ()
    moving: bool = True


@dataclass(frozen=True, slots=True)
class Picture:
    """Frames of a face as geometry. `points` is array[frame, point, 2] in the rig's own px (y down), `opacity`
    array[frame, shape] 0..1; a shape at 0 need not be drawn. `turns`, array[frame, shape], is by how many radians
    clockwise each shape's layer is rolled in the picture, with the head or less; so is the box its gradient fills."""

    points: Floats
    opacity: Floats
    turns: Floats


def unturned(points: Floats, turn: float) -> Floats:
    """Points array[point, xy] that are turned by so many radians clockwise, turned back about the origin."""
    (x, y), (cos, sin) = points.T, (math.cos(turn), math.sin(turn))
    return np.stack([x * cos + y * sin, y * cos - x * sin], axis=1)


class Rig(Protocol):
    """Channels to geometry. The art box is `box` wide and high; the eyes' middle is at `eyes`, d px apart."""

    box: tuple[float, float]
    eyes: tuple[float, float]
    eye_distance: float
    shapes: tuple[Shape, ...]

    def draw(self, frames: Frames) -> Picture:
        """The geometry of poses array[frame, channel], in one vectorised call; a pure function of each row."""
        ...
