"""Turns a life into what eyes that hold a target do: microsaccades about it, and slow drift between them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import cos, pi, sin

from facescript.motion.life.fixations import TARGET, Fixation, Offset
from facescript.motion.life.model import Living
from facescript.motion.life.renewal import Span, log_normal_wait, renewals
from facescript.motion.life.stretches import Stretches

NEAREST, FURTHEST = 0.15, 0.28
"""Deg from the target that a microsaccade lands (ours: with the drift they are of 0.15 to 0.96 deg; bar M1)."""

SLOWEST, FASTEST, STRAY = 0.1, 0.26, 0.4
"""Mean deg/s of a drift, at its peak not twice that (0.1 to 0.5; `motion.md` 1), and how far one goes at most, deg."""

VARIATION = 0.5
"""Coefficient of variation of the time between microsaccades (ours)."""

SHORTEST = 0.15
"""Seconds between them on average at least, and from the last to a gaze shift: no knob makes a tremor of them."""

BEYOND = 60.0
"""Seconds after a life's end in which the one is found that its last drift is bound for."""

LENGTH = 0.028
"""Seconds that the longest takes, to a millisecond (bar S1)."""


def microsaccades(life: Living, closed: Stretches) -> Iterator[Fixation]:
    """Fixations within a degree of the target, at the rate of the knob `saccades` (1/min); none begins in `closed`."""
    rate = life.knob("saccades")
    if rate <= 0.0:
        return
    wait = log_normal_wait(max(60.0 / rate - LENGTH, SHORTEST), VARIATION)
    span = Span(life.start, life.end + BEYOND)
    here, memory = TARGET, life.memory
    first, here = before = (memory.state(life.dice, "drift") if memory else None) or (0, TARGET)
    found = renewals(life.dice, "saccades", wait, span, lambda _: LENGTH, closed, SHORTEST, memory)
    for item, after in pairwise(found):
        if item.start >= life.end:
            return
        if item.index < first:
            continue
        if memory is not None:
            memory.note(life.dice, "drift", item.start, before)
            before = item.index, here
        landed = _back(life, item.index, here)
        here = _drifted(life, item.index, landed, after.start - item.start)
        yield Fixation(item.start, landed, here, after.start)


def _back(life: Living, number: int, here: Offset) -> Offset:
    """Where a microsaccade lands that corrects a drift to `here`: near the target, on its other side."""
    far = life.dice.between(NEAREST, FURTHEST, "saccades", number, "far")
    yaw, pitch = _polar(far, life.dice.chance("saccades", number, "turn"))
    return (-yaw, -pitch) if yaw * here[0] + pitch * here[1] > 0.0 else (yaw, pitch)


def _drifted(life: Living, number: int, landed: Offset, lasting: float) -> Offset:
    speed = life.dice.between(SLOWEST, FASTEST, "saccades", number, "drift")
    yaw, pitch = _polar(min(STRAY, speed * lasting), life.dice.chance("saccades", number, "drift turn"))
    return landed[0] + yaw, landed[1] + pitch


def _polar(far: float, turn: float) -> Offset:
    return far * cos(2.0 * pi * turn), far * sin(2.0 * pi * turn)
