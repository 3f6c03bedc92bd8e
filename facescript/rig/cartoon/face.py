"""A face's style -> its rig: poses to the points and opacities of shapes that never change their topology."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import INDEX
from facescript.performance.performance import REST, Frames
from facescript.rig.cartoon import features as points
from facescript.rig.cartoon import table
from facescript.rig.cartoon.depth import LAWS, Depth, Head
from facescript.rig.cartoon.eyes import place
from facescript.rig.cartoon.live import Columns, columns, draw_live, signal
from facescript.rig.cartoon.muscles import effects
from facescript.rig.cartoon.outline import Part
from facescript.rig.cartoon.pen import Floats, Pen
from facescript.rig.cartoon.style import FaceStyle
from facescript.rig.cartoon.sway import Sway
from facescript.rig.cartoon.tone import tones
from facescript.rig.cartoon.turn import CM, Pose, Turn
from facescript.rig.picture import Picture, Shape

BOX = (720.0, 720.0)
FIT = {"mouth.open": 0.5, "mouth.lower": 0.4, "mouth.upper": 0.1}
"""The pose at which the mouth is fitted with splines: shut, it has no shape to fit."""

PUSHED_OUT = 9.0
"""How far rounded lips come forward, px."""


class CartoonRig:
    """Draws one cartoon face (`rig.picture.Rig`); px of the art box, y down."""

    def __init__(self, style: FaceStyle) -> None:
        self.style = style
        self.box, self.eyes, self.eye_distance = BOX, style.eyes_at, style.d
        parts = style.parts
        self._live = tuple(part.id for part in parts if not part.loops)
        self._table = self._lay_out((*parts, *points.feature_parts(style)))
        self._turn = Turn(self._table.x, self._table.y, self._depths(), style.d)
        self._follow = self._following(parts)
        self._effects = effects(style, self._table)
        hair = {part.id for part in parts if part.group.startswith("hair")}
        rows = np.flatnonzero([part in hair for part, _ in self._table.owner])
        self._sway = Sway.of(rows, self._table.x, self._table.y, style.d)
        self._opacity = np.array([part.opacity for part in parts])
        self._slot = {part.id: k for k, part in enumerate(parts)}
        self._groups = {group: self._rows_in(group, parts) for group in self._turned()}
        self._features = points.rows_of(style, self._table.rows)
        self.shapes = tuple(
            Shape(part.id, part.group, self._table.contours[part.id], part.fill, part.clip) for part in parts
        )

    def draw(self, frames: Frames) -> Picture:
        """The geometry of poses array[frame, channel]; each row of it follows from that row alone."""
        named = self._columns(frames)
        x, y, pen = self._anchors(named)
        drawn = np.empty((len(frames), self._table.source.shape[1], 2))
        for axis, values in enumerate((x, y)):
            drawn[:, :, axis] = (self._table.points(values) + self.eyes[axis]).T
        turns = Pose.of(named, self.style.d).rolled(self._follow)
        return Picture(drawn, self._tone(pen, named, len(frames)), turns)

    def features(self, frames: Frames) -> Floats:
        """The feature points `points.NAMES` as drawn in the poses: array[frame, 72 + 17, 2], px."""
        x, y, _ = self._anchors(self._columns(frames))
        out = np.empty((len(frames), len(self._features), 2))
        for k, rows in enumerate(self._features):
            for axis, values in enumerate((x, y)):
                out[:, k, axis] = values[list(rows)].sum(axis=0) / len(rows) + self.eyes[axis]
        return out

    @property
    def feature_names(self) -> tuple[str, ...]:
        """What `features` returns, in its order."""
        return points.NAMES if self._features else ()

    @property
    def units(self) -> points.Units:
        """The face's facial animation parameter units, px."""
        at = dict(zip(points.NAMES, map(tuple, self.features(REST[None])[0].tolist()), strict=True))
        return points.units(at, self.style.eyes[0].style.iris)

    def _columns(self, frames: Frames) -> Columns:
        """Channels by name, and the face's own amounts, which stay as they are."""
        return columns(frames) | {name: np.full(len(frames), value) for name, value in self.style.amounts.items()}

    def _lay_out(self, parts: tuple[Part, ...]) -> table.Table:
        static = {part.id: part.loops for part in parts if part.loops}
        outlines = []
        for pose in (REST, _fit_pose()):
            pen = draw_live(self.style, self._columns(pose[None]))
            outlines.append(static | {name: pen.outlines(name) for name in self._live})
        return table.build(parts, outlines[0], outlines[1], bare=points.GROUP)

    def _turned(self) -> tuple[str, ...]:
        """The groups that move as a whole besides."""
        return "mouth", *(f"eye-{eye.name}" for eye in self.style.eyes)

    def _depths(self) -> list[Depth]:
        """How each anchor lies in the head: by its part's law, at a depth of its own where it has one."""
        d, table = self.style.d, self._table
        head = Head([(y / d, x / d) for x, y in self.style.outline], self.style.shell)
        lying = zip(table.owner, table.middle, table.deep, strict=True)
        laid = [(LAWS[law](x / d, y / d, head), z) for (_, law), (x, y), z in lying]
        return [depth if z is None else replace(depth, z=z) for depth, z in laid]

    def _following(self, parts: tuple[Part, ...]) -> Floats:
        """How much each part follows the head: as its layer does in the mean, which is what can be moved as a whole."""
        groups = {part.group for part in parts}
        mean = {group: self._turn.follow[self._rows_in(group, parts)].mean() for group in groups}
        return np.array([mean[part.group] for part in parts])

    def _rows_in(self, group: str, parts: tuple[Part, ...]) -> NDArray[np.intp]:
        """The rows of a group of parts."""
        rows = [self._table.rows[part.id] for part in parts if part.group == group]
        return np.concatenate([np.arange(each.start, each.stop) for each in rows])

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
            strength = signal(named, effect.signal)
            x[effect.rows] += effect.dx * strength
            y[effect.rows] += effect.dy * strength
        self._sway.move(x, y, named)
        forward[self._groups["mouth"]] += PUSHED_OUT * named["mouth.round"]
        self._place_eyes(x, y, forward, named)
        x, y = self._turn(x, y, forward, Pose.of(named, self.style.d))
        return x, y, pen

    def _place_eyes(self, x: Floats, y: Floats, forward: Floats, named: Columns) -> None:
        """Each eye shifts and grows on its own, about its middle, in depth too."""
        unit = CM * self.style.d
        for eye in self.style.eyes:
            rows = self._groups[f"eye-{eye.name}"]
            aside, up, size = place(named, eye, self.style.d)
            x[rows] = (x[rows] - eye.x) * size + (eye.x + unit * aside)
            y[rows] = (y[rows] - eye.y) * size + (eye.y - unit * up)
            deep = self._turn.z[rows]
            forward[rows] = forward[rows] * size + (deep - deep.max()) * (size - 1.0)

    def _tone(self, pen: Pen, named: Columns, count: int) -> Floats:
        opacity = np.repeat(self._opacity[None, :], count, axis=0)
        shaded = tones(self.style, lambda name: signal(named, name))
        for name, values in (shaded | pen.opacity).items():
            if name in self._slot:
                opacity[:, self._slot[name]] = values
        return opacity


def _fit_pose() -> Floats:
    pose = REST.copy()
    for name, value in FIT.items():
        pose[INDEX[name]] = value
    return pose
