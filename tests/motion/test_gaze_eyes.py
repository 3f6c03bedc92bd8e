"""Both eyes for any head pose: they meet at the target, and the midline says where that is."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facescript.motion.gaze.eyes import APART_CM, eyes, midline


def angle(limit: float) -> st.SearchStrategy[float]:
    return st.floats(-limit, limit)


def one(sight: tuple[float, float, float], head: tuple[float, float, float]) -> np.ndarray:
    return eyes(np.array([sight]), np.array([head]))


@given(angle(25), angle(15), angle(20), angle(12), angle(25))
def test_gaze_stays_on_a_far_target_whatever_the_head_does(
    yaw: float, pitch: float, turn: float, nod: float, tilt: float
) -> None:
    head = np.array([[turn, nod, tilt]])
    found = midline(eyes(np.array([[yaw, pitch, 10_000.0]]), head), head)[0]
    cosine = np.cos(np.radians(found[1] - pitch)) - (1 - np.cos(np.radians(found[0] - yaw)))
    if np.abs(one((yaw, pitch, 10_000.0), (turn, nod, tilt))[0, :, :2] / [45, 28]).max() < 0.65:
        assert cosine > np.cos(np.radians(0.1))


def test_without_a_turned_head_the_eyes_turn_by_the_whole_direction() -> None:
    both = one((20, -10, 100_000.0), (0, 0, 0))[0]
    assert both[:, 0] == pytest.approx([20, 20], abs=0.01)
    assert both[:, 1] == pytest.approx([-10, -10], abs=0.01)


def test_a_head_turned_and_tilted_clockwise_needs_other_eyes() -> None:
    both = one((20, 0, 100_000.0), (0, 0, 90))[0]
    assert both[:, 0] == pytest.approx([0, 0], abs=0.01)
    assert both[:, 1] == pytest.approx([20, 20], abs=0.01)


@given(angle(15), angle(10), st.floats(25, 500))
def test_both_eyes_meet_at_the_target(yaw: float, pitch: float, distance: float) -> None:
    both = one((yaw, pitch, distance), (0, 0, 0))[0]
    y, p = np.radians(yaw), np.radians(pitch)
    point = distance * np.array([np.sin(y) * np.cos(p), np.sin(p), np.cos(y) * np.cos(p)])
    for side, x in ((0, APART_CM / 2), (1, -APART_CM / 2)):
        way = point - [x, 0, 0]
        assert both[side, 0] == pytest.approx(np.degrees(np.arctan2(way[0], way[2])), abs=1e-6)
        assert both[side, 1] == pytest.approx(np.degrees(np.arctan2(way[1], np.hypot(way[0], way[2]))), abs=1e-6)


def test_the_left_eye_turns_to_the_nose_to_see_what_is_near() -> None:
    left, right = one((0, 0, 30.0), (0, 0, 0))[0]
    assert left[0] < -5.9
    assert right[0] > 5.9


def test_eyes_that_cannot_reach_stop_without_a_corner() -> None:
    yaw = np.linspace(30, 80, 2001)
    sight = np.stack([yaw, np.zeros_like(yaw), np.full_like(yaw, 10_000.0)], axis=1)
    turned = eyes(sight, np.zeros((len(yaw), 3)))[:, 0, 0]
    assert turned.max() <= 45.0
    assert np.abs(np.diff(turned, 2)).max() < 0.001
    assert turned[yaw < 42] == pytest.approx(yaw[yaw < 42], abs=0.1)


def test_eyes_roll_as_listing_says() -> None:
    assert one((0, 20, 10_000.0), (0, 0, 0))[0, 0, 2] == pytest.approx(0, abs=0.01)
    assert one((20, 20, 10_000.0), (0, 0, 0))[0, 0, 2] == pytest.approx(3.56, abs=0.05)
