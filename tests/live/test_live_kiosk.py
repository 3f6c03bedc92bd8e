"""The kiosk's example does what the patent's kiosk does, from its scripted events."""

from __future__ import annotations

from math import atan2, degrees
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import facescript
from facescript import Take

ROOT = Path(__file__).parents[2]
FLAT = 1 / 3
"""What of an angle the flat screen leaves (the patent's third)."""


@pytest.fixture(scope="module")
def kiosk() -> Take:
    return facescript.load(ROOT / "examples" / "kiosk.face")


def course(take: Take, name: str, start: float, end: float) -> NDArray[np.float64]:
    return np.array([take.pose(float(time))[name] for time in np.arange(start, end, 0.1)])


def range_of(values: NDArray[np.float64]) -> float:
    return float(np.ptp(values))


def test_it_attracts_until_somebody_comes_and_again_when_all_have_left(kiosk: Take) -> None:
    assert range_of(course(kiosk, "gaze.yaw", 0.0, 3.0)) > 30.0
    assert range_of(course(kiosk, "gaze.yaw", 31.0, 34.0)) > 30.0


def test_who_arrives_is_greeted_with_a_smile_and_followed(kiosk: Take) -> None:
    assert kiosk.pose(3.9)["cheek.lower.left"] > 0.4 > kiosk.pose(2.9)["cheek.lower.left"]
    assert kiosk.pose(3.5)["gaze.yaw"] == pytest.approx(FLAT * degrees(atan2(-135, 175)), abs=4.0)
    assert kiosk.pose(6.5)["gaze.yaw"] == pytest.approx(FLAT * degrees(atan2(-50, 100)), abs=2.0)
