"""A run to the VMC protocol: blend shapes under the names of VRM, and the turns of head and eyes, for one avatar.

The bones turn in the axes of Unity: x to the avatar's right, y up, z out of its face, left-handed. Places of bones stay
zero: where its bones are, the avatar knows.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.live.model import Frame, Layout
from facescript.live.sinks.bundles import Bundles, message
from facescript.live.sinks.datagrams import DatagramSink
from facescript.live.sinks.faces import chosen
from facescript.performance.channels import INDEX
from facescript.shapes import vrm

BONES = (("Head", "head"), ("LeftEye", "eye.left"), ("RightEye", "eye.right"))
"""Bones by Unity's names, with the channels that turn them."""

TURNS = np.array([[INDEX[f"{part}.{axis}"] for axis in ("pitch", "yaw", "roll")] for _, part in BONES])

STILL = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
"""A place, and a turn by nothing."""


class VmcSink(DatagramSink):
    """A frame is its time, the bones, the shapes, and the word to show them."""

    def begin(self, layout: Layout) -> None:
        self._face = chosen(layout, self._address)
        names = vrm.NAMES if self._address.options.get("names") == "vrm1" else vrm.VRM0
        root = message("/VMC/Ext/Root/Pos", "root", *STILL), 0
        bones = [(message("/VMC/Ext/Bone/Pos", bone, *STILL), 4) for bone, _ in BONES]
        blends = [(message("/VMC/Ext/Blend/Val", name, 0.0), 1) for name in names]
        begin = [(message("/VMC/Ext/OK", 1), 0), (message("/VMC/Ext/T", 0.0), 1), root]
        self._bundles = Bundles([*begin, *bones, *blends, (message("/VMC/Ext/Blend/Apply"), 0)])

    def packets(self, frame: Frame) -> list[bytes]:
        pose = self._face.pose(frame.values)
        shapes = vrm.shapes(pose[None, :])[0]
        return self._bundles.packets(np.concatenate(([frame.time], quaternions(pose[TURNS]).ravel(), shapes)))


def quaternions(turns: NDArray[np.float64]) -> NDArray[np.float64]:
    """array[bone, (pitch, yaw, roll)] in degrees, first pitch, then yaw about the vertical, then roll, to
    array[bone, (x, y, z, w)] in Unity's axes: up is about -x there, the avatar's left about -y, clockwise for who looks
    at it about z."""
    half = np.radians(turns) / 2 * np.array([-1.0, -1.0, 1.0])
    (sx, sy, sz), (cx, cy, cz) = np.sin(half).T, np.cos(half).T
    x = cz * cy * sx - sz * sy * cx
    y = cz * sy * cx + sz * cy * sx
    z = sz * cy * cx - cz * sy * sx
    w = cz * cy * cx + sz * sy * sx
    return np.stack([x, y, z, w], axis=1)
