"""Drawn persons before a camera, found by OpenCV's cascade: where they are, who is whom, and films of them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from itertools import chain

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2", reason="the package opencv-python-headless is not installed")

from drawn import scene  # noqa: E402

from facescript.ir.values import Point  # noqa: E402
from facescript.live.model import Happening, Sighting  # noqa: E402
from facescript.live.seeing.cascade import Cascade  # noqa: E402
from facescript.live.seeing.geometry import Camera  # noqa: E402
from facescript.live.seeing.watch import Watcher  # noqa: E402

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


def test_one_of_three_is_followed_through_the_others() -> None:
    """Two pass between her and the camera, one after the other, and hide her; all keep their names."""
    walks: list[Walk] = [
        lambda time: Point(-60.0 + 45.0 * time, 0.0, 110.0),
        lambda time: Point(90.0 - 40.0 * time, 2.0, 85.0),
        lambda time: Point(-10.0 + 6.0 * time, -2.0, 140.0),
    ]
    told = watched(LEVEL, walks, np.arange(0.0, 3.2, 1 / 15))
    names = defaultdict(set)
    for one in told:
        if isinstance(one, Sighting):
            names[whose(one, [walk(one.time) for walk in walks])].add(one.person)
    assert sorted(map(len, names.values())) == [1, 1, 1], names
    assert [item.kind for item in told if isinstance(item, Happening)] == ["arrives"] * 3


def whose(sighting: Sighting, places: list[Point]) -> int:
    """Whose place a sighting is most like, by direction and by distance."""
    seen = sighting.place
    unlike = [abs(one.x / one.z - seen.x / seen.z) + 0.3 * abs(np.log(one.z / seen.z)) for one in places]
    return int(np.argmin(unlike))


def test_a_picture_without_a_face_has_none() -> None:
    assert Cascade().faces(scene(LEVEL, [])) == []
    assert Cascade().faces(np.zeros((480, 640, 3), dtype=np.uint8)) == []
    assert Cascade().faces(scene(LEVEL, [Point(0.0, 0.0, 90.0)]), near=[]) == []
