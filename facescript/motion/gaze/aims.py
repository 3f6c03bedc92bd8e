"""A planned shift to what eyes and head are bound for: a place once and for all, or a target that is followed."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf

import numpy as np
from numpy.typing import NDArray

from facescript.ir.play import Face
from facescript.ir.values import AtCamera
from facescript.motion.gaze.curves import still
from facescript.motion.gaze.live import LiveFollowing, followed
from facescript.motion.gaze.pursuit import AFTER, STEP, Following, Spell, follow
from facescript.space.live import LiveTarget
from facescript.space.plan import GazePlan
from facescript.space.reach import head_goal, within
from facescript.space.room import Room, Sight

Floats = NDArray[np.float64]


@dataclass(slots=True)
class Until:
    """Until when a plan has the eyes, and the head, and when nothing of it is left, seconds of the film."""

    eyes: float = inf
    head: float = inf
    gone: float = 0.0


class Bound:
    """What one plan is bound for, as courses over the film's time; a pursuit is worked out when first asked for."""

    def __init__(self, room: Room, face: Face, scene: float, plan: GazePlan, until: Until) -> None:
        self.room, self.face, self.scene, self.plan, self.until = room, face, scene, plan, until

    def sight(self, time: float) -> Sight:
        """The line of sight to the target itself, or to where it was in sight last, at a time of the film."""
        sight = self._followed(time - self.scene)
        direction = sight.yaw, sight.pitch
        kept = within(direction)
        return sight if kept == direction else Sight(*kept, sight.distance)

    @cached_property
    def _followed(self) -> Callable[[float], Sight]:
        return self.room.following(self.face.name, self.plan.aim)

    def eyes(self, times: Floats) -> Floats:
        """array[n, 2]: yaw and pitch of the line of sight."""
        return self._following.eyes(times)

    def head(self, times: Floats) -> Floats:
        """array[n, 2]: yaw and pitch of the head."""
        return self._following.head(times)

    def nearness(self, times: Floats) -> Floats:
        """array[n, 1]: 1/distance (1/cm) at which the eyes converge."""
        return self._following.nearness(times)

    @cached_property
    def _following(self) -> Following | LiveFollowing:
        moving = self.room.moving(self.plan.aim)
        plan, until, start = self.plan, self.until, self.plan.starts
        spell = Spell(start, plan.eye_onset, plan.eye_done, plan.head_done, until.eyes, until.head)
        if isinstance(moving, LiveTarget):
            return self._followed_live(moving, spell)
        if moving and start < (last := self.scene + moving.times[-1] + AFTER):
            return follow(self.sight, self._head_goal, spell, min(last, until.gone))
        sight = self.sight(start)
        place = sight.yaw, sight.pitch
        return Following(still(place), [], still(self._head_goal(place)), still([1.0 / sight.distance]))

    def _followed_live(self, target: LiveTarget, spell: Spell) -> LiveFollowing:
        """What was worked out for the same shift, by a performance that knew less, counts on. The head is taken
        elsewhere a step later: the course through its steps turns a step before the first that differs."""
        plan, trail = self.plan, target.trail
        spell = replace(spell, head_until=spell.head_until + STEP)
        head = plan.parts, plan.head_onset, plan.head_share, plan.head_from
        key = (self.face.name, self.scene, *head, spell.start, spell.leave, spell.landed, spell.turned)
        return followed(target, key, spell, lambda: LiveFollowing(trail, self.sight, self._head_goal, spell))

    def _head_goal(self, direction: tuple[float, float]) -> tuple[float, float]:
        return head_goal(direction, self.plan.head_share, self.plan.head_from)


def rest(room: Room, face: Face, scene: float) -> Bound:
    """What every scene begins with: the camera."""
    plan = GazePlan(AtCamera(), "eyes then head", scene, scene, scene, scene, (0.0, 0.0), 0.0)
    return Bound(room, face, scene, plan, Until(scene, scene, scene))


def in_effect(plans: Iterable[GazePlan], onset: Callable[[GazePlan], float]) -> list[GazePlan]:
    """The plans without those that a later one overtakes before they set off."""
    kept: list[GazePlan] = []
    for plan in plans:
        while kept and onset(kept[-1]) >= plan.starts:
            kept.pop()
        kept.append(plan)
    return kept
