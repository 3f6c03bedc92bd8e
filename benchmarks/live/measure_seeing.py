"""Drawn persons before a camera of 640x480: what a picture costs, how far off the places are, who is mistaken for whom,
and how old a sighting is when it is told. With scikit-image, a photograph too.
"""

from __future__ import annotations

import asyncio
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from row import Row

sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "live" / "seeing"))
sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "live" / "persons"))
sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "motion"))
from drawn import FPS, film, scene
from watching import lag

from facescript.compile import Settings
from facescript.ir.values import Point
from facescript.live.clock import WallClock
from facescript.live.model import Happening, Sighting
from facescript.live.opening import open_play
from facescript.live.run.run import Run
from facescript.live.seeing.cascade import Cascade
from facescript.live.seeing.faces import Finder, Picture
from facescript.live.seeing.geometry import Camera
from facescript.live.seeing.mediapipe import MediaPipe, installed
from facescript.live.seeing.watch import Watcher
from facescript.live.sources.camera import VideoSource
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

Walk = Callable[[float], Point]

LEVEL = Camera(Point(0.0, 0.0, 0.0))
SECONDS = 4.0
BUDGET = 1000.0 / FPS
"""ms of a picture, where none is to be passed over."""

ONE: list[Walk] = [lambda time: Point(-40.0 + 20.0 * time, 0.0, 100.0)]
THREE: list[Walk] = [
    lambda time: Point(-60.0 + 40.0 * time, 0.0, 110.0),
    lambda time: Point(90.0 - 40.0 * time, 2.0, 85.0),
    lambda time: Point(-10.0 + 6.0 * time, -2.0, 140.0),
]


FOLLOWS = "film screen none\nface ada = woman\n    life still\nwhen person arrives as guest:\n    look at guest\n"

OLD = 0.08
"""How old a picture is when the run is told of it, s."""

BEHIND = 120
"""ms by which gaze may come after a face that moves steadily (bar)."""

TURN = 3.2
"""One who goes to and fro turns after so long, s."""


def to_and_fro(time: float) -> Point:
    """One who goes 15 degrees a second, a metre away."""
    return aside(-24.0 + 15.0 * (time if time < TURN else 2 * TURN - time))


def swaying(time: float) -> Point:
    """One who sways by 18 degrees, 0.3 times a second."""
    return aside(18.0 * float(np.sin(0.6 * np.pi * time)))


def aside(degrees: float) -> Point:
    return Point(100.0 * float(np.tan(np.radians(degrees))), 0.0, 100.0)


def rows() -> Iterator[Row]:
    finders: dict[str, Callable[[], Finder]] = {"cascade": Cascade}
    if installed():
        finders["MediaPipe"] = MediaPipe
    for name, made in finders.items():
        for what, walks in (("one who walks by", ONE), ("three who cross", THREE)):
            yield from _watched(f"{name}, {what}", made(), walks)
        yield from _photographed(name, made())
    yield from _told()
    for what, walk in (("goes to and fro", to_and_fro), ("sways", swaying)):
        late = _behind(walk) * 1000
        yield Row(
            f"one who {what}: from her to gaze, through pictures", f"{BEHIND} ms", f"{late:.0f} ms", late <= BEHIND
        )


def _watched(what: str, finder: Finder, walks: list[Walk]) -> Iterator[Row]:
    """Who is found, and at what cost, in pictures of some seconds."""
    watcher, costs, seen = Watcher(LEVEL, finder), [], []
    for number in range(int(SECONDS * FPS)):
        picture = scene(LEVEL, [walk(number / FPS) for walk in walks])
        begun = time.thread_time()
        items = list(watcher.look(picture, number / FPS))
        costs.append((time.thread_time() - begun) * 1000)
        seen += [item for item in items if isinstance(item, Sighting)]
    median, most = np.percentile(costs, (50, 95))
    yield Row(f"{what}: processor time a picture, mean", f"{BUDGET:.0f} ms", f"{np.mean(costs):.1f} ms", None)
    found = f"{median:.1f} and {most:.1f} ms"
    yield Row(f"{what}: median and 95 of 100", f"{BUDGET:.0f} ms", found, bool(np.mean(costs) < BUDGET))
    yield from _places(what, seen, walks)


def _places(what: str, seen: list[Sighting], walks: list[Walk]) -> Iterator[Row]:
    names: dict[int, list[str | None]] = {number: [] for number in range(len(walks))}
    wrong = []
    for one in seen:
        places = [walk(one.time) for walk in walks]
        whose = min(range(len(walks)), key=lambda number: _unlike(one.place, places[number]))
        names[whose].append(one.person)
        place = places[whose]
        wrong.append((one.place.x - place.x, one.place.y - place.y, one.place.z / place.z - 1.0))
    switches = sum(before != after for row in names.values() for before, after in pairwise(row))
    yield Row(f"{what}: sightings, of persons while they are there", "", str(len(seen)), None)
    yield Row(f"{what}: changes of name", "0", str(switches), switches == 0)
    x, y, z = np.abs(np.array(wrong)).mean(axis=0)
    yield Row(f"{what}: off, mean", "", f"{x:.1f} cm aside, {y:.1f} cm up, {z:.0%} of the distance", None)


def _unlike(seen: Point, place: Point) -> float:
    return abs(seen.x / seen.z - place.x / place.z) + 0.3 * abs(float(np.log(seen.z / place.z)))


def _photographed(name: str, finder: Finder) -> Iterator[Row]:
    """A photograph that moves sideways (NASA, in the public domain; it comes with scikit-image)."""
    try:
        from skimage.data import astronaut
    except ImportError:
        return
    photo = np.ascontiguousarray(astronaut()[:, :, ::-1])
    counts, costs = [], []
    for number in range(100):
        picture = np.full((480, 640, 3), 128, dtype=np.uint8)
        left = 64 + round(60 * np.sin(number / 10))
        picture[:, left : left + 512] = photo[:480]
        begun = time.thread_time()
        counts.append(len(finder.faces(picture)))
        costs.append((time.thread_time() - begun) * 1000)
    found = f"{sum(count > 0 for count in counts)}, and {sum(max(0, count - 1) for count in counts)} false"
    yield Row(f"{name}, a photograph: found, of 100", "100", found, counts == [1] * 100)
    yield Row(f"{name}, a photograph: the whole picture searched", "", f"{np.mean(costs):.1f} ms", None)


def _behind(walk: Walk) -> float:
    """By how much gaze comes after a face, s: pictures, the cascade, the path of a person and the eyes together."""
    watcher, fps = Watcher(LEVEL, Cascade()), 60.0
    told = [
        (number / FPS + OLD, item)
        for number in range(int(2 * TURN * FPS))
        for item in watcher.look(scene(LEVEL, [walk(number / FPS)]), number / FPS)
    ][::-1]
    play, _ = open_play(Source("x.face", FOLLOWS), World(Path()), Settings())
    assert play is not None
    run, yaws, times = Run(play, EstimatedVoice(), fps), [], np.arange(0.0, 2 * TURN, 1 / fps)
    for number, time_ in enumerate(times):
        while told and told[-1][0] <= time_:
            _, item = told.pop()
            run.see(item) if isinstance(item, Sighting) else run.hear(item)
        yaws.append(run.frame(number).values[run.layout.names.index("gaze.yaw")])
    places = [walk(float(time_)) for time_ in times]
    true = np.degrees([np.arctan2(place.x, place.z) for place in places])
    return lag(np.array(yaws)[times > 1.5], true[times > 1.5], rate=fps)


class _Ages:
    """How old sightings are when they are told."""

    def __init__(self, clock: WallClock) -> None:
        self.clock, self.ages = clock, list[float]()

    def event(self, happening: Happening) -> None: ...

    def sighting(self, sighting: Sighting) -> None:
        self.ages.append((self.clock.now() - sighting.time) * 1000)


def _told() -> Iterator[Row]:
    """From a picture's time to the sighting, over a video that plays in its own time."""
    pictures: list[Picture] = [scene(LEVEL, [ONE[0](number / FPS)]) for number in range(int(SECONDS * FPS))]
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as folder:
        path = Path(folder) / "walk.mp4"
        film(path, pictures)
        ages, counts = asyncio.run(_played(path))
    median, most = np.percentile(ages, (50, 99))
    yield Row("from a picture to the sighting, median and 99 of 100", "", f"{median:.0f} and {most:.0f} ms", None)
    yield Row("pictures looked at and passed over", "", f"{counts['pictures']} and {counts['passed over']}", None)


async def _played(path: Path) -> tuple[list[float], dict[str, Any]]:
    clock = WallClock()
    clock.begin()
    ages, source = _Ages(clock), VideoSource(path, (640, 480), clock, Watcher(LEVEL, Cascade()))
    task = asyncio.create_task(source.run(ages))
    await asyncio.sleep(SECONDS + 2.0)
    task.cancel()
    return ages.ages, source.counts()
