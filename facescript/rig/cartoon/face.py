"""A face's style -> its rig: poses to the points and opacities of shapes that never change their topology."""

from __future__ import annotations

import numpy as np

from facescript.performance.channels import INDEX, SIDES
from facescript.performance.performance import REST, Frames
from facescript.rig.cartoon import features as points
from facescript.rig.cartoon import table
from facescript.rig.cartoon.depth import LAWS, Head
from facescript.rig.cartoon.live import Columns, columns, draw_live
from facescript.rig.cartoon.muscles import effects, pulls
from facescript.rig.cartoon.outline import Part
from facescript.rig.cartoon.palette import Palette
from facescript.rig.cartoon.pen import Floats, Pen
from facescript.rig.cartoon.style import FaceStyle
from facescript.rig.cartoon.sway import Sway
from facescript.rig.cartoon.tone import tones
from facescript.rig.cartoon.turn import CM, Pose, Turn
from facescript.rig.picture import Picture, Shape

BOX = (720.0, 720.0)
EYES = (360.0, 318.0)

FIT = {"mouth.open": 0.5, "mouth.lower": 0.4, "mouth.upper": 0.1}
"""The pose at which the mouth is fitted with splines: shut, it has no shape to fit."""

PUSHED_OUT = 9.0
"""How far rounded lips come forward, px."""


class CartoonRig:
    """Draws one cartoon face (`rig.picture.Rig`); px of the art box, y down."""

    def __init__(self, style: FaceStyle, palette: Palette) -> None:
        self.style = style
        self.box, self.eyes, self.eye_distance = BOX, EYES, style.d
        parts = style.parts(palette)
        self._live = tuple(part.id for part in parts if not part.loops)
        self._table = self._lay_out((*parts, *points.feature_parts(style)))
        spots = list(zip(self._table.owner, self._table.x.tolist(), self._table.y.tolist(), strict=True))
        head = Head([(y / style.d, x / style.d) for x, y in style.outline], style.shell)
        lying = zip(self._table.owner, self._table.middle, strict=True)
        depths = [LAWS[law](x / style.d, y / style.d, head) for (_, law), (x, y) in lying]
        self._turn = Turn(self._table.x, self._table.y, depths, style.d)
        self._effects = effects(pulls(style), [(part, law, x, y) for (part, law), x, y in spots])
        hair = {part.id for part in parts if part.group.startswith("hair")}
        rows = np.flatnonzero([part in hair for part, _ in self._table.owner])
        self._sway = Sway.of(rows, self._table.x, self._table.y, style.d)
        self._opacity = np.array([part.opacity for part in parts])
        self._slot = {part.id: k for k, part in enumerate(parts)}
        self._groups = {group: self._block(group, parts) for group in ("eye-left", "eye-right", "mouth")}
        self._features = points.rows_of(style, self._table.rows)
        self.shapes = tuple(
            Shape(part.id, part.group, self._table.contours[part.id], part.fill, part.clip) for part in parts
        )

    def draw(self, frames: Frames) -> Picture:
        """The geometry of poses array[frame, channel]; each row of it follows from that row alone."""
        named = columns(frames)
        x, y, pen = self._anchors(named)
        drawn = np.empty((len(frames), self._table.source.shape[1], 2))
        for axis, values in enumerate((x, y)):
            drawn[:, :, axis] = (self._table.points(values) + EYES[axis]).T
        return Picture(drawn, self._tone(pen, named, len(frames)))

    def features(self, frames: Frames) -> Floats:
        """The feature points `points.NAMES` as drawn in the poses: array[frame, 72 + 17, 2], px."""
        x, y, _ = self._anchors(columns(frames))
        out = np.empty((len(frames), len(self._features), 2))
        for k, rows in enumerate(self._features):
            for axis, values in enumerate((x, y)):
                out[:, k, axis] = values[list(rows)].sum(axis=0) / len(rows) + EYES[axis]
        return out

    @property
    def feature_names(self) -> tuple[str, ...]:
        """What `features` returns, in its order."""
        return points.NAMES

    @property
    def units(self) -> points.Units:
        """The face's facial animation parameter units, px."""
        at = dict(zip(points.NAMES, map(tuple, self.features(REST[None])[0].tolist()), strict=True))
        return points.units(at, self.style.eye.iris)

    def _lay_out(self, parts: tuple[Part, ...]) -> table.Table:
        static = {part.id: part.loops for part in parts if part.loops}
        outlines = []
        for pose in (REST, _fit_pose()):
            pen = draw_live(self.style, columns(pose[None]))
            outlines.append(static | {name: pen.outlines(name) for name in self._live})
        return table.build(parts, outlines[0], outlines[1], bare=points.GROUP)

    def _block(self, group: str, parts: tuple[Part, ...]) -> slice:
        """The rows of a group of parts, which stand together."""
        rows = [self._table.rows[part.id] for part in parts if part.group == group]
        return slice(rows[0].start, rows[-1].stop)

    def _anchors(self, named: Columns) -> tuple[Floats, Floats, Pen]:
        """Where the anchors are, array[anchor, frame], px from the eyes' middle, and what eyes and mouth drew."""
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
        self._sway.move(x, y, named)
        forward[self._groups["mouth"]] += PUSHED_OUT * named["mouth.round"]
        self._place_eyes(x, y, named)
        x, y = self._turn(x, y, forward, Pose.of(named, self.style.d))
        return x, y, pen

    def _place_eyes(self, x: Floats, y: Floats, named: Columns) -> None:
        """Each eye shifts and grows on its own, about its middle."""
        unit = CM * self.style.d
        for side, sign in zip(SIDES, (1, -1), strict=True):
            rows, size = self._groups[f"eye-{side}"], named[f"eye.{side}.scale"]
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
