"""What a face looks at to where it is: the direction of each look's target, as long as the look has the eyes."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import inf

from facescript.ir.play import Face
from facescript.ir.values import AtCamera
from facescript.motion.gaze.aims import in_effect
from facescript.plot.axis import Scale
from facescript.schedule.score import Score
from facescript.space.plan import GazePlan
from facescript.space.room import Room

Course = tuple[tuple[float, tuple[float, float]], ...]
"""Times (s) and directions (yaw, pitch in deg) of one target while it is looked at."""


def targets(score: Score, face: Face, scale: Scale) -> Iterator[Course]:
    """The targets one after another; one that moves has a point a column. What a look covered comes back as another."""
    room = Room(score.film, score.faces, score.targets)
    for number, scene in enumerate(score.scenes):
        acts = [act for act in score.acts if act.face == face.name and act.scene == number]
        planned = [(plan.starts, act.order, plan) for act in acts for plan in act.plan if plan.uses_eyes]
        plans = in_effect(
            (plan for _, _, plan in sorted(planned, key=lambda each: each[:2])), lambda plan: plan.eye_onset
        )
        rest = GazePlan(AtCamera(), "eyes then head", scene.start, scene.start, scene.start, scene.start, (0, 0), 0)
        onsets = [*(plan.eye_onset for plan in plans), inf]
        for plan, (start, end) in zip([rest, *plans], pairwise([scene.start, *onsets]), strict=True):
            start, end = max(start, scale.start), min(end, scene.end, scale.end)
            if start < end:
                yield tuple(_course(room, face, plan, scene.start, start, end, scale))


def _course(
    room: Room, face: Face, plan: GazePlan, clock: float, start: float, end: float, scale: Scale
) -> Iterator[tuple[float, tuple[float, float]]]:
    count = max(1, round((end - start) * scale.second)) if room.moving(plan.aim) else 1
    for number in range(count + 1):
        time = start + (end - start) * number / count
        sight = room.sight(face.name, plan.aim, time - clock)
        yield time, (sight.yaw, sight.pitch)
