"""Turns a life into small head movements: sway, the announcer's tilts and turns, nods and lifts at pauses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import ceil

import numpy as np

from facescript.motion.dice import Event
from facescript.motion.life.model import Living, Moved, going_on, moved, steps
from facescript.motion.life.stations import Interval
from facescript.performance.curves import Steps, Wander

SWAY = {"head.yaw": 2.4, "head.pitch": 1.4, "head.roll": 1.8}
"""How far the head sways to each side at `sway 100%`, deg at most (people cannot hold it quite still: Doherty 2001)."""

WAVES = ((2.9, 0.75), (1.1, 0.25))
"""Seconds between the knots of the sway's noise and their share of it: nothing above about 1 Hz."""

TILT, TURN, NOD = 4.0, 6.0, 5.0
"""How far the announcer tilts, turns and nods at most, deg (ours, within the thesis' 15)."""

MOST = 3.0
"""The knobs `sway` and `nods` grow up to here: a head that goes further would have to jerk."""


def head(life: Living) -> Iterable[Moved]:
    """The announcer moves from pose to pose, everyone else sways (knob `sway`)."""
    size = min(MOST, life.knobs.get("sway", 1.0 if life.announcing else 0.0))
    if size <= 0.0:
        return
    if life.announcing:
        station = life.station
        yield moved(_poses(life, "tilt", station.tilt_gaps, station.tilt_lengths), head_roll=size * TILT)
        yield moved(_poses(life, "turn", station.turn_gaps, station.turn_lengths), head_yaw=size * TURN)
        return
    for name, reach in SWAY.items():
        for spacing, share in WAVES:
            yield moved(_wander(life, f"sway {name}", spacing), **{name.replace(".", "_"): size * reach * share})


def nods(life: Living) -> Iterable[Moved]:
    """A nod that ends just before each pause of the face's speech, and a lift as the pause begins (knob `nods`)."""
    size = min(MOST, life.knobs.get("nods", 1.0 if life.announcing else 0.0))
    if size <= 0.0:
        return
    found = tuple(_nods(life))
    events = [Event(2 * number + part, *pair[part]) for number, (_, pair) in enumerate(found) for part in (0, 1)]
    depths = [pose for depth, _ in found for pose in (depth, 0.0)]
    yield moved(steps(events, depths.__getitem__), head_pitch=size * NOD)


def _nods(life: Living) -> Iterator[tuple[float, tuple[Interval, Interval]]]:
    """How deep each nod goes (-1..0), and when it and the lift after it begin and end.

    A pause has none where the longest nod there is would not find room after the lift before: a rule that knew this
    nod's own length would make long ones rarer than the statistics have them.
    """
    station, clear, memory = life.station, life.start, life.memory
    room = station.nod_ahead[1] + station.nod_lengths[1]
    known = memory.state(life.dice, "nods") if memory else None
    if known is not None:
        clear = known[0]
        yield known[1]
    for pause in life.occasions.pauses(max(life.start + room, life.since), life.end):
        if pause.start - room < clear:
            continue
        dice = life.dice.at(*pause.place)
        nodded = pause.start - dice.between(*station.nod_ahead, "nod", 0, "ahead")
        begun = nodded - dice.between(*station.nod_lengths, "nod", 0, "length")
        clear = pause.start + dice.between(*station.lift_lengths, "nod", 0, "lift")
        nod = -dice.between(0.6, 1.0, "nod", 0, "depth"), ((begun, nodded), (pause.start, clear))
        if memory is not None:
            memory.note(life.dice, "nods", pause.start, (clear, nod))
        yield nod


def _poses(life: Living, behaviour: str, gaps: tuple[float, float], lengths: tuple[float, float]) -> Steps:
    """Movements between poses in -1..1: left, middle and right thirds, never the same twice running."""
    dice = life.dice
    found = tuple(
        going_on(
            life,
            behaviour,
            lambda index: dice.between(*gaps, behaviour, index, "gap"),
            lambda index: dice.between(*lengths, behaviour, index, "length"),
        )
    )
    third, places = (life.memory.state(dice, f"{behaviour} third") if life.memory else None) or 0, {}
    third = 1 if not found or not found[0].index else third
    for event in found:
        index = event.index
        if life.memory is not None:
            life.memory.note(dice, f"{behaviour} third", event.start, third)
        third = (third + (1 if dice.chance(behaviour, index, "side") < 0.5 else 2)) % 3
        places[index] = 0.75 * (third - 1) + dice.between(-0.25, 0.25, behaviour, index, "pose")
    return steps(found, places.__getitem__)


def _wander(life: Living, behaviour: str, spacing: float) -> Wander:
    """Noise in -1..1 from rest at the life's start; its knots are hashed one by one."""
    count = ceil((life.end - life.start) / spacing) + 2
    first = int((life.since - life.start) / spacing)
    dice = life.dice
    knots = [dice.between(-1.0, 1.0, behaviour, index, f"{spacing}") if index else 0.0 for index in range(first, count)]
    return Wander(life.start + first * spacing, spacing, np.array(knots))
