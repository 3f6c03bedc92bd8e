"""How far eyes and head turn: a direction to the head's pose that lets the eyes reach it, and what stays out of reach.

Directions are (yaw, pitch) in deg, yaw + to the viewer's right, pitch + up. The eyes' reach is an ellipse a quadrant
(motion.md section 1, "oculomotor range"; bar S8), the head's a range an axis (`language.md`, "Gaze").
"""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, asin, atan2, cos, degrees, hypot, radians, sin, tanh
from typing import Protocol

from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic, Diagnostics, Related
from facescript.diagnostics.wording import tell
from facescript.ir.play import Face, Target
from facescript.ir.values import Aim, AtFace, AtTarget
from facescript.space.direction import angles, towards
from facescript.space.plan import GazePlan
from facescript.text import Span

EYE_SIDE, EYE_UP, EYE_DOWN = 45.0, 28.0, 47.0
HEAD_SIDE, HEAD_UP = 45.0, 30.0

EASY, FULL = 0.75, 0.9
"""Beyond `EASY` of their reach the eyes are helped by the head; what they are left never exceeds `FULL` of it."""

EYE_KNEE, EYE_END = 0.92, 0.9945
"""From the first part of their reach on the eyes are slowed, so that they come to the second without a jolt."""

ROUGH = 0.1
"""As a part of the eyes' reach: by less than this do differences of angles miss how far they are turned in the head."""

HEAD_SOFT = 0.9
"""The part of the head's range that it uses freely; the rest it approaches softly."""

Direction = tuple[float, float]


class Planned(Protocol):
    """An act with the gaze shifts planned for it."""

    @property
    def plan(self) -> tuple[GazePlan, ...]: ...

    @property
    def span(self) -> Span: ...

    @property
    def estimated(self) -> bool: ...


class Scored(Protocol):
    """What of a score is needed here: its acts, and what they may look at."""

    @property
    def acts(self) -> Sequence[Planned]: ...

    @property
    def faces(self) -> Sequence[Face]: ...

    @property
    def targets(self) -> Sequence[Target]: ...


ALONE = {"eyes only": ("eyes", "stay"), "head only": ("head", "stays")}
"""The part a shift has to do with, and what it does."""


def reach(score: Scored, diagnostics: Diagnostics) -> None:
    """Warn of every target that stays out of reach, once a place in the script, with the worst angle, when that is,
    and where the target is said to be (FS6xx)."""
    worst: dict[Span, tuple[GazePlan, bool]] = {}
    for act in score.acts:
        for plan in act.plan:
            if act.span in worst:
                bad = plan.unreachable > worst[act.span][0].unreachable
            else:
                bad = plan.lost or plan.unreachable > 0.0
            if bad:
                worst[act.span] = plan, act.estimated
    for span, (plan, rough) in worst.items():
        diagnostics.add(_missed(plan, span, tell(plan.worst, rough), _said(score, plan.aim)))


def _missed(plan: GazePlan, span: Span, time: str, said: tuple[Related, ...]) -> Diagnostic:
    """What is said of a shift that stays short of its target, most so at `time`."""
    short = f"{plan.unreachable:.0f}deg"
    if plan.unreachable == 0.0:
        return diagnose("FS604", span, related=said)
    if plan.parts in ALONE:
        part, verb = ALONE[plan.parts]
        return diagnose("FS602", span, related=said, time=time, part=part, stay=verb, short=short)
    return diagnose("FS603" if plan.at_times else "FS601", span, related=said, time=time, short=short)


def _said(score: Scored, aim: Aim) -> tuple[Related, ...]:
    """Where the script says what is looked at; directions stand in the look itself."""
    if isinstance(aim, AtTarget):
        return tuple(Related(target.span, "the target") for target in score.targets if target.name == aim.name)
    if isinstance(aim, AtFace):
        return tuple(Related(face.span, "the face that is looked at") for face in score.faces if face.name == aim.face)
    return ()


def extent(eye: Direction) -> float:
    """How far the eyes are turned in the head, as a part of their reach: 1 on the ellipse."""
    return hypot(eye[0] / EYE_SIDE, eye[1] / (EYE_UP if eye[1] > 0 else EYE_DOWN))


def within(direction: Direction, margin: float = 0.0) -> Direction:
    """The direction itself, or where it lies beyond what eyes and head together reach, the end of that; `margin` is by
    how many degrees less they reach."""
    side, up, down = HEAD_SIDE + EYE_SIDE - margin, HEAD_UP + EYE_UP - margin, HEAD_UP + EYE_DOWN - margin
    return min(side, max(-side, direction[0])), min(up, max(-down, direction[1]))


def in_head(direction: Direction, head: Direction) -> Direction:
    """A direction of the room as the eyes' in a head that is turned by yaw, then pitch."""
    x, y, z = towards(direction[0] - head[0], direction[1])
    p = radians(head[1])
    return angles(x, y * cos(p) - z * sin(p), y * sin(p) + z * cos(p))


def in_room(eye: Direction, head: Direction) -> Direction:
    """The eyes' direction in the head as a direction of the room, the inverse of `in_head`."""
    x, y, z = towards(*eye)
    p = radians(head[1])
    yaw, pitch = angles(x, y * cos(p) + z * sin(p), z * cos(p) - y * sin(p))
    return yaw + head[0], pitch


def head_goal(direction: Direction, share: Direction, start: Direction = (0.0, 0.0)) -> Direction:
    """Where the head turns for `direction`: from `start` by its share of the way, and further where the eyes would
    not reach; never beyond its range. Smooth in `direction`."""
    head = start[0] + share[0] * (direction[0] - start[0]), start[1] + share[1] * (direction[1] - start[1])
    head = _in_range(head)
    if extent((direction[0] - head[0], direction[1] - head[1])) <= EASY - ROUGH:
        return head
    eye = in_head(direction, head)
    turned = extent(eye)
    if turned <= EASY:
        return head
    eased = soft(turned, EASY, FULL) / turned
    return _in_range(_head_for(direction, (eye[0] * eased, eye[1] * eased)))


def shortfall(direction: Direction, head: Direction) -> float:
    """By how many degrees the eyes in a head that is turned to `head` stay short of `direction`."""
    eye = in_head(direction, head)
    turned = extent(eye)
    if turned <= 1.0:
        return 0.0
    reached = towards(*in_room((eye[0] / turned, eye[1] / turned), head))
    cosine = sum(a * b for a, b in zip(reached, towards(*direction), strict=True))
    return degrees(acos(min(1.0, max(-1.0, cosine))))


def soft(value: float, knee: float, limit: float) -> float:
    """`value` up to `knee`, above it bent so that it never exceeds `limit`; its slope is continuous."""
    if value <= knee:
        return value
    return knee + (limit - knee) * tanh((value - knee) / (limit - knee))


def _in_range(head: Direction) -> Direction:
    return _axis(head[0], HEAD_SIDE), _axis(head[1], HEAD_UP)


def _axis(angle: float, limit: float) -> float:
    bent = soft(abs(angle), HEAD_SOFT * limit, limit)
    return bent if angle >= 0 else -bent


def _head_for(direction: Direction, eye: Direction) -> Direction:
    """The head's yaw and pitch with which eyes turned by `eye` in it look in `direction`."""
    x, y, z = towards(*eye)
    height = sin(radians(direction[1]))
    tilt = asin(min(1.0, max(-1.0, height / hypot(y, z)))) - atan2(y, z)
    ahead = z * cos(tilt) - y * sin(tilt)
    return direction[0] - degrees(atan2(x, ahead)), degrees(tilt)
