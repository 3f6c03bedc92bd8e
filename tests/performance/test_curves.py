"""The curves channels are made of: exact where nothing happens, the same value however they are asked."""

from __future__ import annotations

import numpy as np
import pytest

from facescript.performance.curves import Pulses, Ramp, Spline, Steps, Wander
from facescript.performance.easing import smooth, through

BUMP = through((0.0, 0.0), (0.5, 1.0), (1.0, 0.0))
PULSES = Pulses(np.array([1.0, 3.0]), np.array([1.0, 0.5]), np.array([2.0, -1.0]), BUMP)
STEPS = Steps(np.array([1.0, 3.0]), np.array([1.0, 0.5]), np.array([2.0, -1.0]))
WANDER = Wander(1.0, 0.5, np.array([0.0, 1.0, -1.0, 0.5]))
SPLINE = Spline(1.0, 0.5, np.array([3.0, -3.0, 1.5]))


def at(curve: Ramp | Pulses | Steps | Wander | Spline, *times: float) -> list[float]:
    return curve.at(np.array(times)).tolist()


def test_ramp_rises_once() -> None:
    assert at(Ramp(1.0, 2.0), 0.0, 1.0, 1.5, 2.0, 9.0) == [0.0, 0.0, 0.5, 1.0, 1.0]


def test_ramp_without_length_is_a_step() -> None:
    assert at(Ramp(1.0, 1.0), 0.999, 1.0) == [0.0, 1.0]


def test_a_ramp_that_never_comes_stays_at_nothing() -> None:
    assert at(Ramp(np.inf, np.inf), 0.0, 1e9) == [0.0, 0.0]


def test_pulses_come_back_to_exactly_nothing() -> None:
    assert at(PULSES, 0.0, 1.0, 1.5, 2.0, 2.5, 3.25, 3.5, 9.0) == [0.0, 0.0, 2.0, 0.0, 0.0, -1.0, 0.0, 0.0]


def test_steps_keep_the_pose_they_reached() -> None:
    assert at(STEPS, 0.0, 1.0, 1.5, 2.0, 2.9, 3.25, 3.5, 9.0) == [0.0, 0.0, 1.0, 2.0, 2.0, 0.5, -1.0, -1.0]


def test_wander_meets_its_knots_and_holds_its_ends() -> None:
    assert at(WANDER, 0.0, 1.0, 1.5, 2.0, 2.5, 9.0) == [0.0, 0.0, 1.0, -1.0, 0.5, 0.5]


def test_a_spline_weighs_three_knots_and_is_nothing_far_from_all() -> None:
    assert at(SPLINE, -9.0, 0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 99.0) == [0.0, 0.0, 0.5, 1.5, -1.25, 0.5, 0.25, 0.0, 0.0]
    assert at(Spline(0.0, 0.5, np.array([])), -1.0, 0.0, 1.0) == [0.0, 0.0, 0.0]


def test_the_acceleration_of_a_spline_is_continuous() -> None:
    times = np.linspace(-0.5, 3.5, 4_001)
    bend = np.diff(SPLINE.at(times), 2) / np.square(np.diff(times)[:-1])
    assert np.abs(np.diff(bend)).max() < 0.02 * np.abs(bend).max()


@pytest.mark.parametrize("curve", [PULSES, STEPS, WANDER, SPLINE, Ramp(0.5, 3.0)])
def test_position_and_speed_are_continuous(curve: Pulses | Steps | Wander | Spline | Ramp) -> None:
    times = np.linspace(0.0, 4.0, 40_001)
    values = curve.at(times)
    speed = np.diff(values) / np.diff(times)
    assert np.abs(np.diff(values)).max() < 2e-3
    assert np.abs(np.diff(speed)).max() < 0.02 * np.abs(speed).max()


@pytest.mark.parametrize("curve", [Pulses(*[np.array([])] * 3, smooth), Steps(*[np.array([])] * 3)])
def test_a_curve_without_events_is_nothing(curve: Pulses | Steps) -> None:
    assert at(curve, 0.0, 1.0) == [0.0, 0.0]
