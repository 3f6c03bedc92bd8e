"""A frame in a picture to a place in the room: signs, distances, tilt, against a projection the other way round."""

from __future__ import annotations

from math import cos, radians, sin, tan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.ir.values import Point
from facescript.live.seeing.geometry import EYE_LINE, FACE, Box, Camera

WIDTH, HEIGHT = 640, 480
LEVEL = Camera(Point(0.0, 0.0, 0.0))


def projected(camera: Camera, place: Point) -> Box:
    """The frame of a face whose eyes are at a place: the room turned before the camera, by matrices."""
    tilt = radians(camera.tilt)
    forward = np.array([0.0, sin(tilt), cos(tilt)])
    up = np.array([0.0, cos(tilt), -sin(tilt)])
    to_the_right_of_its_picture = np.cross(forward, up)
    away = np.array([place.x - camera.place.x, place.y - camera.place.y, place.z - camera.place.z])
    depth = away @ forward
    focal = WIDTH / 2 / tan(radians(camera.fov / 2))
    side = focal * FACE / depth
    u = WIDTH / 2 + focal * (away @ to_the_right_of_its_picture) / depth
    v = HEIGHT / 2 - focal * (away @ up) / depth
    return Box(u - side / 2, v - EYE_LINE * side, side, side)


def test_the_viewers_right_is_on_the_left_of_the_cameras_picture() -> None:
    left = LEVEL.locate(Box(100, 200, 60, 60), WIDTH, HEIGHT)
    right = LEVEL.locate(Box(480, 200, 60, 60), WIDTH, HEIGHT)
    assert left.x > 20 and right.x == pytest.approx(-left.x)
    mirrored = Camera(LEVEL.place, mirrored=True)
    assert mirrored.locate(Box(100, 200, 60, 60), WIDTH, HEIGHT).x == pytest.approx(right.x)


def test_what_is_higher_in_the_picture_is_higher_and_what_is_larger_is_nearer() -> None:
    high, low = (LEVEL.locate(Box(290, top, 60, 60), WIDTH, HEIGHT) for top in (50, 350))
    assert high.y > 20 and low.y < -20
    near, far = (LEVEL.locate(Box(320 - side / 2, 240, side, side), WIDTH, HEIGHT).z for side in (120, 60))
    assert near == pytest.approx(far / 2)
    assert far == pytest.approx(640 / 2 / tan(radians(30)) * FACE / 60)


def test_a_camera_that_looks_down_from_above_sees_a_face_below_itself() -> None:
    """The patent's kiosk: on top of it, 30 degrees down; who is in the middle of the picture is below the camera."""
    kiosk = Camera(Point(0.0, 60.0, 0.0), tilt=-30.0, fov=90.0)
    side = kiosk.focal(WIDTH) * FACE / 100.0
    place = kiosk.locate(Box(320 - side / 2, 240 - EYE_LINE * side, side, side), WIDTH, HEIGHT)
    assert (place.x, place.y, place.z) == pytest.approx((0.0, 60.0 - 50.0, 100.0 * cos(radians(30))))


CAMERAS = st.builds(
    Camera,
    st.builds(Point, st.floats(-50, 50), st.floats(-20, 80), st.floats(-10, 10)),
    tilt=st.floats(-40, 20),
    fov=st.floats(40, 110),
)


@given(CAMERAS, st.floats(-80, 80), st.floats(-40, 40), st.floats(60, 250))
@settings(max_examples=50)
def test_a_face_is_found_where_it_was(camera: Camera, x: float, y: float, z: float) -> None:
    place = Point(x, y, z)
    box = projected(camera, place)
    if not 0.0 < box.width < WIDTH:
        return
    found = camera.locate(box, WIDTH, HEIGHT)
    assert (found.x, found.y, found.z) == pytest.approx((x, y, z), abs=1e-6)


def test_at_a_set_distance_the_size_does_not_count() -> None:
    set_ = Camera(Point(0.0, 50.0, 0.0), tilt=-20.0, distance=90.0)
    boxes = [Box(400 - side / 2, 300 - EYE_LINE * side, side, side) for side in (40.0, 80.0, 120.0)]
    places = [set_.locate(box, WIDTH, HEIGHT) for box in boxes]
    assert all(place.z == pytest.approx(90.0) for place in places)
    assert places[0] == places[1] == places[2]


def test_frames_that_can_be_no_face_give_a_place_all_the_same() -> None:
    assert LEVEL.locate(Box(0, 0, 0.5, 0.5), WIDTH, HEIGHT).z == pytest.approx(2_000.0)
    down = Camera(Point(0.0, 0.0, 0.0), tilt=-80.0, distance=100.0)
    assert down.locate(Box(300, 470, 60, 60), WIDTH, HEIGHT).z < 20.0
