"""Turns a life into the small saccades of idle eyes about their target."""

from __future__ import annotations

from collections.abc import Iterable
from math import cos, pi, sin

from facescript.motion.dice import events
from facescript.motion.life_model import Living, Moved, moved, steps
from facescript.space.main_sequence import saccade_time

NEAREST, FURTHEST = 0.2, 0.5
"""Deg from the target that an idle fixation strays: the saccades between are 0.28 to 1 deg (bar M1)."""

VARIATION = 0.5
"""Coefficient of variation of the time between idle saccades (ours)."""


def saccades(life: Living) -> Iterable[Moved]:
    """The line of sight jumps about the target, never a degree from it, at the rate of the knob `saccades` (1/min)."""
    rate = life.knob("saccades")
    if rate <= 0.0:
        return
    length = saccade_time(2.0 * FURTHEST)
    wait = max(60.0 / rate - length, length)
    dice = life.dice
    found = tuple(
        events(
            life.start,
            life.end,
            lambda index: dice.log_normal(wait, VARIATION, "saccades", index, "gap"),
            lambda _: length,
        )
    )
    places = [_stray(life, event.index) for event in found]
    yield moved(steps(found, [yaw for yaw, _ in places].__getitem__), gaze_yaw=1.0)
    yield moved(steps(found, [pitch for _, pitch in places].__getitem__), gaze_pitch=1.0)


def _stray(life: Living, index: int) -> tuple[float, float]:
    """A fixation beside the target, deg; now on one side, now on the other, so that each saccade can be seen."""
    far = life.dice.between(NEAREST, FURTHEST, "saccades", index, "far")
    turn = pi * index + life.dice.between(-pi / 4.0, pi / 4.0, "saccades", index, "turn")
    return far * cos(turn), far * sin(turn)
