"""A made-up camera of 30 pictures a second, late and trembling, to how a face follows whom it sees: as drawn, in a run.

Pictures are told of 30 to 100 ms late, their places off by 4 mm from side to side and by 3 % in depth, 1.2 m away.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import radians, sin, tan, tau
from pathlib import Path

import numpy as np
from row import Row

TESTS = Path(__file__).parents[2] / "tests"
sys.path += [str(TESTS / "live" / "persons"), str(TESTS / "motion")]

from watching import FPS, Camera, Live, Truth, lag, true_yaw  # noqa: E402

from facescript.live.model import Happening  # noqa: E402

SCRIPT = """film 640x360, seed 3, screen none, 60s long
face ada = woman
    life still
scene main:
    repeat forever:
        wait 10s
when person arrives as guest:
    look at guest
"""
AWAY = 120.0
SEEDS = (1, 2, 3)
FINE, COARSE = Camera(), Camera(noise=1.5, depth=0.1)
"""A camera as faces are found well, and as a cascade finds them."""

LAG = 0.120
GAZE, HEAD = 750.0, 320.0

HOUR, FEW = 3600, 5.0
"""Seconds that somebody is followed, and frames a second that are asked for meanwhile."""


@dataclass(frozen=True)
class Followed:
    """By how much gaze comes after a face (s), how far it is from it (deg, root mean square), and top speeds."""

    lag: float
    off: float
    gaze: float
    head: float


def rows() -> Iterator[Row]:
    for speed in (5, 10, 20, 30):
        yield _in_time(f"a face that moves steadily, {speed} deg/s", steady(float(speed)), LAG)
    for rate in (0.2, 0.3, 0.4, 0.5):
        for wide in (8.0, 18.0):
            yield _in_time(f"a face that sways by {wide:.0f} deg, {rate} Hz", swaying(rate, wide), LAG)
    yield _in_time("the same at 0.3 Hz, its places off by 1.5 cm and 10 %", swaying(0.3, 18.0), LAG, COARSE)
    yield _top_speeds()
    for camera in (Camera(noise=0.2), FINE, Camera(noise=0.8), COARSE):
        yield _calm(camera)
    yield from _long()


def steady(speed: float) -> Truth:
    """To and fro over 40 deg, turning at once."""
    return lambda now: at(20.0 - abs((speed * now) % 80.0 - 40.0))


def swaying(rate: float, wide: float) -> Truth:
    return lambda now: at(wide * sin(tau * rate * now))


def at(yaw: float) -> tuple[float, float]:
    return AWAY * tan(radians(yaw)), AWAY


def _in_time(what: str, truth: Truth, bar: float, camera: Camera = FINE) -> Row:
    found = [_followed(truth, replace(camera, seed=seed)) for seed in SEEDS]
    _ALL.extend(found)
    worst, off = max(one.lag for one in found), max(one.off for one in found)
    return Row(
        f"{what}: gaze after it", f"{bar * 1000:.0f} ms", f"{worst * 1000:.0f} ms, {off:.1f} deg rms", worst <= bar
    )


_ALL: list[Followed] = []


def _followed(truth: Truth, camera: Camera) -> Followed:
    seen = _watched(truth, camera, 14.0)
    later = seen["time"] > 3.0
    gaze, true = seen["gaze.yaw"][later], true_yaw(truth, seen["time"][later])
    gaze_top, head_top = (_speed(seen[f"{part}.yaw"], seen[f"{part}.pitch"]) for part in ("gaze", "head"))
    return Followed(lag(gaze, true), float(np.std(gaze - true)), gaze_top, head_top)


def _speed(yaw: np.ndarray, pitch: np.ndarray) -> float:
    """The most that is turned from a frame to the next, deg/s."""
    return float(np.hypot(np.diff(yaw), np.diff(pitch)).max()) * FPS


def _watched(truth: Truth, camera: Camera, seconds: float) -> dict[str, np.ndarray]:
    told = camera.sightings({"person 1": truth}, seconds)
    return Live(SCRIPT, told, [Happening("arrives", 0.5, person="person 1")]).watch(seconds)


def _top_speeds() -> Row:
    gaze, head = max(one.gaze for one in _ALL), max(one.head for one in _ALL)
    bar = f"gaze {GAZE:.0f}, head {HEAD:.0f} deg/s"
    found = f"gaze {gaze:.0f}, head {head:.0f} deg/s"
    return Row("the fastest in all of these", bar, found, gaze <= GAZE and head <= HEAD)


def _calm(camera: Camera) -> Row:
    """How calm gaze is on one who stands."""
    found = [_watched(lambda _: (30.0, AWAY), replace(camera, seed=seed), 14.0) for seed in SEEDS]
    gazes = [seen["gaze.yaw"][seen["time"] > 3.0] for seen in found]
    heads = [seen["head.yaw"][seen["time"] > 3.0] for seen in found]
    spread, head = (max(float(np.std(one)) for one in each) for each in (gazes, heads))
    pace = max(float(np.sqrt(np.mean(np.square(np.diff(one) * FPS)))) for one in gazes)
    told = f"gaze {spread:.2f} deg, {pace:.1f} deg/s; head {head:.2f} deg"
    off = f"{np.degrees(camera.noise / AWAY):.2f} deg and {camera.depth * 100:.0f} %"
    return Row(f"a face that stands, its places off by {off}: gaze strays by", "-", told, None)


def _long() -> Iterator[Row]:
    """What a second of following costs, in the first minute of an hour and in the last."""
    told = Camera(rate=10.0).sightings({"person 1": swaying(0.3, 18.0)}, float(HOUR))
    live = Live(SCRIPT, told, [Happening("arrives", 0.5, person="person 1")], FEW)
    costs, sizes, start = [], [], time.process_time()
    for number, _ in enumerate(live.frames(float(HOUR)), 1):
        if number % int(60 * FEW) == 0:
            costs.append((time.process_time() - start) / 60.0)
            sizes.append(_size(live))
            start = time.process_time()
    first, last = float(np.median(costs[2:12])), float(np.median(costs[-10:]))
    what = f"a second of following at {FEW:.0f} frames a second, minutes 3 to 12 of an hour"
    yield Row(what, "-", f"{first * 1000:.1f} ms of the processor", None)
    yield Row("the same, its last ten minutes", "no more", f"{last * 1000:.1f} ms", last <= 1.1 * first)
    yield Row("what is kept of her, after 10 minutes and after 60", "the same", f"{sizes[9]}, {sizes[-1]} legs", None)


def _size(live: Live) -> int:
    """The legs of all paths that are kept."""
    return sum(len(target.trail.legs) for target in live.run.score.targets)
