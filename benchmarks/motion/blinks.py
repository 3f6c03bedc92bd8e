"""Blinks and lids (B1 to B7): an hour of each life, screen none. A blink's phases begin and end at 5 % of their peak
speed; it is (nearly) complete where the lid goes 90 % of its way or more."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from bars import Floats, Trace, movement
from events import Blink
from hours import Hour, alone, talk
from playing import Studio, shifts
from table import Measures, Row, row

COMPLETE = 0.9
"""How far a lid goes in a blink that is (nearly) complete, as a part of its way."""

LID_TRAVEL = 48.0
"""Deg the lid turns from rest to shut: the channel `lid` times this is its angle (`motion/blend.py`)."""


def rates(studio: Studio) -> Iterator[Row]:
    for case, life in (("rest", "calm"), ("reading", "reading")):
        hour = studio.once(alone(life))
        yield row("B1", case, f"blinks a minute, life {life}", [_rate(hour)], f"an hour, {len(hour.shut())} blinks")
    found = studio.once(talk)
    each = [_rate(hour) for hour in found.hours.values()]
    over = f"an hour of two faces, {len(found.turns)} turns, {found.pauses()} spoken pauses"
    yield row("B1", "conversation", "blinks a minute, life conversation, in talk", each, over)


def _rate(hour: Hour) -> float:
    return len(hour.shut()) / hour.minutes


def _rest(studio: Studio) -> list[tuple[Blink, Trace]]:
    return list(studio.once(alone("calm")).blinks())


def shapes(studio: Studio) -> Iterator[Row]:
    found = [blink for blink, _ in studio.once(_rest)]
    over = f"an hour of calm, {len(found)} blinks"
    gaps = np.diff([blink.onset for blink in found])
    skew = float(((gaps - gaps.mean()) ** 3).mean() / gaps.std() ** 3)
    yield row("B2", "rest", "skewness of the time between blinks", [skew], over, "")
    yield row("B3", "mean", "closing time, mean", [np.mean([blink.closing_ms for blink in found])], over)
    ratio = np.mean([blink.closing_speed / blink.opening_speed for blink in found])
    yield row("B4", "mean", "peak closing over peak opening speed, mean", [ratio], over)
    complete = np.mean([blink.depth >= COMPLETE for blink in found])
    yield row("B5", "mean", "share of blinks that are nearly complete", [complete], over)


def turns(studio: Studio) -> Iterator[Row]:
    """B6: an eye that looks straight ahead, in a life of blinks alone."""
    hour = studio.once(alone("calm, sway 0%, saccades 0/min, brows 0/min, avert 0%"))
    moved = [_turned(trace, blink) for blink, trace in hour.blinks()]
    far, up = zip(*moved, strict=True)
    over = f"{len(moved)} blinks, looking straight ahead"
    yield row("B6", "down+nasal", "the eye turns down and to the nose in a blink, furthest", far, over)
    yield row("B6", "upward", "and up, furthest", up, over)


def _turned(trace: Trace, blink: Blink) -> tuple[float, float]:
    """How far the left eye, which is on the viewer's right, turns down and nasally, and up, from where it was."""
    start = int(np.searchsorted(trace.times, blink.onset)) - 5
    during = slice(start, int(np.searchsorted(trace.times, blink.end)))
    yaw, pitch = (trace.channels[f"eye.left.{axis}"] for axis in ("yaw", "pitch"))
    nasal, down = yaw[start] - yaw[during], pitch[start] - pitch[during]
    away = np.hypot(np.maximum(nasal, 0.0), np.maximum(down, 0.0))
    return float(away.max()), float(max(0.0, -down.min()))


PITCHES = (-30, -25, -20, -15, -10, -5, 5, 10, 15)
"""Where the static gain is measured, deg; further up the language's floor of a lid, -35 %, bounds it (16.8 deg)."""


def gaze(studio: Studio) -> Iterator[Row]:
    """The lid's angle beside the eye's, in looks up and down with eyes alone, from ahead and back."""
    pairs = [((float(yaw), 0.0), (float(yaw), float(pitch))) for yaw in (0, 15) for pitch in PITCHES]
    pairs += [(end, start) for start, end in pairs]
    made = shifts(studio, pairs, "eyes only", 0.8, 4000.0)
    static, lags, down, up = [], [], [], []
    for shift in made:
        lid, eye = _lid(shift.seen), shift.seen.eye("pitch")
        gain = (lid[-1] - lid[0]) / (eye[-1] - eye[0])
        static += [gain] if shift.end[1] else []
        (down if shift.end[1] < shift.start[1] else up).append(gain)
        lags.append(1000.0 * (movement(shift.seen, lid).onset - movement(shift.seen, eye).onset))
    over = f"{len(made)} looks, -30 to 15 deg"
    for case, name, values, unit in (
        ("static gain", "lid angle over eye angle, at rest", static, ""),
        ("lid-eye onset ms", "lid onset after eye onset", lags, "ms"),
        ("down saccade gain", "lid over eye, saccades down", down, ""),
        ("up saccade gain", "lid over eye, saccades up", up, ""),
    ):
        yield row("B7", case, name, values, over, unit)


def _lid(trace: Trace) -> Floats:
    """The angle of the left lid, deg, up from rest."""
    return -LID_TRAVEL * trace.channels["lid.left"]


MEASURES: Measures = {"B1": rates, "B2 B3 B4 B5": shapes, "B6": turns, "B7": gaze}
