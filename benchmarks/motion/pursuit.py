"""Smooth pursuit of a target that sets off (P1 to P3): speeds and directions, screen none, life still, 3 m away."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from bars import Trace
from events import joined, stretches
from playing import Studio, eye_height, on_way, place_words, script, turned_trace
from table import Measures, Row, row, row_between

SPEEDS = (5, 10, 15, 20, 30, 40, 50, 60)
WAYS = (0, 180, 30, 210, 90, 270)

FAR = {0: 50.0, 180: 50.0, 30: 50.0, 210: 50.0, 90: 36.0, 270: 36.0}
"""How far the target goes, deg, by its way; half of it on each side of straight ahead."""

SHARE = 0.05
"""The share of the target's speed from which gaze follows it; the house's rule, the target's speed for the peak."""

FAST = 2.0, 15.0
"""Gaze faster than this many times the target's speed, and this much more, deg/s, is a catch-up saccade."""

KEYS = 40
"""Keys of the target's way: smooth between them, so its speed is even but for the first and last."""

EDGE = 0.01
"""Seconds in which the target takes up its speed."""


@dataclass(frozen=True)
class Ramp:
    """A target that sets off at `start` and goes for `lasts` seconds at `speed` deg/s, and how it is followed: the
    trace is turned so that yaw is along its way."""

    speed: float
    start: float
    lasts: float
    trace: Trace

    @property
    def pace(self) -> np.ndarray:
        """The speed of gaze along the way, deg/s."""
        return self.trace.speed(self.trace.gaze("yaw"))

    def fast(self) -> list[tuple[int, int]]:
        """The catch-up saccades between the target's start and end."""
        times, far, more = self.trace.times, *FAST
        going = (times >= self.start) & (times <= self.start + self.lasts)
        found = stretches(going & (np.abs(self.pace) > far * self.speed + more))
        return joined(found, 10)


def _ramps(studio: Studio) -> list[Ramp]:
    return [_ramp(studio, speed, way) for speed in SPEEDS for way in WAYS]


def _ramp(studio: Studio, speed: float, way: int) -> Ramp:
    start, far = 1.5, FAR[way]
    lasts = far / speed
    shares = [0.0, EDGE / lasts, *np.linspace(0.05, 0.95, KEYS), 1.0]
    height = studio.once(eye_height)
    keys = [
        f"    {start + lasts * part:.5f}s {place_words(on_way(far * (part - 0.5), way), 300.0, height)}"
        for part in shares
    ]
    playing = studio.play(script("look at visitor", f"wait {start + lasts + 1:.3f}s", "target visitor moves", *keys))
    return Ramp(speed, start, lasts, turned_trace(playing.trace(start - 0.1, start + lasts + 0.5), way))


def latencies(studio: Studio) -> Iterator[Row]:
    found = []
    for ramp in studio.once(_ramps):
        after = ramp.trace.times > ramp.start
        first = np.flatnonzero(after & (ramp.pace > SHARE * ramp.speed))[0]
        found.append(1000.0 * (ramp.trace.times[first] - ramp.start))
    over = f"{len(found)} ramps of 5 to 60 deg/s, six directions; 5 % of the target's speed"
    yield row("P1", "any", "gaze sets off after the target", found, over)


def gains(studio: Studio) -> Iterator[Row]:
    found: dict[float, list[float]] = {speed: [] for speed in SPEEDS}
    for ramp in studio.once(_ramps):
        found[ramp.speed].append(_gain(ramp))
    over = f"{len(WAYS)} directions, median between catch-up saccades"
    for case in ("10", "60"):
        yield row("P2", case, f"gain of steady pursuit, {case} deg/s", found[int(case)], over)
    others = {speed: each for speed, each in found.items() if 10 < speed < 60}
    yield row_between("P2", "gain of steady pursuit, other speeds", others, over)


def _gain(ramp: Ramp) -> float:
    """From 40 to 95 % of the target's time, or as late as that leaves 150 ms after the first catch-up."""
    times = ramp.trace.times
    steady = (times >= ramp.start + 0.4 * ramp.lasts) & (times <= ramp.start + 0.95 * ramp.lasts)
    for first, last in ramp.fast():
        steady[max(0, first - 30) : last + 30] = False
    return float(np.median(ramp.pace[steady]) / ramp.speed)


def catch_ups(studio: Studio) -> Iterator[Row]:
    for case in ("40 deg/s", "10 deg/s"):
        speed = int(case.split()[0])
        found = [len(ramp.fast()) / ramp.lasts for ramp in studio.once(_ramps) if ramp.speed == speed]
        yield row("P3", case, f"catch-up saccades a second, {case}", found, f"{len(WAYS)} directions")


MEASURES: Measures = {"P1": latencies, "P2": gains, "P3": catch_ups}
