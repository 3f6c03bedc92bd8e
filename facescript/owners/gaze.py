"""Who has a face's eyes and its head at a moment, and how far each look counts."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from facescript.ir.acts import Look, Scan
from facescript.motion.gaze.curves import Blend
from facescript.motion.gaze.track import GazeTrack
from facescript.owners.model import Part, Source, statement
from facescript.schedule.phrases import phrase
from facescript.schedule.score import FOREVER, Score, TimedAct
from facescript.space.plan import GazePlan

START = Source("look at camera: the scene's start")
"""Every scene begins with it."""


@dataclass(frozen=True, slots=True)
class Looks:
    """The movements of one part of the gaze in one scene, and the acts that made their plans."""

    blend: Blend
    plans: Sequence[GazePlan]
    acts: Mapping[int, TimedAct]

    def owner(self, time: float) -> Source:
        """The look that has the part: the latest that has set off."""
        last = bisect_right(self.blend.onsets.tolist(), time) - 1
        return START if last < 0 else self._source(last)

    def parts(self, time: float, axis: int) -> tuple[Part, ...]:
        """Where each look would have the part turned, deg (`axis` 0 yaw, 1 pitch), and its share of that (rule 5)."""
        at = np.array([time])
        laid = self.blend.laid(time)
        left, found = 1.0, []
        for index, weight in reversed(laid):
            share, movement = left * weight, self.blend.movements[index]
            under_way = "on its way" if time < movement.done else "there"
            state = under_way if left == 1.0 else "interrupted"
            if share:
                found.append(Part(self._source(index), float(movement.course(at)[0, axis]), share, state))
            left *= 1.0 - weight
        if left:
            state = "there" if left == 1.0 else "left behind"
            found.append(Part(START, float(self.blend.first(at)[0, axis]), left, state))
        return tuple(reversed(found))

    def _source(self, index: int) -> Source:
        plan = self.plans[index]
        act = self.acts[id(plan)]
        aim = phrase(Look(plan.aim))
        if plan.released == FOREVER and act.plan[0].released < FOREVER:
            return statement(act, f", over: {aim} again")
        return statement(act, f": {aim}" if isinstance(act.verb, Scan) else "")


def eyes(track: GazeTrack, score: Score, time: float) -> Looks:
    """The looks that move the line of sight."""
    scene = track.scene(time)
    return Looks(scene.eyes, scene.looks, _acts(score))


def head(track: GazeTrack, score: Score, time: float) -> Looks:
    """The looks that turn the head."""
    scene = track.scene(time)
    return Looks(scene.head, scene.turns, _acts(score))


def _acts(score: Score) -> dict[int, TimedAct]:
    return {id(plan): act for act in score.acts for plan in act.plan}
