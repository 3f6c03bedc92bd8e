"""Where faces stand, where targets are, and in which direction a face sees them."""

from __future__ import annotations

from itertools import pairwise
from math import atan, atan2, degrees, hypot

import pytest
from hypothesis import given
from hypothesis import strategies as st

from facescript.ir.acts import Life, Voice
from facescript.ir.play import Crowd, Face, Film, FixedTarget, MovingTarget
from facescript.ir.values import Aim, AtCamera, AtFace, AtPerson, AtTarget, PicturePlace, Point, Towards
from facescript.space.layout import BOX, EYES, lay_out
from facescript.space.path import Path
from facescript.space.room import Room, screen_fraction
from facescript.text import Source, Span

HERE = Span(Source("made.face", ""), 0, 0)


def face(name: str, kind: str = "woman", **more: object) -> Face:
    return Face(name, kind, Voice(), Life("still"), HERE, **more)


ADA, BRUNO, NARRATOR = face("ada"), face("bruno", "man"), face("narrator", "unseen")
FILM = Film(1280, 720, wide_cm=50.0, screen=1 / 3)

TARGETS = (
    FixedTarget("lamp", Point(100, 50, 200), HERE),
    FixedTarget("chart", PicturePlace(-0.25, 0.1), HERE),
    MovingTarget("visitor", (0.0, 4.0), (Point(-80, 0, 200), Point(80, 10, 200)), HERE),
    Crowd("crowd", (Point(-60, 0, 200), "lamp", PicturePlace(0, 0), "visitor", "bruno"), HERE),
)


def room(screen: float = 1 / 3, *faces: Face) -> Room:
    return Room(Film(1280, 720, wide_cm=50.0, screen=screen), faces or (ADA,), TARGETS)


# ------------------------------------------------------------------------------------------------ where faces stand


def test_faces_stand_in_equal_slots_from_the_viewers_left() -> None:
    places = lay_out(FILM, (ADA, NARRATOR, BRUNO)).standings
    assert list(places) == ["ada", "bruno"]
    assert places["ada"].eyes == pytest.approx((320, 40 + 640 * EYES[1] / BOX))
    assert places["bruno"].eyes == pytest.approx((960, 40 + 640 * EYES[1] / BOX))
    assert places["ada"].scale == pytest.approx(640 / 720)


def test_one_face_fills_the_height_of_a_wide_film_and_the_width_of_a_tall_one() -> None:
    assert lay_out(FILM, (ADA,)).standings["ada"].scale == 1
    assert lay_out(Film(1080, 1920), (ADA,)).standings["ada"].scale == 1.5


def test_a_face_with_a_place_stands_there_and_leaves_the_row_to_the_others() -> None:
    places = lay_out(FILM, (ADA, face("guest", place=PicturePlace(0.25, 0.1), size=0.5))).standings
    assert places["ada"].eyes[0] == 640
    assert places["guest"].scale == 0.5
    assert places["guest"].px((360, 360)) == pytest.approx((960, 288))


def test_pixels_become_centimetres_from_the_centre_up_and_to_the_right() -> None:
    layout = lay_out(FILM, (ADA,))
    assert layout.room((640, 360)) == (0, 0)
    assert layout.room((1280, 0)) == pytest.approx((25, 14.0625))
    assert layout.place(PicturePlace(0.5, 0.5)) == pytest.approx((25, 14.0625))
    assert layout.part("ada", EYES) == pytest.approx((0, 42 * 50 / 1280))


# ------------------------------------------------------------------------------------------------ moving targets


def test_a_target_rests_before_its_first_key_and_after_its_last() -> None:
    visitor = TARGETS[2]
    assert isinstance(visitor, MovingTarget)
    ends = [Path(visitor.times, visitor.places).at(time) for time in (-1, 0, 2, 4, 9)]
    assert [round(place.x, 6) for place in ends] == [-80, -80, 0, 80, 80]


keys = st.lists(st.tuples(st.floats(0.01, 3), st.floats(-100, 100)), min_size=1, max_size=8)


@given(keys, st.floats(0, 1))
def test_a_target_goes_through_its_keys_without_overshoot(drawn: list[tuple[float, float]], part: float) -> None:
    times, total = [], 0.0
    for wait, _ in drawn:
        total += wait
        times.append(total)
    places = [Point(x, -x, 100) for _, x in drawn]
    for index, time in enumerate(times):
        assert Path(times, places).at(time).x == pytest.approx(places[index].x, abs=1e-6)
    for (t0, one), (t1, other) in pairwise(zip(times, places, strict=True)):
        x = Path(times, places).at(t0 + part * (t1 - t0)).x
        assert min(one.x, other.x) - 1e-9 <= x <= max(one.x, other.x) + 1e-9


@given(keys)
def test_the_speed_of_a_target_has_no_jumps(drawn: list[tuple[float, float]]) -> None:
    times = [sum(wait for wait, _ in drawn[: index + 1]) for index in range(len(drawn))]
    places = [Point(x, 0, 100) for _, x in drawn]
    h = 1e-5
    for time in times:
        before, at, after = (Path(times, places).at(time + step).x for step in (-h, 0.0, h))
        assert (after - at) / h == pytest.approx((at - before) / h, abs=0.02 * 200 / 0.01)


# ------------------------------------------------------------------------------------------------ directions


def test_the_camera_is_straight_ahead_60_cm_away() -> None:
    for name in ("ada", "bruno"):
        sight = room(1, ADA, BRUNO).sight(name, AtCamera(), 0)
        assert (sight.yaw, sight.pitch, sight.distance) == (0, 0, 60)


@pytest.mark.parametrize(("screen", "part"), [(1 / 3, 1 / 3), (0.6, 0.6), (1.0, 1.0)])
def test_the_screen_scales_direction_and_not_vergence(screen: float, part: float) -> None:
    sight = room(screen).sight("ada", AtTarget("lamp"), 0)
    up = 50 - 42 * 50 / 1280
    assert sight.yaw == pytest.approx(part * degrees(atan2(100, 200)))
    assert sight.pitch == pytest.approx(part * degrees(atan2(up, hypot(100, 200))))
    assert sight.distance == pytest.approx(hypot(100, up, 200))


def test_the_patents_example_thirty_degrees_are_ten() -> None:
    target = FixedTarget("person", Point(100, 42 * 50 / 1280, 100 * 3**0.5), HERE)
    sight = Room(FILM, (ADA,), (target,)).sight("ada", AtTarget("person"), 0)
    assert (sight.yaw, sight.pitch) == pytest.approx((10, 0))


def test_the_fraction_passes_smoothly_to_the_true_angle_at_the_screen() -> None:
    parts = [round(screen_fraction(1 / 3, z), 4) for z in (-50, 0, 10, 20, 30, 40, 500)]
    assert parts == [1, 1, 0.8958, 0.6667, 0.4375, 0.3333, 0.3333]


def test_faces_and_places_in_the_picture_are_seen_by_the_true_angle_40_cm_out() -> None:
    both = room(1 / 3, ADA, BRUNO)
    across = both.sight("ada", AtFace("bruno"), 0)
    assert (across.yaw, across.pitch) == pytest.approx((degrees(atan(25 / 40)), 0))
    assert across.distance == pytest.approx(hypot(25, 40))
    assert both.sight("bruno", AtFace("ada"), 0).yaw == pytest.approx(-across.yaw)
    assert both.sight("ada", AtFace("bruno", "mouth"), 0).pitch == pytest.approx(-4.7, abs=0.1)
    chart = room().sight("ada", AtTarget("chart"), 0)
    assert chart.yaw == pytest.approx(degrees(atan(-12.5 / 40)))


def test_a_written_direction_is_drawn_as_it_is() -> None:
    sight = room(1 / 3).sight("ada", Towards(20, -5), 0)
    assert (sight.yaw, sight.pitch) == (20, -5)


def test_what_is_behind_has_a_direction_too() -> None:
    target = FixedTarget("door", Point(100, 42 * 50 / 1280, -100), HERE)
    assert Room(FILM, (ADA,), (target,)).sight("ada", AtTarget("door"), 0).yaw == pytest.approx(135)


@pytest.mark.parametrize(
    ("aim", "definite"),
    [
        (AtTarget("lamp"), AtTarget("lamp")),
        (AtTarget("crowd", 1), AtTarget("crowd", 1)),
        (AtTarget("crowd", 2), AtTarget("lamp")),
        (AtTarget("crowd", 5), AtFace("bruno")),
        (AtTarget("crowd", "nearest"), AtTarget("crowd", 3)),
        (AtTarget("people", "nearest"), AtTarget("visitor")),
        (AtTarget("people", 2), AtTarget("visitor")),
        (AtPerson("guest"), AtTarget("lamp")),
        (AtPerson("stranger"), AtCamera()),
    ],
)
def test_aims_are_made_definite(aim: Aim, definite: Aim) -> None:
    both = room(1 / 3, ADA, BRUNO)
    assert both.bind("ada", aim, 2.0, (("guest", "lamp"),), ("lamp", "visitor")) == definite


def test_nobody_there_is_the_camera() -> None:
    assert room().bind("ada", AtTarget("people", "nearest"), 0.0) == AtCamera()
