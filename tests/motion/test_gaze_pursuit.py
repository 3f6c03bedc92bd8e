"""Following a moving target: latency, gain, catch-up saccades, and how near the gaze stays."""

from __future__ import annotations

import numpy as np
import pytest
from bars import Trace, bar, largest_step
from gazing import face, film, moving, request, trace

from facescript.ir.play import MovingTarget
from facescript.ir.values import AtTarget
from facescript.space.room import Room

START = 1.0


def ramp(speed: float) -> tuple[MovingTarget, Trace]:
    """A target that sets off at 1 s and goes 60 deg to the right at a speed, and how it is followed."""
    lasts = 60 / speed
    visitor = moving("visitor", [(START + lasts * part / 16, -30 + 60 * part / 16, 0) for part in range(17)])
    return visitor, trace([visitor], [request(0, "visitor", 0.2)], START + lasts + 2.5)


def error(visitor: MovingTarget, seen: Trace) -> np.ndarray:
    room = Room(film(), [face()], [visitor])
    true = [room.sight("ada", AtTarget("visitor"), time) for time in seen.times.tolist()]
    off = seen.gaze("yaw") - [sight.yaw for sight in true], seen.gaze("pitch") - [sight.pitch for sight in true]
    return np.hypot(*off)


def gaze_speed(seen: Trace, start: float, end: float) -> np.ndarray:
    return seen.part(start, end).speed(seen.part(start, end).gaze("yaw"))


@pytest.mark.parametrize("speed", [10, 20, 40])
def test_p1_pursuit_sets_off_after_the_target(speed: int) -> None:
    seen = ramp(speed)[1]
    pace = seen.speed(seen.gaze("yaw"))
    onset = seen.times[np.flatnonzero((seen.times > START) & (pace > 0.2 * speed))[0]] - START
    low, high = bar("P1", "any")
    assert low <= onset * 1000 <= high


@pytest.mark.parametrize("speed", [10, 60])
def test_p2_gain_of_steady_pursuit(speed: int) -> None:
    lasts = 60 / speed
    pace = gaze_speed(ramp(speed)[1], START + 0.4 * lasts, START + 0.9 * lasts)
    smooth = pace[np.abs(pace) < 1.5 * speed]
    low, high = bar("P2", str(speed))
    assert low <= np.median(smooth) / speed <= high


@pytest.mark.parametrize(("speed", "case"), [(40, "40 deg/s"), (10, "10 deg/s")])
def test_p3_catch_up_saccades(speed: int, case: str) -> None:
    lasts = 60 / speed
    fast = gaze_speed(ramp(speed)[1], START, START + lasts) > 2 * speed
    count = np.count_nonzero(np.diff(fast.astype(int)) == 1)
    low, high = bar("P3", case)
    assert low <= count / lasts <= high


def test_s7_a_jump_is_followed_after_human_latency() -> None:
    visitor = moving("visitor", [(START, -10, 0), (START + 0.001, 10, 0)])
    seen = trace([visitor], [request(0, "visitor", 0.2)], 3.0)
    pace = seen.speed(seen.gaze("yaw"))
    onset = seen.times[np.flatnonzero((seen.times > START) & (pace > 0.05 * pace.max()))[0]] - START
    low, high = bar("S7", "mean")
    assert low <= onset * 1000 <= high
    assert seen.gaze("yaw")[-1] == pytest.approx(10, abs=0.1)


@pytest.mark.parametrize(
    "keys", [[(1, -22, 0), (5, 22, 5)], [(0, -22, 0), (4, 0, 5), (10, 24, 0)], [(0, 0, -10), (1, 12, 4)]]
)
def test_a_walking_target_is_kept_within_two_degrees(keys: list[tuple[float, float, float]]) -> None:
    visitor = moving("visitor", keys)
    seen = trace([visitor], [request(0, "visitor", 0.0)], keys[-1][0] + 3.0)
    off = error(visitor, seen)
    assert off[seen.times > 0.4].max() < 2.0
    assert off[-1] < 0.1


def test_the_head_follows_too_and_nothing_jumps() -> None:
    seen = ramp(20)[1]
    assert seen.head("yaw")[-1] == pytest.approx(0.69 * 30, abs=0.5)
    assert largest_step(seen.head("yaw")) < 0.1
    assert largest_step(seen.gaze("yaw")) < 0.6


def test_a_target_behind_the_face_is_followed_around_the_front() -> None:
    visitor = moving("visitor", [(1, 100, 0), (1.5, 179, 0), (2.0, -179, 0), (2.5, -100, 0)])
    seen = trace([visitor], [request(0, "visitor", 0.2)], 6.0)
    assert seen.gaze("yaw")[900] == pytest.approx(90, abs=1.5)
    assert seen.gaze("yaw")[-1] == pytest.approx(-90, abs=1.5)
    assert largest_step(seen.gaze("yaw")) < 1.0
