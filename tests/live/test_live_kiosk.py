"""The kiosk's example does what the patent's kiosk does: at its scripted events, and in a run that sees persons."""

from __future__ import annotations

from collections.abc import Mapping
from math import atan2, degrees
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import facescript
from facescript.compile import Settings
from facescript.ir.play import MovingTarget
from facescript.ir.values import Point
from facescript.live.model import Happening, Sighting
from facescript.live.opening import open_play
from facescript.live.run.run import Run
from facescript.space.path import Path as Way
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

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


PERSONS = {
    "person 1": (2.0, lambda time: Point(-60 + 9 * time, 0, 100)),
    "person 2": (3.0, lambda time: Point(250 - 25 * time, 0, 160)),
    "person 3": (4.0, lambda time: Point(-280 + 25 * time, 0, 200)),
}
"""When each arrives, and where she is; the first is nearest, and the others pass behind her."""

SLOW = 6.0
GONE = 13.0


def test_a_run_follows_one_of_three_and_attracts_again_when_all_have_gone() -> None:
    play, _ = open_play(Source("kiosk.face", (ROOT / "examples" / "kiosk.face").read_text()), World(ROOT), Settings())
    assert play is not None
    run = Run(play, EstimatedVoice(), SLOW)
    waiting = [Happening("arrives", time, person=person) for person, (time, _) in PERSONS.items()]
    waiting += [Happening("touched", 5.0, "Who is there?")]
    waiting += [Happening("leaves", GONE + 1.0, person=person) for person in PERSONS]
    waiting += [Happening("signal", GONE + 3.0, "absence")]
    found = []
    for number in range(int((GONE + 5.2) * SLOW)):
        time = number / SLOW
        for person, (start, way) in PERSONS.items():
            if start <= time < GONE:
                run.see(Sighting(person, time, way(time)))
        while waiting and waiting[0].time <= time:
            run.hear(waiting.pop(0))
        found.append(run.frame(number).values)
    times, values = np.arange(len(found)) / SLOW, np.array(found).T
    live = {"time": times, **dict(zip(run.layout.names, values, strict=True))}
    _, first = PERSONS["person 1"]
    sides = [FLAT * degrees(atan2(first(time).x, first(time).z)) for time in times]
    followed = (times > 9.8) & (times < GONE - 0.2)
    assert np.abs(live["gaze.yaw"] - sides)[followed].max() < 3.0
    assert during(live, "cheek.lower.left", 2.6, 4.9).min() > 0.5
    assert np.ptp(during(live, "gaze.yaw", 5.1, 6.7)) > 10.0
    assert np.ptp(during(live, "head.yaw", 5.1, 6.7)) < 3.0
    assert np.ptp(during(live, "gaze.yaw", 0.0, 1.9)) > 30.0 < np.ptp(during(live, "gaze.yaw", GONE + 3, GONE + 6))
