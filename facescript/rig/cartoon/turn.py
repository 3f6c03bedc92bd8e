"""Anchors of the face at rest, deformed, and head poses -> anchors in the picture.

The head is pitched, then turned about the vertical, then tilted in the picture: the nose points where yaw and pitch
say, so that what the eyes are turned by in the head adds up to where they look. (The thesis turns about Y, X, Z; for
one angle at a time it is the same.)
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.rig.cartoon.depth import Depth
from facescript.rig.cartoon.pen import soft_max

Floats = NDArray[np.float64]

ORIGIN = 1.3
"""The head turns about a point this many d below the eyes' middle (Algorithm 2.1)."""

SKULL = (-0.30, 0.115)
"""y and z (d) of the middle of the skull, about which its silhouette is a ball; below, hair hangs as the head does."""

LONG = 1.15
"""The skull is longer than wide by this: so wide it is from the side."""

CM = 1 / 6.3
"""A centimetre in d: the eyes are 6.3 cm apart."""

TRUNK_YAW, TRUNK_ROLL = 0.22, 0.07
"""How much of the head's turn the shoulders take."""

NECK_SLACK = 0.24
"""How far (d) the head may shift before the body comes along."""


@dataclass(frozen=True, slots=True)
class Pose:
    """Head poses as arrays[frame]: sine and cosine of yaw, pitch, roll; how far tipped back (the sine of pitch, 0 when
    bowed); the trunk's turn; shift in px (y down); size."""

    yaw: tuple[Floats, Floats]
    pitch: tuple[Floats, Floats]
    roll: tuple[Floats, Floats]
    back: Floats
    trunk: tuple[Floats, Floats]
    shift: tuple[Floats, Floats]
    size: Floats

    @classmethod
    def of(cls, columns: dict[str, Floats], d: float) -> Pose:
        """From channels by name: degrees, cm with y up, 1."""
        yaw, pitch, roll = (np.radians(columns[f"head.{axis}"]) for axis in ("yaw", "pitch", "roll"))
        shift = (columns["head.x"] * (CM * d), columns["head.y"] * (-CM * d))
        trunk = (np.sin(TRUNK_YAW * yaw), TRUNK_ROLL * roll)
        turned = [(np.sin(angle), np.cos(angle)) for angle in (yaw, pitch, roll)]
        back = np.asarray(soft_max(turned[1][0], 0.0, 0.1), dtype=np.float64)
        return cls(turned[0], turned[1], turned[2], back, trunk, shift, columns["head.scale"])

    def rolled(self, follow: Floats) -> Floats:
        """How far what follows the head by so much, array[part], is rolled in the picture: array[frame, part], radians
        clockwise. The trunk leans 2 degrees at most; what is on it is taken to be upright, which is quicker drawn."""
        sin_roll, cos_roll, lean = (part[:, None] for part in (*self.roll, self.trunk[1]))
        angles: Floats = np.arctan2(lean + follow * (sin_roll - lean), 1 + follow * (cos_roll - 1))
        return np.where(follow > 0, angles, 0.0)


class Turn:
    """Turns anchors by their depths; arrays are [anchor, frame], px from the eyes' middle, y down."""

    def __init__(self, x: Floats, y: Floats, depths: list[Depth], d: float) -> None:
        column = {name: np.array([getattr(depth, name) for depth in depths])[:, None] for name in Depth.__slots__}
        self.d = d
        self.z = column["z"] * d
        self.slide = column["slide"] * d
        self.under = column["under"] * d
        self.flatten = column["flatten"]
        self.barrel = column["barrel"] * x[:, None]
        self.round_x = column["silhouette"] * x[:, None]
        self.round_y = column["silhouette"] * np.minimum(y[:, None] - SKULL[0] * d, 0.0)
        self.follow = column["follow"]
        self.trunk = column["trunk"] * d
        self.free = np.flatnonzero(self.follow[:, 0] < 1)

    def __call__(self, x: Floats, y: Floats, forward: Floats, pose: Pose) -> tuple[Floats, Floats]:
        """Anchors in the picture; `forward` is how far each stands out from its depth at rest, px."""
        (sin_yaw, _), size = pose.yaw, pose.size
        z = self.z * (1 - self.flatten * (sin_yaw * sin_yaw)) + forward
        z += self.slide * sin_yaw - self.under * pose.back
        head_x, head_y = self._head(x, y, z, pose)
        free = self.free
        body_x, body_y = self._body(x[free], y[free], pose)
        follow = self.follow[free]
        head_x[free] = body_x + follow * (head_x[free] - body_x)
        head_y[free] = body_y + follow * (head_y[free] - body_y)
        pivot = ORIGIN * self.d
        return head_x * size, (head_y - pivot) * size + pivot

    def _head(self, x: Floats, y: Floats, z: Floats, pose: Pose) -> tuple[Floats, Floats]:
        pivot = ORIGIN * self.d
        (sin_yaw, cos_yaw), (sin_pitch, cos_pitch), (sin_roll, cos_roll) = pose.yaw, pose.pitch, pose.roll
        up = y - pivot
        y1 = up * cos_pitch - z * sin_pitch + self.round_y * (1 - cos_pitch)
        z1 = z * cos_pitch + up * sin_pitch
        length = np.sqrt(cos_yaw * cos_yaw + (LONG * sin_yaw) ** 2)
        x1 = x * cos_yaw + z1 * sin_yaw + self.round_x * (length - cos_yaw) + self.barrel * (1 - cos_yaw)
        x1 -= self.round_y * (sin_yaw * sin_pitch)
        x2 = x1 * cos_roll - y1 * sin_roll + pose.shift[0]
        y2 = x1 * sin_roll + y1 * cos_roll + (pivot + pose.shift[1])
        return x2, y2

    def _body(self, x: Floats, y: Floats, pose: Pose) -> tuple[Floats, Floats]:
        """The trunk turns a little, and comes along once the neck is stretched."""
        turn, lean = pose.trunk
        slack = NECK_SLACK * self.d
        along_x, along_y = (s - slack * np.tanh(0.7 * s / slack) for s in pose.shift)
        return x + self.trunk[self.free] * turn + along_x, y + x * lean + along_y
