"""A solved stretch of a scene to how things are at its end: whether it could as well be all there is."""

from __future__ import annotations

from facescript.ir.acts import Add, At, Drop, Show
from facescript.schedule.defaults import seconds
from facescript.schedule.looks import Gaze
from facescript.schedule.part import Calm, Written
from facescript.schedule.round import Round
from facescript.schedule.score import FOREVER, TimedAct
from facescript.schedule.steps import NEVER, SETTLED

BEFORE = 1e-4
"""Seconds before the end of a stretch by which all that it does has begun: more than what two starts are one within."""


def calm(solved: Round, written: Written, gaze: Gaze) -> Calm:
    """How things are when a stretch has settled."""
    end, acts = solved.end, written.acts
    last = next(
        (child for child in reversed(solved.scenes[0].root.top.inside()) if not isinstance(child.node, At)), None
    )
    over = (
        last is not None
        and last.time(SETTLED) == end < NEVER
        and gaze.still <= end - BEFORE
        and all(_over(act, end) for act in acts)
        and all(line.end <= end for line in written.lines)
    )
    sound = all(act.start >= 0.0 for act in acts) and all(block.start >= 0.0 for block in written.blocks)
    return Calm(sound, over, tuple(gaze.left.items()))


def _over(act: TimedAct, end: float) -> bool:
    """Whether an act has begun, come to its apex and, if it does, let go."""
    rise = 0.0
    if isinstance(act.verb, (Show, Add, Drop)):
        rise = min(seconds(act.verb.timing.over), act.released - act.start)
    released = act.released <= end or act.released == FOREVER
    return act.start < end - BEFORE and act.settled <= end and act.start + rise <= end and released
