"""A face's style -> its rig: poses to the points and opacities of shapes that never change their topology."""

from __future__ import annotations

import numpy as np

from facescript.performance.channels import INDEX, SIDES
from facescript.performance.performance import REST, Frames
from facescript.rig.cartoon import table
from facescript.rig.cartoon.depth import LAWS, Head
from facescript.rig.cartoon.live import Columns, columns, draw_live
from facescript.rig.cartoon.muscles import effects, pulls
from facescript.rig.cartoon.palette import Palette
from facescript.rig.cartoon.pen import Floats, Pen
from facescript.rig.cartoon.style import FaceStyle
from facescript.rig.cartoon.tone import tones
from facescript.rig.cartoon.turn import CM, Pose, Turn
from facescript.rig.picture import Picture, Shape

BOX = (720.0, 720.0)
EYES = (360.0, 318.0)

FIT = {"mouth.open": 0.5, "mouth.lower": 0.4, "mouth.upper": 0.1}
"""The pose at which the mouth is fitted with splines: shut, it has no shape to fit."""


class CartoonRig:
    """Draws one cartoon face (`rig.picture.Rig`)."""

    def __init__(self, style: FaceStyle, palette: Palette) -> None:
        self.style = style
        self.box, self.eyes, self.eye_distance = BOX, EYES, style.d
        self._parts = style.parts(palette)
        self._table = self._laid_out()
        anchors = self._table
        spots = list(zip(anchors.owner, anchors.x.tolist(), anchors.y.tolist(), strict=True))
        head = Head([(y / style.d, x / style.d) for x, y in style.outline], style.shell)
        depths = [LAWS[law](x / style.d, y / style.d, head) for (_, law), x, y in spots]
        self._turn = Turn(anchors.x, anchors.y, depths, style.d)
        self._effects = effects(pulls(style), [(part, law, x, y) for (part, law), x, y in spots])
        self.shapes = tuple(
            Shape(part.id, part.group, anchors.contours[part.id], part.fill, part.clip) for part in self._parts
        )
        self._opacity = np.array([part.opacity for part in self._parts])
        self._slot = {part.id: k for k, part in enumerate(self._parts)}
        self._eye_rows = {side: self._block(f"eye-{side}") for side in SIDES}

    def draw(self, frames: Frames) -> Picture:
        """The geometry of poses array[frame, channel]; each row of it follows from that row alone."""
        named = columns(frames)
        x, y, forward, pen = self._anchors(named)
        x, y = self._turn(x, y, forward, Pose.of(named, self.style.d))
        points = np.empty((len(frames), self._table.source.shape[1], 2))
        for axis, values in enumerate((x, y)):
            points[:, :, axis] = (self._table.points(values) + EYES[axis]).T
        return Picture(points, self._tone(pen, named, len(frames)))

    def _laid_out(self) -> table.Table:
        static = {part.id: part.loops for part in self._parts if part.loops}
        live = [part.id for part in self._parts if not part.loops]
        outlines = []
        for pose in (REST, _fit_pose()):
            pen = draw_live(self.style, columns(pose[None, :]))
            outlines.append(static | {name: pen.outlines(name) for name in live})
        self._live = tuple(live)
        return table.build(self._parts, *outlines)

    def _block(self, group: str) -> slice:
        """The rows of a group of parts, which stand together."""
        rows = [self._table.rows[part.id] for part in self._parts if part.group == group]
        return slice(rows[0].start, rows[-1].stop)

    def _anchors(self, named: Columns) -> tuple[Floats, Floats, Floats, Pen]:
        """Anchors of the face looking straight ahead, array[anchor, frame], and how far each stands out."""
        count = len(named["head.yaw"])
        x = np.repeat(self._table.x[:, None], count, axis=1)
        y = np.repeat(self._table.y[:, None], count, axis=1)
        forward = np.zeros_like(x)
        pen = draw_live(self.style, named)
        for name in self._live:
            rows = self._table.rows[name]
            pen.write(name, x[rows], y[rows], forward[rows])
        for effect in self._effects:
            signal = named[effect.signal]
            x[effect.rows] += effect.dx * signal
            y[effect.rows] += effect.dy * signal
        forward[self._block("mouth")] += 9.0 * named["mouth.round"]
        self._place_eyes(x, y, named)
        return x, y, forward, pen

    def _place_eyes(self, x: Floats, y: Floats, named: Columns) -> None:
        """Each eye shifts and grows on its own, about its middle."""
        unit = CM * self.style.d
        for side, sign in (("left", 1), ("right", -1)):
            rows, size = self._eye_rows[side], named[f"eye.{side}.scale"]
            middle = sign * self.style.d / 2
            x[rows] = (x[rows] - middle) * size + (middle + unit * named[f"eye.{side}.x"])
            y[rows] = y[rows] * size - unit * named[f"eye.{side}.y"]

    def _tone(self, pen: Pen, named: Columns, count: int) -> Floats:
        opacity = np.repeat(self._opacity[None, :], count, axis=0)
        for name, values in (tones(named) | pen.opacity).items():
            opacity[:, self._slot[name]] = values
        return opacity


def _fit_pose() -> Floats:
    pose = REST.copy()
    for name, value in FIT.items():
        pose[INDEX[name]] = value
    return pose
