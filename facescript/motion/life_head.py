"""Turns a life into small head movements: sway, the announcer's tilts and turns, nods and lifts at pauses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import ceil

import numpy as np

from facescript.motion.dice import Event, events
from facescript.motion.life_model import Living, Moved, moved, pauses, steps
from facescript.performance.curves import Steps, Wander

SWAY = {"head.yaw": 2.4, "head.pitch": 1.4, "head.roll": 1.8}
"""How far the head sways to each side at `sway 100%`, deg at most (people cannot hold it quite still: Doherty 2001)."""

WAVES = ((2.9, 0.75), (1.1, 0.25))
"""Seconds between the knots of the sway's noise and their share of it: nothing above about 1 Hz."""

TILT, TURN, NOD = 4.0, 6.0, 5.0
"""How far the announcer tilts, turns and nods at most, deg (ours, within the thesis' 15)."""

TILT_GAPS, TILT_LENGTHS = (0.0, 6.64), (0.4, 1.0)
TURN_GAPS, TURN_LENGTHS = (0.08, 7.92), (0.4, 0.92)
"""Seconds from the end of a movement to the next and of a movement, uniform (`thesis` 4.5, tables 4.3 to 4.7)."""

NOD_AHEAD, NOD_LENGTHS, LIFT_LENGTHS = (0.07, 0.35), (0.34, 0.94), (0.34, 0.70)
"""Seconds from a nod's end to the pause, of a nod, and of the lift that starts with the pause (table 4.12)."""


def head(life: Living) -> Iterable[Moved]:
    """The announcer moves from pose to pose, everyone else sways (knob `sway`)."""
    size = life.knobs.get("sway", 1.0 if life.announcing else 0.0)
    if size <= 0.0:
        return
    if life.announcing:
        yield moved(_poses(life, "tilt", TILT_GAPS, TILT_LENGTHS), head_roll=size * TILT)
        yield moved(_poses(life, "turn", TURN_GAPS, TURN_LENGTHS), head_yaw=size * TURN)
        return
    for name, reach in SWAY.items():
        for spacing, share in WAVES:
            yield moved(_wander(life, f"sway {name}", spacing), **{name.replace(".", "_"): size * reach * share})


def nods(life: Living) -> Iterable[Moved]:
    """A nod that ends just before each pause of the face's speech, and a lift as the pause begins (knob `nods`)."""
    size = life.knobs.get("nods", 1.0 if life.announcing else 0.0)
    if size <= 0.0 or not life.lines:
        return
    found = tuple(_nods(life))
    depths = {index: -life.dice.between(0.6, 1.0, "nod", index, "depth") for index in range(0, len(found), 2)}
    yield moved(steps(found, lambda index: depths.get(index, 0.0)), head_pitch=size * NOD)


def _nods(life: Living) -> Iterator[Event]:
    """Nod and lift in turn: events 2 k and 2 k + 1. A pause too close to the one before has none."""
    clear, index = life.start, 0
    for number, pause in enumerate(pauses(life.lines)):
        ahead, length, lift = (
            life.dice.between(*bounds, "nod", number, purpose)
            for bounds, purpose in ((NOD_AHEAD, "ahead"), (NOD_LENGTHS, "length"), (LIFT_LENGTHS, "lift"))
        )
        begun = pause - ahead - length
        if begun < clear or pause >= life.end:
            continue
        yield Event(index, begun, pause - ahead)
        yield Event(index + 1, pause, pause + lift)
        clear, index = pause + lift, index + 2


def _poses(life: Living, behaviour: str, gaps: tuple[float, float], lengths: tuple[float, float]) -> Steps:
    """Movements between poses in -1..1: left, middle and right thirds, never the same twice running."""
    dice = life.dice
    found = tuple(
        events(
            life.start,
            life.end,
            lambda index: dice.between(*gaps, behaviour, index, "gap"),
            lambda index: dice.between(*lengths, behaviour, index, "length"),
        )
    )
    third, places = 1, []
    for index in range(len(found)):
        third = (third + (1 if dice.chance(behaviour, index, "side") < 0.5 else 2)) % 3
        places.append(0.75 * (third - 1) + dice.between(-0.25, 0.25, behaviour, index, "pose"))
    return steps(found, places.__getitem__)


def _wander(life: Living, behaviour: str, spacing: float) -> Wander:
    """Noise in -1..1 from rest at the life's start; its knots are hashed one by one."""
    count = ceil((life.end - life.start) / spacing) + 2
    dice = life.dice
    knots = [0.0] + [dice.between(-1.0, 1.0, behaviour, index, f"{spacing}") for index in range(1, count)]
    return Wander(life.start, spacing, np.array(knots))
