"""The rules of the blending law, one by one."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facescript.motion.blend import (
    add_within,
    blink_together,
    eyes_within,
    lid_drawn,
    lid_limit,
    lid_opening,
    speak_over,
)
from facescript.performance.limits import LID_FLOOR, LID_GAIN, LID_TRAVEL, gaze_on_lid, soft_limit

NUMBERS = st.floats(-5.0, 5.0)
SHARES = st.floats(0.0, 1.0)


def one(value: float) -> np.ndarray:
    return np.array([value])


@given(st.floats(0.0, 0.8))
def test_soft_limit_leaves_what_is_in_reach_as_it_is(value: float) -> None:
    assert soft_limit(one(value))[0] == value


@given(st.floats(0.8, 100.0))
def test_soft_limit_bends_above(value: float) -> None:
    assert soft_limit(one(value))[0] == pytest.approx(0.8 + 0.2 * np.tanh((value - 0.8) / 0.2))


@given(st.floats(-100.0, 0.0))
def test_soft_limit_has_nothing_below_zero(value: float) -> None:
    assert soft_limit(one(value))[0] == 0.0


def test_soft_limit_has_no_corner_at_its_knee() -> None:
    values = np.linspace(0.5, 1.5, 10_001)
    speed = np.gradient(soft_limit(values), values)
    assert np.abs(np.diff(speed)).max() < 1e-3


@given(NUMBERS)
def test_a_lid_has_a_floor(value: float) -> None:
    limited = lid_limit(one(value))[0]
    assert limited == (max(value, LID_FLOOR) if value < 0 else soft_limit(one(value))[0])


@given(NUMBERS, SHARES)
def test_opening_is_the_expressions_times_what_a_blink_leaves(lid: float, blink: float) -> None:
    assert lid_opening(one(lid), one(blink))[0] == (1 - lid) * (1 - blink)
    shown = lid_limit(one(lid))
    level = lid_drawn(shown, one(blink), one(0.0))[0]
    assert level == pytest.approx(1 - (1 - shown[0]) * (1 - blink))


@given(NUMBERS, NUMBERS, st.floats(-60.0, 60.0))
def test_a_lid_is_never_past_shut_nor_below_its_floor(lid: float, blink: float, pitch: float) -> None:
    drawn = lid_drawn(lid_limit(one(lid)), blink_together(one(blink)), one(pitch))[0]
    assert LID_FLOOR <= drawn <= 1.0


@given(NUMBERS, st.floats(-60.0, 60.0))
def test_a_whole_blink_shuts_the_eye_wherever_it_looks(lid: float, pitch: float) -> None:
    assert lid_drawn(lid_limit(one(lid)), one(1.0), one(pitch))[0] == 1.0


@given(st.floats(-40.0, 14.0))
def test_a_lid_turns_with_the_eye(pitch: float) -> None:
    assert lid_drawn(one(0.0), one(0.0), one(pitch))[0] * LID_TRAVEL == pytest.approx(-LID_GAIN * pitch)


def test_a_lid_follows_the_eye_without_a_corner() -> None:
    pitch = np.linspace(-60.0, 60.0, 24_001)
    factor = gaze_on_lid(pitch)
    speed = np.gradient(factor, pitch)
    assert np.all(speed >= 0.0)
    assert np.abs(np.diff(speed)).max() < 1e-4


@given(st.lists(SHARES, min_size=1, max_size=4))
def test_blinks_together_leave_what_each_leaves(blinks: list[float]) -> None:
    assert blink_together(*map(one, blinks))[0] == pytest.approx(1 - np.prod([1 - blink for blink in blinks]))


@given(NUMBERS, SHARES)
def test_closed_lips_of_speech_are_closed_whatever_the_face_shows(shown: float, pressed: float) -> None:
    assert speak_over(one(shown), one(0.0), one(1.0), one(pressed))[0] == 0.0


@given(NUMBERS, SHARES, SHARES)
def test_an_expression_has_its_mouth_to_itself_in_silence(shown: float, spoken: float, pressed: float) -> None:
    assert speak_over(one(shown), one(spoken), one(0.0), one(pressed))[0] == shown


@given(st.floats(0.1, 1.0), st.floats(0.01, 1.0), SHARES)
def test_an_open_mouth_widens_speech_and_pressed_lips_narrow_it(spoken: float, shown: float, pressed: float) -> None:
    plain = speak_over(one(0.0), one(spoken), one(1.0), one(0.0))[0]
    assert plain == spoken
    assert plain < speak_over(one(shown), one(spoken), one(1.0), one(0.0))[0] <= 1.4 * plain
    assert 0.5 * plain <= speak_over(one(0.0), one(spoken), one(1.0), one(pressed))[0] <= plain


@given(st.floats(-45.0, 45.0), st.floats(-500.0, 500.0))
def test_what_is_added_to_the_head_is_kept_within_its_range(gaze: float, added: float) -> None:
    turned = add_within(one(gaze), one(added), -45.0, 45.0)[0]
    assert abs(turned) <= 45.0 + 1e-9
    room = 45.0 - np.sign(added) * gaze
    if abs(added) <= 0.8 * room:
        assert turned == pytest.approx(gaze + added)


@given(st.floats(-45.0, 45.0))
def test_the_head_of_gaze_alone_is_drawn_as_it_is(gaze: float) -> None:
    assert add_within(one(gaze), one(0.0), -45.0, 45.0)[0] == gaze


@given(st.floats(-90.0, 90.0), st.floats(-90.0, 90.0))
def test_eyes_stay_in_their_ellipse(yaw: float, pitch: float) -> None:
    kept = eyes_within(np.array([[[yaw, pitch, 1.0]] * 2]))[0, 0]
    extent = np.hypot(kept[0] / 45.0, kept[1] / (28.0 if pitch > 0 else 47.0))
    assert extent <= 1.0 + 1e-12
    assert kept[2] == 1.0
    if extent < 0.999:
        assert kept[:2].tolist() == [yaw, pitch]
