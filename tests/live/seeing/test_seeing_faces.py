"""Drawn persons before a camera, found by OpenCV's cascade: where they are, who is whom, and films of them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from itertools import chain
from pathlib import Path

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2", reason="the package opencv-python-headless is not installed")

from drawn import scene  # noqa: E402

from facescript.compile import Settings  # noqa: E402
from facescript.ir.values import Point  # noqa: E402
from facescript.live.model import Happening, Sighting  # noqa: E402
from facescript.live.opening import open_play  # noqa: E402
from facescript.live.run.run import Run  # noqa: E402
from facescript.live.seeing.cascade import Cascade  # noqa: E402
from facescript.live.seeing.geometry import Camera  # noqa: E402
from facescript.live.seeing.watch import Watcher  # noqa: E402
from facescript.speech.estimate import EstimatedVoice  # noqa: E402
from facescript.text import Source as Script  # noqa: E402
from facescript.world import World  # noqa: E402

FOLLOWS = "film screen none\nface ada = woman\n    life still\nwhen person arrives as guest:\n    look at guest\n"

Walk = Callable[[float], Point]

LEVEL = Camera(Point(0.0, 0.0, 0.0))
KIOSK = Camera(Point(0.0, 70.0, 0.0), tilt=-30.0, fov=80.0)


def watched(camera: Camera, walks: list[Walk], times: np.ndarray) -> list[Sighting | Happening]:
    watcher = Watcher(camera, Cascade())
    pictures = ((scene(camera, [walk(time) for walk in walks]), float(time)) for time in times)
    return list(chain.from_iterable(watcher.look(*taken) for taken in pictures))


@pytest.mark.parametrize("camera", [LEVEL, KIOSK], ids=["level", "the patent's"])
def test_one_who_walks_by_is_found_in_every_picture_and_where_she_is(camera: Camera) -> None:
    """To the viewers' right: from the right to the left of the camera's picture."""

    def walk(time: float) -> Point:
        return Point(-20.0 + 30.0 * time, 5.0, 90.0)

    told = watched(camera, [walk], np.arange(0.0, 1.2, 1 / 20))
    seen = [item for item in told if isinstance(item, Sighting)]
    assert [(item.kind, item.person) for item in told if isinstance(item, Happening)] == [("arrives", "person 1")]
    assert len(seen) >= 0.95 * 0.7 * 20 and {one.person for one in seen} == {"person 1"}
    aside = np.array([one.place.x - walk(one.time).x for one in seen])
    assert np.abs(aside).max() < 6.0 and np.abs(np.diff(aside)).max() < 3.0
    assert max(abs(one.place.z / 90.0 - 1.0) for one in seen) < 0.2
    up = (
        3.0 if camera.tilt == 0.0 else 0.2 * 90.0
    )  # from above, what is wrong with the distance is wrong with the height
    assert max(abs(one.place.y - 5.0) for one in seen) < up


CROSSING: list[Walk] = [
    lambda time: Point(-60.0 + 45.0 * time, 0.0, 110.0),
    lambda time: Point(90.0 - 40.0 * time, 2.0, 85.0),
    lambda time: Point(-10.0 + 6.0 * time, -2.0, 140.0),
]
"""Two pass between the third and the camera, one after the other, and hide her."""


@pytest.fixture(scope="module")
def crossing() -> list[Sighting | Happening]:
    return watched(LEVEL, CROSSING, np.arange(0.0, 3.2, 1 / 15))


def test_three_who_cross_keep_their_names(crossing: list[Sighting | Happening]) -> None:
    names = defaultdict(set)
    for one in crossing:
        if isinstance(one, Sighting):
            names[whose(one, [walk(one.time) for walk in CROSSING])].add(one.person)
    assert sorted(map(len, names.values())) == [1, 1, 1], names
    assert [item.kind for item in crossing if isinstance(item, Happening)] == ["arrives"] * 3


def test_a_face_follows_one_of_three_through_the_others(crossing: list[Sighting | Happening]) -> None:
    """From pictures to gaze, in a run that is told of each picture as soon as it is seen. Whom it follows is not the
    nearest all the while; of the others' coming it is not told."""
    play, _ = open_play(Script("x.face", FOLLOWS), World(Path()), Settings())
    assert play is not None
    run, fps = Run(play, EstimatedVoice(), 30.0), 30.0
    told = [one for one in crossing if isinstance(one, Sighting) or one.person == "person 1"][::-1]
    times, yaws = np.arange(0.0, 3.0, 1 / fps), []
    for number, time in enumerate(times):
        while told and told[-1].time <= time:
            one = told.pop()
            run.see(one) if isinstance(one, Sighting) else run.hear(one)
        yaws.append(run.frame(number).values[run.layout.names.index("gaze.yaw")])
    first = next(one for one in crossing if isinstance(one, Sighting) and one.person == "person 1")
    walk = CROSSING[whose(first, [walk(first.time) for walk in CROSSING])]
    sides = np.degrees([np.arctan2(walk(time).x, walk(time).z) for time in times])
    assert np.abs(np.array(yaws) - sides)[times > 1.0].max() < 6.0


def whose(sighting: Sighting, places: list[Point]) -> int:
    """Whose place a sighting is most like, by direction and by distance."""
    seen = sighting.place
    unlike = [abs(one.x / one.z - seen.x / seen.z) + 0.3 * abs(np.log(one.z / seen.z)) for one in places]
    return int(np.argmin(unlike))


def test_a_picture_without_a_face_has_none() -> None:
    assert Cascade().faces(scene(LEVEL, [])) == []
    assert Cascade().faces(np.zeros((480, 640, 3), dtype=np.uint8)) == []
    assert Cascade().faces(scene(LEVEL, [Point(0.0, 0.0, 90.0)]), near=[]) == []
