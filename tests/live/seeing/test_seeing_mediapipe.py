"""The same drawn persons, found by MediaPipe where one is installed that comes with its models."""

from __future__ import annotations

import numpy as np
import pytest

from facescript.ir.values import Point
from facescript.live.model import Sighting
from facescript.live.seeing.geometry import Camera
from facescript.live.seeing.mediapipe import MediaPipe, installed
from facescript.live.seeing.watch import Watcher

pytestmark = pytest.mark.skipif(not installed(), reason="no mediapipe is installed that comes with its models")

LEVEL = Camera(Point(0.0, 0.0, 0.0))


def test_two_who_walk_by_are_found_where_they_are() -> None:
    from drawn import scene

    watcher = Watcher(LEVEL, MediaPipe())
    seen = []
    for time in np.arange(0.0, 1.2, 1 / 20):
        places = [Point(-35.0 + 20.0 * time, 0.0, 80.0), Point(35.0 - 10.0 * time, 0.0, 100.0)]
        told = watcher.look(scene(LEVEL, places), float(time))
        seen += [(item, places) for item in told if isinstance(item, Sighting)]
    assert {one.person for one, _ in seen} == {"person 1", "person 2"} and len(seen) > 0.9 * 2 * 0.6 * 20
    for one, places in seen:
        assert min(abs(one.place.x - place.x) for place in places) < 6.0
        assert min(abs(one.place.z / place.z - 1.0) for place in places) < 0.25
