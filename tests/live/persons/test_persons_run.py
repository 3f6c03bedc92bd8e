"""Persons in a run: greeted, followed through others, scanned, let go of; and the film of what was seen is the run."""

from __future__ import annotations

from math import sin, tau

import numpy as np
import pytest
from watching import FPS, Camera, Live, People, Truth, lag, true_yaw

from facescript.ir.values import Point
from facescript.live.model import Happening, Sighting

HEAD = """film 640x360, seed 3, screen none, 60s long
face ada = woman
    life still
target ann at 0cm 0cm 1m
event ann arrives at 1s
"""
FOLLOWS = (
    HEAD
    + """scene main:
    repeat forever:
        wait 10s
when person arrives as guest:
    look at guest
when key "s":
    scan people nearest first, 600ms each, eyes only
when key "h":
    scan people, 600ms each
when key "q":
    show smile for 0.5s
when person nearest as guest:
    look at guest
"""
)


def arrives(time: float, person: str) -> Happening:
    return Happening("arrives", time, person=person)


def key(time: float, name: str) -> Happening:
    return Happening("key", time, name)


def crossing(phase: float, far: float) -> Truth:
    return lambda time: (60.0 * sin(tau * (0.15 * time + phase)), far)


THREE: People = {"person 1": crossing(0.0, 120.0), "person 2": crossing(0.33, 150.0), "person 3": crossing(0.66, 180.0)}


def test_one_of_three_is_followed_through_the_others() -> None:
    told = Camera(noise=0.3).sightings(THREE, 8.0)
    live = Live(
        FOLLOWS.partition("when person nearest")[0],
        told,
        [arrives(0.5, "person 1"), arrives(0.2, "person 3"), arrives(0.7, "person 2")],
    )
    seen = live.watch(8.0)
    later = seen["time"] > 3.0
    gaze = seen["gaze.yaw"][later]
    off = {name: np.std(gaze - true_yaw(truth, seen["time"][later])) for name, truth in THREE.items()}
    assert off["person 2"] < 4.0 < 15.0 < min(off["person 1"], off["person 3"])
    assert lag(gaze, true_yaw(THREE["person 2"], seen["time"][later])) <= 0.120
    assert np.abs(np.diff(seen["gaze.yaw"])).max() * FPS < 750.0
    assert np.abs(np.diff(seen["head.yaw"])).max() * FPS < 320.0


def test_a_crowd_that_moves_is_scanned_with_the_eyes_and_with_the_head() -> None:
    told = Camera(noise=0.3).sightings(THREE, 10.0)
    comes = [arrives(0.1 * number, person) for number, person in enumerate(THREE, 1)]
    text = FOLLOWS.replace("when person arrives as guest:\n    look at guest\n", "").partition("when person nearest")[0]
    seen = Live(text, told, [*comes, key(2.0, "s"), key(6.0, "h")]).watch(10.0)
    for start in (2.0, 6.0):
        for number, truth in enumerate(THREE.values()):
            at = int((start + 0.6 * number + 0.5) * FPS)
            assert seen["gaze.yaw"][at] == pytest.approx(true_yaw(truth, seen["time"][at : at + 1])[0], abs=2.5)
    eyes, head = (np.abs(seen["head.yaw"][int(a * FPS) : int((a + 2.4) * FPS)]).max() for a in (2.0, 6.0))
    assert eyes < 1.0 < 5.0 < head


def test_one_is_followed_as_before_whatever_else_happens_meanwhile() -> None:
    """What is over is forgotten every few seconds, and each event has all planned anew; the look that goes on stays."""
    told = Camera(noise=0.3).sightings({"person 2": THREE["person 2"]}, 10.0)
    text, comes = FOLLOWS.partition("when person nearest")[0], arrives(0.5, "person 2")
    alone = Live(text, told, [comes]).watch(10.0)
    among = Live(text, told, [comes, *(key(1.23 + 0.7 * number, "q") for number in range(11))]).watch(10.0)
    assert np.abs(among["cheek.lower.left"] - alone["cheek.lower.left"]).max() > 0.1
    for name in ("gaze.yaw", "gaze.pitch", "head.yaw", "head.pitch"):
        assert np.abs(among[name] - alone[name]).max() < 1e-9


def test_one_who_was_followed_for_long_is_let_go_of_and_found() -> None:
    """What was planned when the look began is long past by then, and not planned again."""

    def gone(time: float) -> tuple[float, float] | None:
        return None if 8.0 < time < 10.5 else (40.0, 120.0)

    text, comes = FOLLOWS.partition("when person nearest")[0], arrives(0.5, "person 1")
    seen = Live(text, Camera().sightings({"person 1": gone}, 12.0), [comes]).watch(12.0)
    yaw = [seen["gaze.yaw"][int(time * FPS)] for time in (7.9, 8.9, 10.0, 11.8)]
    assert yaw == pytest.approx([18.4, 18.4, 0.0, 18.4], abs=0.8)


def test_who_comes_nearer_is_looked_at() -> None:
    people: People = {
        "person 1": lambda _: (-40.0, 150.0),
        "person 2": lambda time: (40.0, 250.0 - 40.0 * min(time, 4.0)),
    }
    text = FOLLOWS.replace("when person arrives as guest:\n    look at guest\n", "")
    seen = Live(text, Camera().sightings(people, 6.0), [arrives(0.2, "person 1"), arrives(0.3, "person 2")]).watch(6.0)
    yaw = seen["gaze.yaw"]
    assert yaw[int(2.0 * FPS)] == pytest.approx(-14.9, abs=1.5)
    assert yaw[int(5.5 * FPS)] == pytest.approx(24.0, abs=2.5)
    assert np.count_nonzero(np.abs(np.diff(yaw)) * FPS > 100.0) < 30


def test_no_person_takes_the_place_of_a_crowd() -> None:
    text = FOLLOWS.partition("when person nearest")[0].replace(
        "when person", "target crowd of (0cm 0cm 1m)\nwhen person"
    )
    told = [(0.1, Sighting(name, 0.1, Point(40.0, 0.0, 120.0))) for name in ("crowd", "people")]
    live = Live(text, told, [arrives(0.2, "people"), arrives(0.3, "crowd"), key(0.5, "s")])
    seen = live.watch(1.5)
    assert live.run.doubts() == {"named as a crowd is": 4}
    assert np.abs(seen["gaze.yaw"]).max() < 1.0


def test_a_run_in_which_persons_come_and_go_is_bounded_and_never_jumps() -> None:
    def passing(number: int) -> Truth:
        return lambda time: (100.0 * (time - 6.0 * number) - 120.0, 150.0) if 0 <= time - 6.0 * number < 2.4 else None

    names = [f"person {number}" for number in range(1, 5)]
    people = {name: passing(number) for number, name in enumerate(names)}
    comes = [
        Happening(kind, 6.0 * number + at, person=name)
        for number, name in enumerate(names)
        for kind, at in (("arrives", 0.2), ("leaves", 3.4))
    ]
    live = Live(FOLLOWS, Camera().sightings(people, 24.0), comes)
    seen = live.watch(24.0)
    assert np.abs(np.diff(seen["gaze.yaw"])).max() * FPS < 750.0
    assert np.abs(np.diff(seen["head.yaw"])).max() * FPS < 320.0
    assert [target.name for target in live.run.score.targets] == ["ann", "person 3", "person 4"]
    for number in range(4):
        assert abs(seen["gaze.yaw"][int((6.0 * number + 1.7) * FPS)] - np.degrees(np.arctan2(50.0, 150.0))) < 4.0
        assert abs(seen["gaze.yaw"][int((6.0 * number + 5.5) * FPS)]) < 0.5
