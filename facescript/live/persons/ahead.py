"""A score to the next shift of gaze that was planned ahead by where somebody was expected then: plan it again."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf

from facescript.ir.values import AtTarget
from facescript.schedule.score import Score
from facescript.space.live import LiveTarget
from facescript.space.plan import GazePlan

BEHIND = 3
"""A shift hangs on where somebody is whom it goes to, or whom one of so many before it went to."""


def next_shift(score: Score, after: float) -> float:
    """When the first such shift begins after a time, s; inf where there is none."""
    live = {target.name for target in score.targets if isinstance(target, LiveTarget)}
    if not live:
        return inf
    faces = {act.face for act in score.acts if act.plan}
    return min((first for face in faces for first in _ahead(score, face, live, after)), default=inf)


def _ahead(score: Score, face: str | None, live: set[str], after: float) -> Iterator[float]:
    """The first shift of a face after a time that hangs on one of those who are seen live."""
    plans = sorted((plan for act in score.acts if act.face == face for plan in act.plan), key=_starts)
    at_live = [isinstance(plan.aim, AtTarget) and plan.aim.name in live for plan in plans]
    for number, plan in enumerate(plans):
        if plan.starts > after and any(at_live[max(0, number - BEHIND) : number + 1]):
            yield plan.starts
            return


def _starts(plan: GazePlan) -> float:
    return plan.starts
