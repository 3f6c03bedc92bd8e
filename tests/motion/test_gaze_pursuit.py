"""Following a moving target: latency, gain, catch-up saccades, and how near the gaze stays."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bars import Trace, bar, largest_step
from gazing import face, film, moving, request, trace

from facescript.ir.acts import GazeManner
from facescript.ir.play import MovingTarget
from facescript.ir.values import AtTarget, Towards
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


# ------------------------------------------------------------------------------------------------ leaving reach

ROUND = [(0, 60, 0), (1, 80, 0), (2, 110, 0), (3, 179, 0), (3.05, -179, 0), (4.5, -110, 0), (5.5, -60, 0)]
"""A target that leaves reach at the viewer's right, goes round behind the face, and comes back at the left."""


def at(seen: Trace, time: float) -> tuple[float, float]:
    """Gaze and head yaw at a time."""
    index = round(time * 1000)
    return float(seen.gaze("yaw")[index]), float(seen.head("yaw")[index])


def crossing(seen: Trace, start: float, low: float, high: float) -> float:
    """When gaze yaw first comes between two angles from a time on."""
    yaw = seen.gaze("yaw")
    return float(seen.times[np.flatnonzero((seen.times > start) & (yaw > low) & (yaw < high))[0]])


def edges(visitor: MovingTarget) -> tuple[float, float]:
    """When a target leaves reach, and when it is back."""
    (absence,) = Room(film(), [face()], [visitor]).sightings("ada", AtTarget("visitor")).absences
    return absence.start, absence.end


def test_a_target_that_leaves_reach_is_let_go_of_and_found_again() -> None:
    visitor = moving("visitor", ROUND)
    seen = trace([visitor], [request(0, "visitor", 0.1)], 8.0)
    left, back = edges(visitor)
    assert at(seen, left + 0.4)[0] == pytest.approx(90, abs=1.5)
    assert 0.45 <= crossing(seen, left, -80, 80) - left <= 0.6
    assert at(seen, back)[0] == pytest.approx(0, abs=0.5)
    assert at(seen, back)[1] == pytest.approx(0, abs=3)
    low, high = bar("S7", "each of 95%")
    assert low <= (crossing(seen, back, -90, -2) - back) * 1000 <= high
    assert at(seen, 7.9)[0] == pytest.approx(-60, abs=0.2)


def test_a_target_behind_the_face_does_not_swing_gaze_round_the_front() -> None:
    """It passes behind in a twentieth of a second; gaze stays at the side where it left."""
    visitor = moving(
        "visitor", [(1, 80, 0), (1.2, 100, 0), (1.25, 179, 0), (1.3, -179, 0), (1.35, -100, 0), (9, -95, 0)]
    )
    seen = trace([visitor], [request(0, "visitor", 0.2)], 5.0)
    left, _ = edges(visitor)
    assert seen.part(left, left + 0.45).gaze("yaw").min() > 79
    assert at(seen, 4.0)[0] == pytest.approx(0, abs=0.3)


def test_a_target_at_the_edge_does_not_make_gaze_flicker() -> None:
    """It trembles across the edge of reach ten times a second: gaze leaves for the front once, and stays."""
    shake = [(1 + 0.1 * number, 90 + (4 if number % 2 else -4), 0) for number in range(60)]
    seen = trace([moving("visitor", shake)], [request(0, "visitor", 0.2)], 6.5)
    fast = np.abs(seen.speed(seen.gaze("yaw")))[seen.times > 1.0] > 100
    assert np.count_nonzero(np.diff(fast.astype(int)) == 1) <= 2
    assert at(seen, 6.0)[0] == pytest.approx(0, abs=0.3)


def test_a_lost_target_is_let_go_of_and_found_again_where_it_is() -> None:
    visitor = replace(moving("visitor", [(0, -20, 0), (2, -10, 0), (5, 25, 0), (7, 20, 0)]), lost=((2.0, 5.0),))
    seen = trace([visitor], [request(0, "visitor", 0.2)], 8.0)
    assert at(seen, 2.4)[0] == pytest.approx(-10, abs=0.5)
    assert at(seen, 4.0)[0] == pytest.approx(0, abs=0.3)
    assert at(seen, 5.0)[0] == pytest.approx(0, abs=0.1)
    assert 0.1 <= crossing(seen, 5, 1, 30) - 5 <= 0.3
    assert at(seen, 7.9)[0] == pytest.approx(20, abs=0.2)


def test_a_target_that_was_never_seen_is_waited_for_at_the_camera() -> None:
    visitor = replace(moving("visitor", [(2, -20, 0), (4, -10, 0)]), lost=((-86400.0, 2.0),))
    seen = trace([visitor], [request(0, "visitor", 0.2)], 4.0)
    assert np.abs(seen.part(0, 2.1).gaze("yaw")).max() == pytest.approx(0, abs=0.01)
    assert at(seen, 3.9)[0] == pytest.approx(-10, abs=0.5)


def test_a_short_absence_is_waited_for_where_the_target_was_last() -> None:
    visitor = replace(moving("visitor", [(0, -20, 0), (2, -10, 0), (2.45, 0, 0), (4, 0, 0)]), lost=((2.0, 2.45),))
    seen = trace([visitor], [request(0, "visitor", 0.2)], 4.0)
    assert np.abs(seen.part(2.3, 2.5).gaze("yaw") + 10).max() < 0.1
    assert at(seen, 3.5)[0] == pytest.approx(0, abs=0.3)


def test_what_was_covered_meanwhile_is_let_go_of_too() -> None:
    """A look with `for` ends while the older look's target is away: gaze goes to the camera, not to where that left."""
    visitor = moving("visitor", ROUND)
    asked = [request(0, "visitor", 0.1), request(1, Towards(-20, 10), 1.2, released=3.0)]
    seen = trace([visitor], asked, 8.0)
    assert seen.part(3.0, 4.6).gaze("yaw").max() < 1.0
    assert at(seen, 4.0)[0] == pytest.approx(0, abs=0.3)
    assert at(seen, 7.9)[0] == pytest.approx(-60, abs=0.2)


def test_eyes_only_lets_go_with_the_eyes_and_leaves_the_head() -> None:
    visitor = replace(moving("visitor", [(0, 20, 0), (2, 22, 0), (5, 25, 0)]), lost=((2.0, 5.0),))
    asked = [request(0, Towards(10, 0), 0), request(1, "visitor", 0.5, GazeManner("eyes only"))]
    seen = trace([visitor], asked, 7.0)
    assert at(seen, 4.0) == pytest.approx((0, 6.9), abs=0.1)
    assert at(seen, 6.9) == pytest.approx((25, 6.9), abs=0.2)
