"""The account of one channel at one moment: the steps of the blending law (`language.md` 9), in its order.

Each step asks the functions that performing asks (`motion.compose`, `motion.blend`), at the one moment.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from facescript.ir.play import Face
from facescript.motion.blend import ear_limit, eyes_within, gesture_left, lid_drawn, lid_limit, lid_opening
from facescript.motion.compose import (
    Asked,
    blinks_drawn,
    compose,
    eyes_on_sight,
    eyes_wanted,
    head_pose,
    lips_pressed,
    pulled,
    sight_meant,
)
from facescript.motion.drivers import ROWS, Drive, Floats
from facescript.motion.gaze.eyes import converged, in_head
from facescript.motion.perform import FaceMotion
from facescript.owners import gaze, sources
from facescript.owners.model import Account, Part, Source, Step, statement
from facescript.owners.mouth import Lines, shapes
from facescript.performance.channels import INDEX, POSE, SIDES, Channel
from facescript.performance.limits import soft_limit
from facescript.schedule.score import Score

AXES = ("yaw", "pitch", "roll")

HEAD, EYES = range(2)
"""What a take turns, as `motion.recorded` counts it."""


class Accounts:
    """The accounts of one face; its motion is made once for all of them."""

    def __init__(self, score: Score, face: Face) -> None:
        self.score, self.face = score, face
        self._motion = FaceMotion(score, face)
        self._lines = Lines(score, face.name)

    def at(self, name: str, time: float) -> Account:
        """The account of the channel `name` at `time` (s). Its last value is what `Performance.sample` gives."""
        moment = self._moment(time)
        channel = POSE[INDEX[name]]
        owner, steps = self._told(channel, moment)
        return Account(self.face.name, channel, time, owner, (*steps, Step("drawn", moment.drawn(name))))

    def _moment(self, time: float) -> Moment:
        at = np.array([time])
        asked = self._motion.asked(at)
        drive = asked.sum
        return Moment(time, asked, drive, np.ascontiguousarray(head_pose(asked.head, drive).T), compose(asked))

    def _told(self, channel: Channel, moment: Moment) -> tuple[Source | None, list[Step]]:
        kind, _, rest = channel.name.partition(".")
        axis = channel.name.rpartition(".")[2]
        if kind == "gaze" or (kind == "eye" and axis in AXES):
            steps = self._sight(channel, moment) if kind == "gaze" else self._eye(channel, moment)
            looks = gaze.eyes(self._motion.gaze, self.score, moment.time)
            return self._take(EYES, moment) or looks.owner(moment.time), list(steps)
        if kind == "head" and axis in AXES:
            steps = self._head(channel, moment)
            looks = gaze.head(self._motion.gaze, self.score, moment.time)
            return self._take(HEAD, moment) or looks.owner(moment.time), list(steps)
        base = sources.base(self._motion.scene(moment.time), ROWS[channel.name], moment.time)
        if kind == "mouth":
            speaks = self._lines.near(moment.time) if moment.asked.activity[0] > 0.0 else None
            return speaks or base, list(self._mouth(rest, moment))
        if kind == "lid":
            return base, list(self._lid(rest, moment))
        return base, list(self._sum(channel, moment))

    def _take(self, part: int, moment: Moment) -> Source | None:
        """The take that turns head or eyes."""
        scene = self._motion.scene(moment.time)
        act = scene.recorded.turning(part, moment.time) if scene is not None else None
        return None if act is None else statement(act)

    # -------------------------------------------------------------------------------------- what only adds

    def _sum(self, channel: Channel, moment: Moment) -> Iterator[Step]:
        """Muscles and what is moved or sized: a sum, and its limit."""
        row = ROWS[channel.name]
        total = float(moment.drive[row, 0])
        if channel.rest:
            yield Step(f"{channel.rest:g} at rest, and the sum", channel.rest + total, self._parts(row, moment))
        else:
            yield Step("sum", total, self._parts(row, moment))
        if channel.unit == "1" and not channel.rest:
            limit = ear_limit if channel.name.startswith("ear.") else soft_limit
            yield Step("soft limit", float(limit(moment.drive[row])[0]))

    def _parts(self, row: int, moment: Moment) -> tuple[Part, ...]:
        return sources.asked(self._motion.scene(moment.time), row, moment.time)

    # -------------------------------------------------------------------------------------- lids

    def _lid(self, side: str, moment: Moment) -> Iterator[Step]:
        """Rules 1 and 2."""
        row = ROWS[f"lid.{side}"]
        lid, number = lid_limit(moment.drive[row]), SIDES.index(side)
        blink = blinks_drawn(moment.asked)[number]
        pitch = moment.wanted[:, number, 1]
        yield Step("sum", float(moment.drive[row, 0]), self._parts(row, moment))
        yield Step("soft limit, and no wider than the floor", float(lid[0]))
        blinking = self._parts(ROWS[f"blink.{side}"], moment)
        left = f"times what blinks leave open, {1.0 - float(blink[0]):.4g}"
        yield Step(left, 1.0 - float(lid_opening(lid, blink)[0]), blinking)
        turned = Part(Source(f"deg of eye.{side}.pitch, before a blink pulls it"), float(pitch[0]), 1.0)
        parts = (turned,) if turned.full else ()
        yield Step("moved with the eye up and down", float(lid_drawn(lid, blink, pitch)[0]), parts)

    # -------------------------------------------------------------------------------------- head, eyes, gaze

    def _head(self, channel: Channel, moment: Moment) -> Iterator[Step]:
        """Rules 5 and 6."""
        row, axis = ROWS[channel.name], AXES.index(channel.name.rpartition(".")[2])
        added = float(moment.drive[row, 0])
        rolled = moment.asked.turned
        turned = 0.0 if rolled is None else float(rolled.head[0, 2] * rolled.head_share[0])
        if axis < 2:
            parts = gaze.head(self._motion.gaze, self.score, moment.time).parts(moment.time, axis)
            yield Step("turned by gaze", float(self._motion.gaze.head(np.array([moment.time]))[0, axis]), parts)
            turned = float(moment.asked.head[0, axis])
            added += turned
        yield from self._taken(HEAD, turned, moment)
        at = np.array([moment.time])
        left = gesture_left(self._motion.gaze.turning(at, self._motion.gaze.head(at)))
        parts = sources.asked(self._motion.scene(moment.time), row, moment.time, float(left[0]))
        yield Step("and the sum of what is added", added, parts)
        yield Step("within the head's reach", float(moment.head[0, axis]))

    def _sight(self, channel: Channel, moment: Moment) -> Iterator[Step]:
        """The line of sight, and what the eyes make of it."""
        axis = AXES.index(channel.name.rpartition(".")[2])
        yield from self._meant(channel.name, axis, moment)
        names = [f"{part}.{AXES[axis]}" for part in ("eye.left", "eye.right", "head")]
        parts = tuple(Part(Source(name), moment.drawn(name), 1.0) for name in names)
        yield Step("where both eyes point together, as drawn", moment.drawn(channel.name), parts)

    def _meant(self, name: str, axis: int, moment: Moment) -> Iterator[Step]:
        """Where the line of sight is meant to point, in the room (rules 5 and 6)."""
        looks = gaze.eyes(self._motion.gaze, self.score, moment.time)
        yield Step("the line of sight", float(moment.asked.sight[0, axis]), looks.parts(moment.time, axis))
        moved = self._parts(ROWS[f"gaze.{AXES[axis]}"], moment)
        if moved:
            yield Step("moved by life", float(moment.sight[0, axis]), moved)

    def _eye(self, channel: Channel, moment: Moment) -> Iterator[Step]:
        """Rule 6: the eye turns by what the head leaves to it, converges, and stays within its reach."""
        _, side, name = channel.name.split(".")
        number, axis, row = SIDES.index(side), AXES.index(name), ROWS[channel.name]
        looking = replace(moment.asked, turned=None)
        seen = float(eyes_on_sight(looking, moment.drive, moment.head)[0, number, axis])
        if axis < 2:
            yield from self._meant(channel.name, axis, moment)
            yield self._in_head(axis, moment)
            near = f"converging at {moment.sight[0, 2]:.4g} cm"
            yield Step(near, float(converged(moment.sight, moment.head)[axis][0, number]))
            yield Step("within the eye's reach", seen)
        else:
            yield Step("Listing's roll, brought about by yaw and pitch", seen)
        turned = float(eyes_on_sight(moment.asked, moment.drive, moment.head)[0, number, axis])
        yield from self._taken(EYES, turned, moment)
        own = self._parts(row, moment)
        yield Step("and the sum of the eye's own terms", float(moment.wanted[0, number, axis]), own)
        yield from self._pulled(side, axis, moment)

    def _taken(self, part: int, value: float, moment: Moment) -> Iterator[Step]:
        """What a take makes of a turn of the head or an eye, where one is played."""
        source = self._take(part, moment)
        if source is not None and moment.asked.turned is not None:
            share = (moment.asked.turned.head_share, moment.asked.turned.eye_share)[part][0]
            yield Step(f"{share:.1%} of the way to where a take has it", value, (Part(source, value, 1.0),))

    def _in_head(self, axis: int, moment: Moment) -> Step:
        """The line of sight in the head, which may be turned in three ways."""
        turned = tuple(Part(Source(f"head.{name}"), moment.drawn(f"head.{name}"), 1.0) for name in AXES)
        seen = float(in_head(moment.sight, moment.head)[axis][0])
        return Step("as seen from the head", seen, tuple(part for part in turned if part.full))

    def _pulled(self, side: str, axis: int, moment: Moment) -> Iterator[Step]:
        """What a blink turns, and the end of the eye's reach."""
        number = SIDES.index(side)
        if axis == 2:
            return
        both = blinks_drawn(moment.asked)
        turned = pulled(moment.wanted, both)
        blinking = self._parts(ROWS[f"blink.{side}"], moment)
        if blinking:
            yield Step("pulled down and in by a blink", float(turned[0, number, axis]), blinking)
        yield Step("within the ellipse of its reach", float(eyes_within(turned)[0, number, axis]))

    # -------------------------------------------------------------------------------------- mouth

    def _mouth(self, part: str, moment: Moment) -> Iterator[Step]:
        """Rules 3 and 4."""
        row, active = ROWS[f"mouth.{part}"], float(moment.asked.activity[0])
        column = row - ROWS["mouth.open"]
        yield Step("shown", float(moment.drive[row, 0]), self._parts(row, moment))
        spoken = float(moment.asked.spoken[0, column])
        yield Step("spoken", spoken, shapes(self._motion.mouth, part, moment.time, self._lines))
        if part in ("open", "jaw"):
            pressed = float(lips_pressed(moment.drive)[0])
            law = f"speech owns it by {active:.1%}; what is shown widens, lips pressed by {pressed:.1%} narrow it"
            yield Step(law, moment.drawn(f"mouth.{part}"))
        else:
            yield Step("both together", moment.drawn(f"mouth.{part}"))


@dataclass(frozen=True, slots=True)
class Moment:
    """What is asked at `time`: one column of each array; `head` is array[1, 3] and `pose` array[1, channel], drawn."""

    time: float
    asked: Asked
    drive: Drive
    head: Floats
    pose: Floats

    @property
    def sight(self) -> Floats:
        return sight_meant(self.asked, self.drive)

    @property
    def wanted(self) -> Floats:
        return eyes_wanted(self.asked, self.drive, self.head)

    def drawn(self, name: str) -> float:
        return float(self.pose[0, INDEX[name]])
