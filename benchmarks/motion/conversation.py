"""Gaze in conversation, and eyes that hold still (C1 to C4, M1; H6 once more): an hour of two faces that talk in turns.

A face looks at its partner where gaze is within 3 deg of the partner's eyes. Turns begin and end with their sound.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from bars import Trace
from events import joined, stretches
from hours import FINDING, Hour, Talk, alone, talk
from playing import Place, Studio
from sound import heard
from table import Measures, Row, row

ON = 3.0
"""How far gaze may be from the partner's eyes, deg."""


def _on(found: Talk, face: str) -> np.ndarray:
    return found.hours[face].off(found.partner(face)) <= ON


def _spoken(found: Talk) -> list[tuple[str, float, float]]:
    """Who speaks from when to when, by the sound."""
    return [(turn.face, *(turn.start + time for time in heard(turn.spoken))) for turn in found.turns]


def gazes(studio: Studio) -> Iterator[Row]:
    found = studio.once(talk)
    turns = _spoken(found)
    on = {face: _on(found, face) for face in found.hours}
    over = f"an hour of two faces, {len(turns)} turns, {found.pauses()} spoken pauses"
    speaking = [_part(on[face], start, end) for face, start, end in turns]
    listening = [_part(on["bruno" if face == "ada" else "ada"], start, end) for face, start, end in turns]
    for case, parts in (("listening", listening), ("speaking", speaking)):
        yield row("C1", case, f"time on the partner, {case}", [np.concatenate(parts).mean()], over)
    lengths = [(last - first) / FINDING for part in speaking for first, last in stretches(part)]
    yield row(
        "C2", "speaking", "looks at the partner while speaking, mean", [np.mean(lengths)], f"{len(lengths)} looks"
    )
    ends = np.mean([on[face][int(end * FINDING) - 1] for face, _, end in turns])
    starts = np.mean([not on[face][int(start * FINDING)] for face, start, _ in turns])
    yield row("C3", "end on partner", "turns that end with gaze on the partner", [ends], over)
    yield row("C3", "start away", "turns that start with gaze away", [starts], over)
    gaps = [1000.0 * (after[1] - before[2]) for before, after in pairwise(turns)]
    yield row("C4", "any", "silence between turns, median", [np.median(gaps)], f"{len(gaps)} gaps, by the sound")


def _part(values: np.ndarray, start: float, end: float) -> np.ndarray:
    return values[int(start * FINDING) : int(end * FINDING)]


def heads(studio: Studio) -> Iterator[Row]:
    found = studio.once(talk)
    fastest = [
        float(np.hypot(hour.trace.speed(hour.trace.head("yaw")), hour.trace.speed(hour.trace.head("pitch"))).max())
        for hour in found.hours.values()
    ]
    yield row("H6", "max", "fastest head in conversation", fastest, "an hour of two faces, 200 Hz")


FAST = 5.0
"""Gaze faster than this is a saccade, deg/s: drift is ten times slower."""

BLINKING, AROUND = 3.0, round(0.1 * FINDING)
"""A lid faster than this (1/s) blinks, and does so for as many samples more on both sides."""

HOLDING = 1.0
"""Gaze within this of its target holds it, deg."""


def microsaccades(studio: Studio) -> Iterator[Row]:
    """Small jumps while gaze holds its target and the lids are open."""
    calm, found = studio.once(alone("calm")), studio.once(talk)
    hours = [("calm", calm, (0.0, 0.0)), ("conversation", found.hours["ada"], found.partner("ada"))]
    for name, hour, place in hours:
        sizes, seconds = _small(hour, place)
        over = f"{seconds / 60:.0f} minutes of holding gaze, {len(sizes)} movements"
        yield row("M1", "rate 1/s", f"microsaccades a second, life {name}", [len(sizes) / seconds], over, "")
        yield row(
            "M1", "size deg", f"size of microsaccades, life {name}, middle 98 %", np.percentile(sizes, [1, 99]), over
        )


def _small(hour: Hour, place: Place) -> tuple[list[float], float]:
    """The sizes of small jumps, deg, and how long gaze held its target, s."""
    trace = hour.trace
    held = _open(trace) & (hour.off(place) <= HOLDING)
    yaw, pitch = trace.gaze("yaw"), trace.gaze("pitch")
    fast = np.hypot(np.diff(yaw), np.diff(pitch)) * FINDING > FAST
    sizes = [
        float(np.hypot(yaw[last] - yaw[first], pitch[last] - pitch[first]))
        for first, last in joined(stretches(fast), 1)
        if held[max(0, first - 3) : last + 3].all()
    ]
    return sizes, float(held.sum() / FINDING)


def _open(trace: Trace) -> np.ndarray:
    """Where no blink is under way: it turns the eyes too."""
    opened = np.ones(len(trace.times), dtype=bool)
    fast = np.abs(np.gradient(trace.channels["lid.left"], trace.times)) > BLINKING
    for first, last in stretches(fast):
        opened[max(0, first - AROUND) : last + AROUND] = False
    return opened


MEASURES: Measures = {"C1 C2 C3 C4": gazes, "H6": heads, "M1": microsaccades}
