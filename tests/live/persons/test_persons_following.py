"""How a face follows whom it sees: like a film of all that was seen, in time, calmly, and for as long as it takes."""

from __future__ import annotations

from math import sin, tau

import numpy as np
import pytest
from gazing import request
from watching import EYES, FPS, VISITOR, Camera, Watcher, lag, looked, true_yaw, watch

from facescript.ir.acts import GazeManner
from facescript.ir.values import AtCamera, AtTarget, Point
from facescript.live.model import Sighting
from facescript.motion.gaze import live
from facescript.space import trail

FASTEST = 750.0, 320.0
"""Degrees a second that gaze and head turn at most."""


def swaying(time: float) -> tuple[float, float]:
    return 40.0 * sin(tau * 0.3 * time), 120.0


def away_for_a_while(time: float) -> tuple[float, float] | None:
    return None if 4.0 < time < 6.0 else (30.0 if time < 5.0 else -30.0, 120.0)


@pytest.mark.parametrize("peeks", [0.0, 0.4])
def test_a_run_is_the_film_of_all_that_was_seen(peeks: float) -> None:
    looks = [
        request(0, AtTarget(VISITOR), 1.0),
        request(1, AtCamera(), 3.01, released=3.6),
        request(2, AtTarget(VISITOR), 5.2, GazeManner("head then eyes")),
        request(3, AtTarget(VISITOR), 6.13, GazeManner("eyes only"), glance=True, released=7.0),
        request(4, AtCamera(), 7.42, GazeManner("head only")),
    ]
    watcher = Watcher(looks, peeks=peeks)
    seen = watch(Camera().sightings({VISITOR: swaying}, 8.0), 8.0, watcher)
    film = looked(watcher.afresh(), seen.times)
    shown = np.stack([seen.times, seen.gaze, seen.pitch, seen.head], axis=1)
    assert np.array_equal(shown, film)


def test_one_who_is_lost_is_let_go_of_and_found_again_without_a_jump() -> None:
    watcher = Watcher()
    seen = watch(Camera().sightings({VISITOR: away_for_a_while}, 8.0), 8.0, watcher)
    film = looked(watcher.afresh(), seen.times)
    assert np.array_equal(np.stack([seen.times, seen.gaze, seen.pitch, seen.head], axis=1), film)
    assert seen.part(3.5, 4.0).gaze == pytest.approx(14.0, abs=0.6)
    assert seen.part(4.2, 4.9).gaze == pytest.approx(14.0, abs=0.6)
    assert seen.part(5.5, 6.0).gaze == pytest.approx(0.0, abs=0.1)
    assert seen.part(6.6).gaze == pytest.approx(-14.0, abs=0.8)
    assert np.abs(np.diff(seen.gaze)).max() * FPS < FASTEST[0]
    assert np.abs(np.diff(seen.head)).max() * FPS < FASTEST[1]


@pytest.mark.parametrize("rate", [10.0, 30.0])
def test_a_moving_face_is_followed_in_time(rate: float) -> None:
    seen = watch(Camera(rate=rate).sightings({VISITOR: swaying}, 9.0), 9.0).part(2.5)
    assert lag(seen.gaze, true_yaw(swaying, seen.times)) <= 0.120
    assert np.abs(np.diff(seen.gaze)).max() * FPS < FASTEST[0]
    assert np.abs(np.diff(seen.head)).max() * FPS < FASTEST[1]


def test_a_standing_face_is_looked_at_calmly() -> None:
    seen = watch(Camera().sightings({VISITOR: lambda _: (20.0, 120.0)}, 10.0), 10.0).part(3.0)
    assert np.std(seen.gaze) < 0.25
    assert np.sqrt(np.mean(np.square(np.diff(seen.gaze) * FPS))) < 2.0
    assert np.std(seen.head) < 0.1


def test_following_for_long_keeps_no_more_than_for_a_while(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is kept for a minute, and for half of one, is kept for three seconds here."""
    monkeypatch.setattr(live, "KEPT", 600)
    monkeypatch.setattr(trail, "KEPT", 3.0)
    watcher, sizes = Watcher(), []
    told = Camera().sightings({VISITOR: swaying}, 22.0)
    for number, _ in enumerate(watcher.frames(told, 22.0, 10.0)):
        if number % 40 == 39:
            (target,) = watcher.persons.targets
            (pursuit,) = target.pursuits.values()
            sizes.append((len(target.trail.legs), len(pursuit._rows), len(pursuit._saccades), len(pursuit._marks)))
    for early, late in zip(map(max, *sizes[:3]), map(max, *sizes[3:]), strict=True):
        assert late <= 1.2 * early


def test_a_place_told_once_is_looked_at_until_its_person_leaves() -> None:
    watcher = Watcher()
    frames = watcher.frames([(0.5, Sighting(VISITOR, 0.5, Point(40.0, EYES, 120.0)))], 9.0)
    early = [next(frames) for _ in range(300)]
    assert early[-1][1] == pytest.approx(18.43, abs=0.1)
    watcher.persons.leave(VISITOR)
    assert list(frames)[-1][1] == pytest.approx(0.0, abs=0.1)
