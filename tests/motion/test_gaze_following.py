"""Pursuit over speeds, directions and starting places between those that the bars name, and targets that do anything.

P2 names bands at 10 and 60 deg/s only; between them they are read on a straight line, and below 10 as at 10.
"""

from __future__ import annotations

from math import cos, radians, sin

import numpy as np
import pytest
from bars import Trace, across, bar, eye_extremes, largest_step
from gazing import HERE, moving, request, trace
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.ir.play import MovingTarget
from facescript.ir.values import Point

START = 1.0
PATHS = [
    (speed, way, place)
    for speed in (5, 8, 10, 20, 30, 40, 50, 60)
    for way, place in [(0, (-25, 0)), (180, (20, 10)), (90, (0, -20)), (270, (5, 15)), (45, (-20, -15)), (225, (25, 5))]
]


def ramp(speed: int, way: int, place: tuple[int, int]) -> tuple[Trace, float]:
    """How a target is followed that sets off at once, at a speed and in a direction (deg), and how long it moves."""
    lasts = min(40, 4 * speed) / speed
    count = round(lasts / 0.02)
    x, y = speed * cos(radians(way)), speed * sin(radians(way))
    keys = [(lasts * part / count, x * lasts * part / count, y * lasts * part / count) for part in range(count + 1)]
    target = moving("visitor", [(START + time, place[0] + yaw, place[1] + pitch) for time, yaw, pitch in keys])
    return trace([target], [request(0, "visitor", 0.2)], START + lasts), lasts


@pytest.mark.parametrize(("speed", "way", "place"), PATHS)
def test_p1_p2_p3_over_speeds_directions_and_places(speed: int, way: int, place: tuple[int, int]) -> None:
    seen, lasts = ramp(speed, way, place)
    pace = seen.speed(seen.gaze("yaw")) * cos(radians(way)) + seen.speed(seen.gaze("pitch")) * sin(radians(way))
    onset = seen.times[np.flatnonzero((seen.times > START) & (pace > 0.2 * speed))[0]] - START
    low, high = bar("P1", "any")
    assert low <= onset * 1000 <= high
    steady = pace[seen.times > START + 0.4 * lasts]
    share = min(1.0, max(0.0, (speed - 10) / 50))
    bands = [one + share * (other - one) for one, other in zip(bar("P2", "10"), bar("P2", "60"), strict=True)]
    assert bands[0] <= np.median(steady[np.abs(steady) < 1.5 * speed]) / speed <= bands[1]
    saccades = np.count_nonzero(np.diff((pace[seen.times > START] > 2 * speed + 10).astype(int)) == 1) / lasts
    if speed > 30:
        assert saccades >= bar("P3", "40 deg/s")[0]
    if speed <= 10:
        assert saccades <= bar("P3", "10 deg/s")[1]


@pytest.mark.parametrize(
    ("yaw", "pitch"), [(5, 0), (-20, 0), (40, 0), (-70, 0), (0, 15), (0, -30), (30, 20), (-25, -20)]
)
@pytest.mark.parametrize("place", [(0, 0), (-10, 5)])
def test_s7_jumps_of_any_size_and_direction(yaw: int, pitch: int, place: tuple[int, int]) -> None:
    x, y = place
    seen = trace([moving("visitor", [(1, x, y), (1.001, x + yaw, y + pitch)])], [request(0, "visitor", 0.2)], 3.0)
    pace = np.hypot(seen.speed(seen.gaze("yaw")), seen.speed(seen.gaze("pitch")))
    onset = seen.times[np.flatnonzero((seen.times > START) & (pace > 0.05 * pace[seen.times > START].max()))[0]] - START
    low, high = bar("S7", "mean")
    assert low <= onset * 1000 <= high
    assert (seen.gaze("yaw")[-1], seen.gaze("pitch")[-1]) == pytest.approx((x + yaw, y + pitch), abs=0.3)


anywhere = st.tuples(st.floats(-300, 300), st.floats(-150, 150), st.floats(-100, 300))
near_the_eye = st.tuples(st.floats(-15, 15), st.floats(-15, 15), st.floats(-10, 20))
far = st.tuples(st.floats(-1e7, 1e7), st.floats(-1e7, 1e7), st.floats(-1e7, 1e7))
keys = st.lists(
    st.tuples(st.sampled_from([0.001, 0.02, 0.1, 0.3, 1.0]), st.one_of(anywhere, near_the_eye, far)),
    min_size=1,
    max_size=8,
)


@settings(max_examples=40, deadline=None)
@given(keys, st.floats(0.0, 1.0))
def test_whatever_a_target_does_nothing_jumps_or_jolts(drawn: list[tuple[float, tuple]], start: float) -> None:
    """At 1000 Hz at most 0.75 deg of gaze, 0.32 of head, steps of speed of 100 deg/s of an eye and 10 of the head."""
    times = np.cumsum([0.3, *(wait for wait, _ in drawn[1:])]).tolist()
    target = MovingTarget("visitor", tuple(times), tuple(Point(*place) for _, place in drawn), HERE)
    seen = trace([target], [request(0, "visitor", start)], times[-1] + 2.5)
    yaw, pitch = seen.gaze("yaw"), seen.gaze("pitch")
    assert max(largest_step(across(yaw, pitch)), largest_step(pitch)) <= 0.75
    for axis in ("yaw", "pitch"):
        assert largest_step(seen.head(axis)) <= 0.32
        assert np.abs(seen.speed(seen.head(axis))).max() <= bar("H6", "max")[1]
        assert largest_step(seen.speed(seen.head(axis))) <= 10
        for side in ("left", "right"):
            assert largest_step(seen.speed(seen.channels[f"eye.{side}.{axis}"])) <= 100
    for side, furthest in eye_extremes(seen).items():
        assert furthest <= bar("S8", side)[1]
