"""Gestures: where they go, that they come back, how fast lids close and open."""

from __future__ import annotations

import numpy as np
import pytest
from bars import bar
from hypothesis import given, settings
from hypothesis import strategies as st
from performing import channels, gesture, grid, performed

from facescript.motion.gesture import PROFILES, blink_profile

NOD, SHAKE = {"head.pitch": -10.0}, {"head.yaw": 8.0}
TILT, WINK = {"head.roll": 9.0}, {"blink.left": 1.0, "cheek.upper.left": 0.3}
BLINK = {"blink.left": 1.0, "blink.right": 1.0}


@pytest.mark.parametrize("kind", sorted(PROFILES))
def test_a_gesture_goes_all_the_way_and_comes_back_to_exactly_nothing(kind: str) -> None:
    shares = np.linspace(0.0, 1.0, 10_001)
    values = PROFILES[kind](shares)
    assert values[0] == values[-1] == 0.0
    assert values.max() == 1.0
    assert np.abs(np.diff(np.gradient(values, shares))).max() < 0.05


def test_a_nod_goes_down_first_and_rebounds_a_little() -> None:
    pitch = channels(performed(gesture(1.0, "nod", NOD)), grid(3.0))["head.pitch"]
    assert pitch.argmin() < pitch.argmax() and pitch.min() == pytest.approx(-10.0)
    assert 0.5 < pitch.max() < 2.0
    assert set(pitch[:1001]) == set(pitch[1700:]) == {0.0}


def test_a_shake_swings_both_ways_and_dies_away() -> None:
    yaw = channels(performed(gesture(0.0, "shake", SHAKE, lasting=0.9)), grid(2.0))["head.yaw"]
    turns = [value for before, value, after in zip(yaw, yaw[1:], yaw[2:], strict=False)
             if (value - before) * (after - value) < 0.0]  # fmt: skip
    assert len(turns) == 4
    assert [np.sign(turn) for turn in turns] == [1, -1, 1, -1]
    assert np.all(np.diff(np.abs(turns)) < 0.0)


def test_a_degree_scales_a_gesture_and_for_is_its_length() -> None:
    roll = channels(performed(gesture(0.0, "tilt", TILT, degree=0.5, lasting=2.0)), grid(3.0))["head.roll"]
    assert roll.max() == pytest.approx(4.5)
    assert roll[1999] > 0.0 and set(roll[2000:]) == {0.0}


def test_gestures_that_overlap_add_up() -> None:
    nod, tilt = gesture(0.0, "nod", NOD), gesture(0.2, "nod", {"head.pitch": -4.0}, order=1)
    both, one, other = (channels(performed(*acts), grid(2.0))["head.pitch"] for acts in ([nod, tilt], [nod], [tilt]))
    assert both == pytest.approx(one + other)


def test_a_wink_shuts_one_eye() -> None:
    drawn = channels(performed(gesture(0.0, "wink", WINK, lasting=0.4)), grid(1.0))
    assert drawn["lid.left"].max() == 1.0 and drawn["cheek.upper.left"].max() == pytest.approx(0.3)
    assert np.abs(drawn["lid.right"]).max() < 0.01


def test_a_blink_closes_faster_than_it_opens() -> None:
    lid = channels(performed(gesture(0.0, "blink", BLINK, lasting=0.3)), grid(0.5, 10_000.0))["lid.left"]
    speed = np.gradient(lid, 1e-4)
    low, high = bar("B4", "mean")
    assert low <= speed.max() / -speed.min() <= high
    assert np.flatnonzero(lid == 1.0)[[0, -1]] / 10_000.0 == pytest.approx([0.28 * 0.3, 0.48 * 0.3], abs=2e-3)


def test_the_eye_turns_down_and_inwards_in_a_blink() -> None:
    drawn = channels(performed(gesture(0.0, "blink", BLINK, lasting=0.3)), grid(0.5))
    for side, inwards in (("left", -1.0), ("right", 1.0)):
        yaw, pitch = (drawn[f"eye.{side}.{axis}"] - drawn[f"eye.{side}.{axis}"][-1] for axis in ("yaw", "pitch"))
        low, high = bar("B6", "down+nasal")
        assert low <= np.hypot(yaw, pitch).max() <= high
        assert np.all(inwards * yaw >= 0.0) and pitch.max() <= bar("B6", "upward")[1]


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(sorted(PROFILES)), st.floats(0.0, 3.0), st.floats(0.05, 3.0), st.floats(0.0, 1.0))
def test_before_and_after_a_gesture_the_face_is_as_if_it_had_not_been(
    kind: str, start: float, lasting: float, degree: float
) -> None:
    far = {"head.pitch": -10.0, "head.yaw": 5.0, "blink.left": 1.0, "cheek.upper.left": 0.4}
    times = np.concatenate([np.linspace(0.0, start, 20), start + lasting + np.linspace(0.0, 1.0, 20)])
    made, plain = performed(gesture(start, kind, far, 0, degree, lasting)), performed()
    assert np.array_equal(made.sample(times), plain.sample(times))


def test_the_profile_of_a_blink_is_shut_in_the_middle_only() -> None:
    assert blink_profile(np.array([0.0, 0.14, 0.28, 0.4, 0.48, 1.0])).tolist() == [0.0, 0.5, 1.0, 1.0, 1.0, 0.0]
