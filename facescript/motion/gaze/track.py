"""A score to one face's gaze over time: where the line of sight points, how near it converges, where the head turns."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise, zip_longest
from math import inf

import numpy as np
from numpy.typing import NDArray

from facescript.ir.play import Face
from facescript.motion.gaze.aims import Bound, Until, in_effect, rest
from facescript.motion.gaze.curves import Blend, Course, Movement, minimum_jerk_curve, saccade_curve
from facescript.motion.gaze.eyes import eyes, midline, within_reach
from facescript.schedule.score import Score
from facescript.space.main_sequence import VERGENCE_TIME, vergence_share
from facescript.space.plan import GazePlan
from facescript.space.room import FARTHEST_CM, Room

__all__ = ["GazeTrack", "eyes", "midline"]

Floats = NDArray[np.float64]

AFTERWARDS = 1.0
"""For so long after its scene's end it is still worked out how a target is followed, s."""


BEFORE = 0.002
"""How long before a time the head is looked at for its speed, s."""


class GazeTrack:
    """One face's gaze as a function of time; no state, any times in any order."""

    def __init__(self, score: Score, face: Face, before: GazeTrack | None = None) -> None:
        """What was worked out for the same room `before`, of shifts that stay as they are, is not worked out again."""
        self._stage = score.film, score.faces, score.targets
        same = before is not None and before._stage == self._stage and not before.room.live
        self.room: Room = before.room if before is not None and same else Room(*self._stage)
        known = {one.start: one.bounds for one in before.scenes} if before is not None and same else {}
        acts = [act for act in score.acts if act.face == face.name and act.plan]
        self.starts = np.array([scene.start for scene in score.scenes] or [0.0])
        self.scenes: list[SceneGaze] = []
        for number, start in enumerate(self.starts):
            planned = [(plan.starts, act.order, plan) for act in acts if act.scene == number for plan in act.plan]
            plans = [plan for _, _, plan in sorted(planned, key=lambda each: each[:2])]
            end = score.scenes[number].end + AFTERWARDS if score.scenes else inf
            there = self.room.of(float(start))
            self.scenes.append(SceneGaze(there, face, float(start), end, plans, known.get(float(start), {})))

    def sight(self, times: Floats) -> Floats:
        """array[n, 3]: yaw and pitch (deg) of the line of sight as drawn, and the distance (cm) of convergence."""
        return self._sample(times, lambda scene, some: scene.sight(some), 3)

    def head(self, times: Floats) -> Floats:
        """array[n, 2]: yaw and pitch (deg) of the head."""
        return self._sample(times, lambda scene, some: scene.head.at(some), 2)

    def turning(self, times: Floats, head: Floats) -> Floats:
        """How fast gaze turns the head, which at `times` is at `head` (array[n, 2]): array[n], deg/s."""
        way = head - self.head(times - BEFORE)
        speed: Floats = np.hypot(way[:, 0], way[:, 1]) / BEFORE
        return speed

    def scene(self, time: float) -> SceneGaze:
        """The scene that plays at `time`."""
        return self.scenes[int(np.searchsorted(self.starts[1:], time, side="right"))]

    def _sample(self, times: Floats, values: Callable[[SceneGaze, Floats], Floats], width: int) -> Floats:
        order = np.argsort(times, kind="stable")
        some = np.asarray(times, dtype=np.float64)[order]
        out = np.empty((len(some), width))
        cuts = [0, *np.searchsorted(some, self.starts[1:]), len(some)]
        for scene, low, high in zip(self.scenes, cuts, cuts[1:], strict=False):
            if high > low:
                out[order[low:high]] = values(scene, some[low:high])
        return out


class SceneGaze:
    """One scene of one face: its shifts laid over one another, for the line of sight, its nearness and the head.

    `looks` and `turns` are the plans of the movements of `eyes` and of `head`, one each; `bounds` is what they are
    bound for.
    """

    def __init__(
        self, room: Room, face: Face, start: float, end: float, plans: list[GazePlan], known: Mapping[GazePlan, Bound]
    ) -> None:
        """Of the bounds that are `known` those are taken whose shift has eyes and head as long as it had."""
        eyes = in_effect((plan for plan in plans if plan.uses_eyes), lambda plan: plan.eye_onset)
        head = in_effect((plan for plan in plans if plan.uses_head), lambda plan: plan.head_onset)
        untils = _untils(eyes, head, end)
        bounds: dict[int, Bound] = {}
        for plan in (*eyes, *head):
            until, bound = untils[id(plan)], known.get(plan)
            bounds[id(plan)] = bound if bound and bound.until == until else Bound(room, face, start, plan, until)
        self.start, self.bounds = start, {bound.plan: bound for bound in bounds.values()}
        self.looks, self.turns = eyes, head
        first = rest(room, face, start)
        targets = [first, *(bounds[id(plan)] for plan in eyes)]
        self.head = Blend(first.head, [_turn(bounds[id(plan)]) for plan in head])
        self.nearness = Blend(first.nearness, [_vergence(before, bound) for before, bound in pairwise(targets)])
        self.eyes = Blend(self._reached(first.eyes), [_saccade(each, self._reached(each.eyes)) for each in targets[1:]])

    def _reached(self, course: Course) -> Course:
        """A course of the line of sight as far as the eyes can follow it from where the head is."""
        return lambda times: within_reach(course(times), self.head.at(times), self.nearness.at(times)[:, 0])

    def sight(self, times: Floats) -> Floats:
        nearness = np.maximum(self.nearness.at(times), 1.0 / FARTHEST_CM)
        return np.concatenate([self.eyes.at(times), 1.0 / nearness], axis=1)


def _untils(eyes: list[GazePlan], head: list[GazePlan], end: float) -> dict[int, Until]:
    """Until when each plan has eyes and head, by its identity; nothing of it is left after its scene's `end`."""
    found = {id(plan): Until() for plan in (*eyes, *head)}
    for plan, after in zip_longest(eyes, eyes[1:]):
        until = found[id(plan)]
        until.eyes = after.eye_onset if after else inf
        until.gone = min(end, after.eye_done + VERGENCE_TIME if after else inf)
    for plan, after in zip_longest(head, head[1:]):
        until = found[id(plan)]
        until.head = after.head_onset if after else inf
        until.gone = min(end, max(until.gone, after.head_done if after else inf))
    return found


def _saccade(bound: Bound, course: Course) -> Movement:
    onset, done = bound.plan.eye_onset, bound.plan.eye_done
    return Movement(onset, done, lambda times: saccade_curve(times, onset, done), course)


def _turn(bound: Bound) -> Movement:
    onset, done = bound.plan.head_onset, bound.plan.head_done
    return Movement(onset, done, lambda times: minimum_jerk_curve(times, onset, done), bound.head)


def _vergence(before: Bound, bound: Bound) -> Movement:
    """The eyes converge anew: in part with the saccade, and slowly for the rest (bar V2)."""
    plan = bound.plan
    onset, landed = plan.eye_onset, plan.eye_done
    done = onset if plan.instant else max(landed, onset + VERGENCE_TIME)
    converging = bound.sight(onset).distance < before.sight(onset).distance
    share = vergence_share(plan.amplitude, converging)

    def weight(times: Floats) -> Floats:
        slow = minimum_jerk_curve(times, onset, done)
        return slow + share * (saccade_curve(times, onset, landed) - slow)

    return Movement(onset, done, weight, bound.nearness)
