"""Targets that no face could look at, built to channels: all of them finite, and no eye beyond its reach.

The eyes of the one face in a film of 1280x720 are 1.640625 cm above the picture's centre.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from facescript.compile import compile_source
from facescript.motion.perform import perform
from facescript.performance.channels import INDEX
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

SIDE, UP, DOWN = 45.0, 28.0, 47.0
"""How far eyes reach (bar S8), deg."""


def channels(text: str, folder: Path, times: np.ndarray) -> np.ndarray:
    result = compile_source(Source("script.face", text), World(folder), EstimatedVoice())
    assert result.score is not None, [item.message for item in result.diagnostics]
    (face,) = perform(result.score).faces.values()
    return face.sample(times)


def check(poses: np.ndarray) -> None:
    assert np.isfinite(poses).all()
    for side in ("left", "right"):
        yaw, pitch = (poses[:, INDEX[f"eye.{side}.{axis}"]] for axis in ("yaw", "pitch"))
        assert np.abs(yaw).max() <= SIDE
        assert -DOWN <= pitch.min() <= pitch.max() <= UP


KEYS = {
    "at the eye": "0s 0cm 1.640625cm 0cm\n    1s 0cm 1.640625cm 0cm",
    "through the head": "0s 0cm 0cm 2m\n    1s 0cm 0cm -2m\n    2s 0cm 0cm 2m",
    "past the eye at speed": "0s -1m 1.640625cm 1cm\n    10ms 1m 1.640625cm -1cm\n    20ms -1m 1.640625cm 1cm",
    "at infinity": "0s -100000m 100000m 100000m\n    1ms 100000m -100000m -100000m\n    2s 100000m 100000m 100000m",
    "one key": "1s 10cm 0cm 1m",
    "keys alike": "0s 10cm 0cm 1m\n    1s 10cm 0cm 1m\n    2s 10cm 0cm 1m",
    "beyond the film": "0s 10cm 0cm 1m\n    86400s -10cm 0cm 1m",
    "behind": "0s 10cm 0cm -1m\n    2s -10cm 0cm -1m",
    "straight up": "0s 0cm 1m 0cm\n    1s 0cm -1m 0cm\n    2s 0cm 1m 0cm",
    "touching": "0s 0cm 1.640625cm 1cm\n    1s 1cm 1.640625cm 0.1cm",
}


@pytest.mark.parametrize("manner", ["", ", eyes only", ", head only", ", head then eyes"])
@pytest.mark.parametrize("name", KEYS)
def test_wherever_a_target_moves_eyes_stay_in_their_reach(name: str, manner: str, tmp_path: Path) -> None:
    text = f"film screen none\nface ada = woman\ntarget fly moves\n    {KEYS[name]}\nlook at fly{manner}\nwait 3s\n"
    check(channels(text, tmp_path, np.arange(0.0, 3.0, 0.01)))


@pytest.mark.parametrize(
    "place",
    [
        "0cm 1.640625cm 0cm",
        "0cm 1.640625cm 0.001cm",
        "100000m 0cm 100000m",
        "0cm 0cm -1cm",
        "90deg 0deg 1cm",
        "0deg 90deg 1m",
    ],
)
def test_wherever_a_target_is_eyes_stay_in_their_reach(place: str, tmp_path: Path) -> None:
    text = f"film screen none\nface ada = woman\ntarget fly at {place}\nlook at fly\nwait 1s\nglance fly\n"
    check(channels(text, tmp_path, np.arange(0.0, 2.0, 0.01)))


def test_a_thousand_looks_a_second_at_a_moving_target(tmp_path: Path) -> None:
    looks = "target bee at -30cm 5cm 1m\ntarget fly moves\n    0s -80cm 0cm 1m\n    1s 80cm 0cm 1m\nrepeat 30 times:\n"
    looks += "    look at fly for 1ms\n    look at bee for 1ms\nwait 1s\n"
    check(channels(f"film screen none\nface ada = woman\n{looks}", tmp_path, np.arange(0.0, 2.0, 0.005)))


def test_a_tracked_file_full_of_holes(tmp_path: Path) -> None:
    rows = ["nan,nan,nan", "1e7,-1e7,1e7", "0,1.640625,0", ",,", "-1e7,0,-1e7", "inf,0,0", "0,0,100"]
    lines = [f"{number / 60:.4f},{rows[number * number % 7]}" for number in range(180)]
    (tmp_path / "track.csv").write_text("\n".join(["time,x,y,z", *lines]), "utf-8")
    text = 'film screen none\nface ada = woman\ntarget fly from "track.csv"\nlook at fly\nwait 3s\n'
    check(channels(text, tmp_path, np.arange(0.0, 3.0, 0.005)))


def test_eyes_cross_no_further_than_for_the_near_point(tmp_path: Path) -> None:
    """The near point is 8 cm away; the eyes are 6.3 cm apart."""
    crossed = []
    for distance in ("8cm", "4cm", "0.5cm"):
        start = "film screen none\nface ada = woman\n    life still\n"
        text = f"{start}target fly at 0cm 1.640625cm {distance}\nlook at fly\nwait 2s\n"
        pose = channels(text, tmp_path, np.array([1.9]))[0]
        crossed.append(pose[INDEX["eye.right.yaw"]] - pose[INDEX["eye.left.yaw"]])
    assert crossed == pytest.approx([2 * np.degrees(np.arctan(3.15 / 8))] * 3, abs=0.3)


# ------------------------------------------------------------------------------------------------ one among many

CROWD = """film screen none
face ada = woman
    life still
target ann moves
    0s -60cm 0cm 2m
    2s -20cm 0cm 2m
target bob moves
    0s 20cm 0cm 2m
    2s 60cm 0cm 2m
target carl moves
    0s 10cm 0cm 1m
    2s -90cm 0cm 2m
target people_here of ann bob carl
"""


def gaze(text: str, folder: Path, *times: float) -> list[float]:
    poses = channels(CROWD + text, folder, np.array(times))
    return [float(yaw) for yaw in poses[:, INDEX["gaze.yaw"]]]


def toward(x: float, z: float = 200.0) -> float:
    return float(np.degrees(np.arctan2(x, z)))


def test_one_among_moving_others_is_looked_at_and_no_other(tmp_path: Path) -> None:
    start, end = gaze("look at people_here.2\nwait 3s\n", tmp_path, 0.2, 3.0)
    assert start == pytest.approx(toward(21), abs=1.5)
    assert end == pytest.approx(toward(60), abs=0.3)


def test_the_nearest_stays_the_one_it_was(tmp_path: Path) -> None:
    assert gaze("look at people_here.nearest\nwait 3s\n", tmp_path, 3.0) == pytest.approx([toward(-90)], abs=0.3)


@pytest.mark.parametrize(
    "text", ["scan people_here, 1.5s each\nwait 1s\n", "repeat one in people_here:\n    look at one\n    wait 1.45s\n"]
)
def test_moving_members_are_looked_at_one_after_another(text: str, tmp_path: Path) -> None:
    """At 1.2 s ann is at -33 cm or so, later all have come to rest."""
    first, second, third = gaze(text, tmp_path, 1.2, 2.9, 4.4)
    assert toward(-40) < first < toward(-25)
    assert second == pytest.approx(toward(60), abs=0.5)
    assert third == pytest.approx(toward(-90), abs=0.5)


def test_a_tracked_member_arrives_and_is_the_nearest(tmp_path: Path) -> None:
    (tmp_path / "track.csv").write_text("time,x,y,z\n0,30,0,50\n3,31,0,50\n", "utf-8")
    text = (
        'target dan from "track.csv"\nlook at camera\nwait 3s\nwhen person arrives as guest:\n    look at guest\n'
        "event dan arrives at 1s\n"
    )
    before, after = gaze(text, tmp_path, 0.9, 2.9)
    assert (before, after) == pytest.approx((0, toward(31, 50)), abs=0.3)
