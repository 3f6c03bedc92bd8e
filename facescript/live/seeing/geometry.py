"""A face in a camera's picture to a place in the room, by the camera's place and tilt and the size of a face.

The camera looks from the screen to the viewers, so what is on the viewers' right is on the left of its picture. The
model is a pinhole: a face `width` cm wide that is d cm away along the camera's axis is `focal * width / d` pixels wide.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, radians, sin, tan

from facescript.ir.values import Point

FACE = 15.0
"""How wide a face is as finders frame it, cm. Where pupils are 6.3 cm apart, the mean of adults (Dodgson 2004), the
frames of OpenCV's cascade are 14.8 wide and those of MediaPipe 15.2 (found on a photograph); heads are 15 to 16."""

EYE_LINE = 0.4
"""How far down a face's frame its eyes are, of the frame's height (the frames of OpenCV's cascade and MediaPipe's)."""

NEAREST, FURTHEST = 10.0, 2_000.0
"""A face is no nearer to the camera and no further from it, cm."""


@dataclass(frozen=True, slots=True)
class Box:
    """A face's frame in a picture: its upper left corner, x to the right and y down, and its size; pixels."""

    x: float
    y: float
    width: float
    height: float

    @property
    def middle(self) -> tuple[float, float]:
        return self.x + self.width / 2, self.y + self.height / 2

    def overlap(self, other: Box) -> float:
        """The part that both have of what either has, 0 to 1."""
        wide = min(self.x + self.width, other.x + other.width) - max(self.x, other.x)
        high = min(self.y + self.height, other.y + other.height) - max(self.y, other.y)
        both = max(0.0, wide) * max(0.0, high)
        return both / (self.width * self.height + other.width * other.height - both)


@dataclass(frozen=True, slots=True)
class Camera:
    """How a camera stands: its `place` in the room (cm, as targets have it), `tilt` (deg, + is up), field of view from
    the left to the right edge of its picture (deg), and whether its picture is `mirrored`. With `distance` every face
    is so far out of the screen (cm), however large it is."""

    place: Point
    tilt: float = 0.0
    fov: float = 60.0
    mirrored: bool = False
    distance: float | None = None

    def focal(self, width: int) -> float:
        """Pixels of a picture `width` pixels wide that something takes up which is as wide as it is far away."""
        return width / 2 / tan(radians(self.fov) / 2)

    def locate(self, box: Box, width: int, height: int, face: float = FACE) -> Point:
        """Where the eyes of a face are, by its frame in a picture of a size in pixels; the frame is `face` cm wide."""
        focal = self.focal(width)
        right = (box.x + box.width / 2 - width / 2) / focal
        up = (height / 2 - box.y - EYE_LINE * box.height) / focal
        side = right if self.mirrored else -right
        rise = up * cos(radians(self.tilt)) + sin(radians(self.tilt))
        out = cos(radians(self.tilt)) - up * sin(radians(self.tilt))
        away = self._away(focal * face / box.width, out)
        return Point(self.place.x + side * away, self.place.y + rise * away, self.place.z + out * away)

    def _away(self, measured: float, out: float) -> float:
        """How far away along the camera's axis a face is that measures so; `out` is how far out of the screen a point
        of its ray is that is 1 away. A ray that never comes out that far is taken for as near as faces are."""
        if self.distance is not None:
            measured = (self.distance - self.place.z) / out if out > 0.0 else NEAREST
        return min(max(measured, NEAREST), FURTHEST)
