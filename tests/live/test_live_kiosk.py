"""The kiosk's example does what the patent's kiosk does, at its scripted events."""

from __future__ import annotations

from collections.abc import Mapping
from math import atan2, degrees
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import facescript
from facescript.ir.play import MovingTarget
from facescript.space.path import Path as Way

Course = Mapping[str, NDArray[np.float64]]

ROOT = Path(__file__).parents[2]
FPS = 10.0
FLAT = 1 / 3
"""What the flat screen leaves of an angle (the patent's third)."""


@pytest.fixture(scope="module")
def take() -> facescript.Take:
    return facescript.load(ROOT / "examples" / "kiosk.face")


@pytest.fixture(scope="module")
def course(take: facescript.Take) -> Course:
    return take.sample(fps=FPS)


def during(course: Course, name: str, start: float, end: float) -> NDArray[np.float64]:
    return course[name][(course["time"] >= start) & (course["time"] <= end)]


def test_it_attracts_until_somebody_comes_and_again_when_all_have_left(course: Course) -> None:
    assert np.ptp(during(course, "gaze.yaw", 0.0, 3.0)) > 30.0
    assert np.ptp(during(course, "gaze.yaw", 31.0, 34.0)) > 30.0


def test_who_arrives_is_greeted_with_a_smile(course: Course) -> None:
    assert (
        during(course, "cheek.lower.left", 0.0, 2.9).max() < 0.1 < 0.5 < during(course, "cheek.lower.left", 4, 5).min()
    )


def test_the_crowd_is_scanned_with_the_eyes_only_and_then_with_the_head(course: Course) -> None:
    eyes, both = (13.1, 14.8), (14.9, 17.4)
    assert np.ptp(during(course, "gaze.yaw", *eyes)) > 25.0 and np.ptp(during(course, "head.yaw", *eyes)) < 2.0
    assert np.ptp(during(course, "gaze.yaw", *both)) > 25.0 and np.ptp(during(course, "head.yaw", *both)) > 15.0


def test_one_of_three_is_followed_through_the_others(take: facescript.Take, course: Course) -> None:
    """Ann, while the two others pass behind her."""
    ways = {
        target.name: Way(target.times, target.places)
        for target in take.job.play.targets
        if isinstance(target, MovingTarget)
    }
    times = np.arange(18.5, 23.0, 1 / FPS)
    off = {name: np.abs(during(course, "gaze.yaw", 18.49, 22.99) - sides(way, times)) for name, way in ways.items()}
    assert off["ann"].max() < 3.0
    assert off["bo"].max() > 15.0 and off["cleo"].max() > 5.0


def sides(way: Way, times: NDArray[np.float64]) -> NDArray[np.float64]:
    """Where somebody is aside, as it is drawn, deg."""
    places = [way.at(float(time)) for time in times]
    return np.array([FLAT * degrees(atan2(place.x, place.z)) for place in places])


def test_a_touch_excites_a_no_makes_a_frown_and_a_key_the_inquisitive_look(course: Course) -> None:
    assert (
        during(course, "brow.outer.left", 7.6, 8.8).min() > 0.5
        and during(course, "cheek.lower.left", 7.6, 8.8).min() > 0.5
    )
    assert during(course, "brow.lower.left", 24.6, 25.8).min() > 0.5
    asked = [during(course, f"brow.outer.{side}", 27.6, 28.8) for side in ("left", "right")]
    assert asked[0].max() < 0.2 and asked[1].min() > 0.5
