"""The stage: where faces stand, who is in a scene, the camera, and the ground behind."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from players import WALL, BlockRig, background, face, gradient, performance_of, scenery, score_of, view

from facescript.ir.play import Film
from facescript.ir.values import PicturePlace
from facescript.schedule.score import Score, TimedScene
from facescript.stage import actor
from facescript.stage.backcloth import Backcloth
from facescript.stage.ground import Backdrop, Clear, own_share
from facescript.stage.stage import Stage


@pytest.fixture(autouse=True)
def blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(actor, "rig", lambda face: BlockRig())
    monkeypatch.setattr(actor, "scenery", scenery)


def staged(score: Score) -> Stage:
    return Stage(score, performance_of(score), lambda path: b"")


def box(stage: Stage, time: float, name: str) -> list[float]:
    """Left, top, right and bottom of a shape, in film px."""
    (shape,) = (each for each in stage.shapes if each.id == name)
    (contour,) = shape.contours
    points = stage.frames(np.array([time])).points[0][contour.first : contour.first + contour.count]
    return [*points.min(axis=0), *points.max(axis=0)]


def shown(stage: Stage, time: float) -> dict[str, float]:
    """The opacity of every shape."""
    opacity = stage.frames(np.array([time])).opacity[0]
    return {shape.id: float(value) for shape, value in zip(stage.shapes, opacity, strict=True)}


def test_one_face_fills_the_film_and_its_wall_is_the_ground() -> None:
    stage = staged(score_of([face("ada")]))
    assert [shape.id for shape in stage.shapes] == ["disc", "body", "head", "mouth"]
    assert box(stage, 0.0, "head") == pytest.approx([280 + 200, 120, 280 + 520, 520])
    assert stage.frames(np.zeros(1)).grounds == (((Backdrop(WALL), 1.0),),)


def test_several_faces_stand_side_by_side_under_their_names() -> None:
    stage = staged(score_of([face("ada"), face("bruno")]))
    ids = [shape.id for shape in stage.shapes]
    assert ids[:2] == ["ada-disc", "bruno-disc"]
    assert ids[2:] == ["ada-body", "ada-head", "ada-mouth", "bruno-body", "bruno-head", "bruno-mouth"]
    assert stage.shapes[-1].clip == ("bruno-head",)
    left, _, right, _ = box(stage, 0.0, "bruno-head")
    assert (left + right) / 2 == pytest.approx(960)


def test_a_body_cut_off_by_its_box_reaches_the_films_edge() -> None:
    stage = staged(score_of([face("ada"), face("bruno")]))
    assert box(stage, 0.0, "ada-body")[3] == pytest.approx(720)
    assert box(stage, 0.0, "ada-head")[3] == pytest.approx(40 + 520 * 640 / 720)
    small = staged(score_of([face("ada", PicturePlace(0.25, 0.1), 0.5)]))
    assert box(small, 0.0, "body")[3] == pytest.approx(720)


def test_an_unseen_face_is_not_there() -> None:
    stage = staged(score_of([face("ada"), face("narrator", kind="unseen")]))
    assert {shape.id for shape in stage.shapes} == {"disc", "body", "head", "mouth"}


def test_only_the_faces_of_a_scene_show() -> None:
    scenes = [TimedScene("day", ("ada",), 0.0, 4.0), TimedScene("night", ("bruno",), 4.0, 10.0)]
    stage = staged(score_of([face("ada"), face("bruno")], scenes=scenes))
    assert shown(stage, 3.99) == {id: float(id.startswith("ada")) for id in shown(stage, 0)}
    assert shown(stage, 4.0) == {id: float(id.startswith("bruno")) for id in shown(stage, 0)}
    assert shown(stage, 10.0) == shown(stage, 4.0)


def test_a_view_centres_a_face_and_all_gives_the_picture_back() -> None:
    acts = [view("bruno", 2.0, 1.0, over=2.0), view(None, 1.0, 5.0)]
    stage = staged(score_of([face("ada"), face("bruno")], acts))
    rest = box(stage, 0.0, "bruno-body")
    left, _, right, _ = box(stage, 4.0, "bruno-body")
    assert (left + right) / 2 == pytest.approx(640)
    assert right - left == pytest.approx(2 * (rest[2] - rest[0]))
    assert box(stage, 5.0, "bruno-body") == pytest.approx(rest)
    middle = box(stage, 2.0, "bruno-body")
    assert rest[2] - rest[0] < middle[2] - middle[0] < right - left


def test_a_view_of_the_only_face_at_full_size_changes_nothing() -> None:
    stage = staged(score_of([face("ada")], [view("ada", 1.0, 1.0)]))
    assert box(stage, 2.0, "body") == pytest.approx(box(stage, 0.0, "body"))


@settings(max_examples=40, deadline=None)
@given(st.floats(1.0, 1.5), st.floats(1.5, 4.0), st.sampled_from(["ada", "bruno", None]))
def test_a_view_never_jumps_though_another_interrupts_it(start: float, zoom: float, of: str | None) -> None:
    stage = staged(score_of([face("ada"), face("bruno")], [view("ada", 3.0, 0.5, 1.0), view(of, zoom, start, 1.0)]))
    points = stage.frames(np.arange(0.0, 3.0, 0.001)).points[:, 0]
    assert np.abs(np.diff(points, axis=0)).max() < 12.0


def test_a_background_changes_over_time_and_is_afresh_in_the_next_scene() -> None:
    scenes = [TimedScene("one", ("ada",), 0.0, 5.0), TimedScene("two", ("ada",), 5.0, 10.0)]
    acts = [background("#ff0000", 1.0), background("#0000ff", 2.0, over=2.0)]
    stage = staged(score_of([face("ada")], acts, scenes))
    art, red, mixed, blue, again = stage.frames(np.array([0.5, 1.0, 3.0, 4.0, 5.0])).grounds
    assert art == again == ((Backdrop(WALL), 1.0),)
    assert red == (("#ff0000", 1.0),)
    assert mixed == (("#ff0000", 1.0), ("#0000ff", pytest.approx(0.5)))
    assert blue == (("#0000ff", 1.0),)


def test_the_arts_backdrop_goes_with_the_ground_it_belongs_to() -> None:
    stage = staged(score_of([face("ada")], [background("#ffffff", 1.0, over=1.0)]))
    assert shown(stage, 1.0)["disc"] == 1.0
    assert shown(stage, 1.5)["disc"] == pytest.approx(0.5)
    assert shown(stage, 2.0)["disc"] == 0.0
    assert shown(stage, 2.0)["head"] == 1.0


def test_a_translucent_colour_lies_on_white() -> None:
    stage = staged(score_of([face("ada")], [background("#00000080", 0.0)]))
    assert stage.frames(np.zeros(1)).grounds == ((("#7f7f7f", 1.0),),)


def test_a_background_of_nothing_is_clear_and_told() -> None:
    stage = staged(score_of([face("ada")], [background("#ff0000", 0.0), background(None, 1.0, over=2.0)]))
    half, clear = stage.frames(np.array([2.0, 3.0])).grounds
    assert half == (("#ff0000", 1.0), (Clear(), pytest.approx(0.5)))
    assert clear == ((Clear(), 1.0),)
    assert stage.clear is not None
    assert stage.clear.start == 1.0
    assert staged(score_of([face("ada")], [background("#ff0000", 0.0)])).clear is None


def lightness(towards: float | None, *colours: str) -> np.ndarray:
    """array[y, x]: the blue of a gradient that fills a film of 160 x 90."""
    film = Film(160, 90)
    stage = staged(score_of([face("ada")], [gradient(*colours, towards=towards)], film=film))
    cloth = Backcloth(film.width, film.height, lambda path: b"")
    return (cloth.paint(stage.frames(np.zeros(1)).grounds[0]) & 0xFF).astype(float)


@pytest.mark.parametrize("towards", [-90.0, 0.0, 45.0, 90.0, 150.0, 765.0])
def test_a_gradient_goes_towards_its_angle_in_pixels(towards: float) -> None:
    seen = lightness(towards, "#000000", "#ffffff")
    slope = np.array([np.gradient(seen[:, 20:-20], axis=1).mean(), -np.gradient(seen[20:-20], axis=0).mean()])
    angle = np.radians(towards)
    assert slope / np.linalg.norm(slope) == pytest.approx([np.cos(angle), np.sin(angle)], abs=0.05)
    assert seen.min() < 6
    assert seen.max() > 249


def test_a_round_gradient_goes_from_the_middle_to_the_corners() -> None:
    seen = lightness(None, "#ffffff", "#000000")
    assert seen[45, 80] > 249
    assert max(seen[0, 0], seen[0, -1], seen[-1, 0], seen[-1, -1]) < 6
    assert seen[45, 0] == pytest.approx(seen[0, 80], abs=6)


def test_the_colours_of_a_gradient_stand_at_even_steps_and_on_white() -> None:
    seen = lightness(0.0, "#000000", "#0000ff00", "#000000")
    assert [seen[45, x] for x in (0, 40, 80, 120, 159)] == pytest.approx([2, 128, 255, 128, 2], abs=4)


def test_own_share_counts_what_covers_it() -> None:
    assert own_share(((Backdrop(WALL), 1.0), (Clear(), 0.25))) == 0.75
    assert own_share(((Backdrop(WALL), 1.0), ("#000000", 0.25))) == 0.75
    assert own_share((("#000000", 1.0), (Backdrop(WALL), 0.25))) == 0.25


@settings(max_examples=20, deadline=None)
@given(st.lists(st.floats(0.0, 10.0), min_size=1, max_size=8))
def test_frames_do_not_depend_on_those_asked_for_with_them(times: list[float]) -> None:
    acts = [view("ada", 2.0, 1.0, over=5.0), background("#ffffff", 2.0, over=3.0)]
    stage = staged(score_of([face("ada"), face("bruno")], acts))
    together = stage.frames(np.array(times))
    for number, time in enumerate(times):
        alone = stage.frames(np.array([time]))
        assert (together.points[number] == alone.points[0]).all()
        assert (together.opacity[number] == alone.opacity[0]).all()
        assert together.grounds[number] == alone.grounds[0]


def test_a_film_of_no_seen_face_is_its_ground() -> None:
    stage = staged(score_of([face("narrator", kind="unseen")], film=Film(64, 36)))
    frames = stage.frames(np.array([0.0, 1.0]))
    assert stage.shapes == ()
    assert frames.points.shape == (2, 0, 2)
    assert len(frames.grounds) == 2
