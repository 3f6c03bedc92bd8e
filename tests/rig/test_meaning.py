"""What the channels mean in the drawing: lips that close, eyes that stay in their lids, turns the right way."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.performance.channels import INDEX, MUSCLES, SIDES
from facescript.performance.performance import REST
from facescript.resolve.kinds.library import kind_names
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.picture import Picture
from facescript.rig.rigs import rig
from rig.outline import anchors, area, inside, polygon
from rig.poses import plain, pose, some

RIGS = {name: rig(plain(name)) for name in kind_names()}
KINDS = pytest.mark.parametrize("kind", sorted(RIGS))
HUMANS = pytest.mark.parametrize("kind", sorted(kind for kind, rig in RIGS.items() if rig.feature_names))
"""Kinds with the feature points of Table 2.1."""
PAIRS = [f"{muscle}.{side}" for muscle in MUSCLES for side in SIDES]


MARKS = {
    "8.3": ("mouth-cavity", (4,)),
    "8.4": ("mouth-cavity", (0,)),
    "9.15": ("nose", (5,)),
    "2.1": ("mouth-chin", (5,)),
    "4.1": ("brow-body-left", (0,)),
    "4.3": ("brow-body-left", (0, 1, 2)),
    "4.4": ("brow-body-right", (0, 1, 2)),
    "EyeballLeft": ("eye-iris-left", (0, 2)),
    "EyeballRight": ("eye-iris-right", (0, 2)),
}
"""What stands for a feature point in a kind that has none: a shape, and the anchors whose mean it is."""


def feature(rig: CartoonRig, name: str, *poses: np.ndarray) -> np.ndarray:
    if not rig.feature_names:
        shape, which = MARKS[name]
        return np.asarray(anchors(rig, rig.draw(np.stack(poses)), shape)[:, list(which)].mean(axis=1))
    return rig.features(np.stack(poses))[:, rig.feature_names.index(name)]


def inner_edges(rig: CartoonRig, picture: Picture) -> tuple[np.ndarray, np.ndarray]:
    """Three places of the upper lip's inner edge and of the lower's: arrays[frame, place, xy]."""
    if rig.style.mouth.muzzle:
        inner = anchors(rig, picture, "mouth-cavity")
        return inner[:, 1:4], inner[:, [7, 6, 5]]
    return anchors(rig, picture, "mouth-lip-upper")[:, [9, 8, 7]], anchors(rig, picture, "mouth-lip-lower")[
        :, [6, 7, 8]
    ]


@KINDS
@settings(max_examples=40, deadline=None)
@given(muscles=st.lists(st.floats(0, 1), min_size=28, max_size=28), lip=st.floats(-0.3, 0.3), teeth=st.floats(0, 1))
def test_closed_lips_are_closed(kind: str, muscles: list[float], lip: float, teeth: float) -> None:
    """`open` 0 is closed lips whatever the muscles do: the gap is a hair, and the lips or their line lie over it."""
    rig = RIGS[kind]
    shut = pose(mouth_open=0, mouth_upper=lip, mouth_lower=-lip, mouth_teeth=teeth)
    shut[[INDEX[name] for name in PAIRS]] = muscles
    picture = rig.draw(shut[None])
    upper, lower = inner_edges(rig, picture)
    assert np.abs(lower - upper)[0].max() <= 0.35
    over = anchors(rig, picture, "mouth-lip-upper")[0][[9, 8, 7], 1]
    if not rig.style.mouth.muzzle:
        over = anchors(rig, picture, "mouth-line")[0][[6, 5, 4], 1]
    assert (anchors(rig, picture, "mouth-lip-lower")[0][[6, 7, 8], 1] < over).all()


@KINDS
def test_a_lip_that_is_drawn_in_lies_under_the_teeth(kind: str) -> None:
    """Shape f: teeth are seen between the lips, down to the lower one, and nothing dark."""
    rig = RIGS[kind]
    picture = rig.draw(np.stack([REST, pose(mouth_lower=-0.2, mouth_teeth=0.6)]))
    upper, lower = inner_edges(rig, picture)
    seen = lower[:, 1, 1] - upper[:, 1, 1]
    assert seen[0] < 0.4 and 2.0 < seen[1] < 12.0
    if kind != "rodent":  # whose incisors lie over both lips
        assert anchors(rig, picture, "mouth-teeth-upper")[1, :, 1].max() >= lower[1, 1, 1] - 0.4


@HUMANS
def test_the_tongue_rises_to_the_teeth_and_comes_out_below_them(kind: str) -> None:
    rig = RIGS[kind]
    said = {"mouth_open": 0.5, "mouth_upper": 0.2, "mouth_lower": 0.3, "mouth_teeth": 0.5}
    picture = rig.draw(np.stack([pose(mouth_tongue=up, **said) for up in (0.0, 0.8, 1.0)]))
    tongue = anchors(rig, picture, "mouth-tongue")
    edge = anchors(rig, picture, "mouth-teeth-upper")[1, :, 1].max()
    top, wide = tongue[..., 1].min(axis=1), np.ptp(tongue[..., 0], axis=1)
    assert top[0] > edge + 3 and abs(top[1] - edge) < 2 and abs(top[2] - edge) < 2
    assert wide[2] > wide[1] > wide[0]


@KINDS
def test_open_is_the_gap_at_the_middle_in_mns0(kind: str) -> None:
    rig = RIGS[kind]
    for gap in (0.25, 0.5, 1.0):
        upper, lower = inner_edges(rig, rig.draw(pose(mouth_open=gap)[None]))
        assert lower[0, 1, 1] - upper[0, 1, 1] == pytest.approx(gap * rig.style.mouth.mns0, abs=0.5)


@KINDS
def test_wide_moves_each_corner_out_in_mw0(kind: str) -> None:
    rig = RIGS[kind]
    rest, wide = feature(rig, "8.3", REST, pose(mouth_wide=1 / 12))
    assert wide[0] - rest[0] == pytest.approx(rig.style.mouth.mw0 / 12, abs=0.1)


@KINDS
def test_an_open_mouth_opens(kind: str) -> None:
    """The cavity grows with the gap, and a smile opens on both sides."""
    rig = RIGS[kind]
    frames = np.stack([pose(mouth_open=gap, cheek_lower=0.8) for gap in np.linspace(0, 1.2, 13)])
    areas = area(polygon(rig, rig.draw(frames), "mouth-cavity"))
    assert (np.diff(areas) > 5).all()


@KINDS
@pytest.mark.parametrize("side", SIDES)
def test_the_eye_stays_in_its_lids(kind: str, side: str) -> None:
    """Iris, pupil and lights are cut by the white; at rest and in ordinary gaze the pupil lies in it."""
    rig = RIGS[kind]
    clipped = {shape.id for shape in rig.shapes if shape.clip == (f"eye-white-{side}",)}
    parts = ("iris", "rays", "glow", "pupil", "shade", "light")
    assert clipped == {f"eye-{part}-{side}" for part in parts} & {shape.id for shape in rig.shapes}
    for yaw in (-25, 0, 25):
        for pitch in (-20, 0, 15):
            looking = pose(**{f"eye_{s}_yaw": yaw for s in SIDES} | {f"eye_{s}_pitch": pitch for s in SIDES})
            picture = rig.draw(looking[None])
            middle = anchors(rig, picture, f"eye-pupil-{side}")[0].mean(axis=0)
            assert inside(middle, polygon(rig, picture, f"eye-white-{side}")[0]), (yaw, pitch)


@KINDS
@pytest.mark.parametrize("side", SIDES)
def test_a_shut_eye_shows_no_white(kind: str, side: str) -> None:
    rig = RIGS[kind]
    open_, shut = area(polygon(rig, rig.draw(np.stack([REST, pose(lid=1)])), f"eye-white-{side}"))
    assert shut < 0.05 * open_


@KINDS
def test_the_iris_is_a_circle_on_a_ball_of_03_d(kind: str) -> None:
    """Thesis 2.4.3.2: turned by an angle it shifts by 0.3 d times the sine, and narrows by the cosine."""
    rig = RIGS[kind]
    for angle in (-40, -15, 20, 45):
        picture = rig.draw(np.stack([REST, pose(eye_left_yaw=angle)]))
        rest, turned = anchors(rig, picture, "eye-iris-left")
        shift = turned.mean(axis=0) - rest.mean(axis=0)
        assert shift[0] == pytest.approx(0.3 * rig.eye_distance * math.sin(math.radians(angle)), abs=0.01)
        assert np.ptp(turned[:, 0]) == pytest.approx(np.ptp(rest[:, 0]) * math.cos(math.radians(angle)), abs=0.01)


@KINDS
def test_signs(kind: str) -> None:
    """Yaw + is the viewer's right, pitch + up, roll + clockwise; x right, y up; left is the face's own."""
    rig = RIGS[kind]

    def moved(name: str, **values: float) -> np.ndarray:
        rest, then = feature(rig, name, REST, pose(**values))
        return np.asarray(then - rest)

    assert moved("9.15", head_yaw=20)[0] > 20
    assert moved("9.15", head_pitch=20)[1] < -20
    assert moved("4.1", head_roll=20)[0] > 20
    assert moved("EyeballLeft", eye_left_yaw=20)[0] > 5 and moved("EyeballRight", eye_left_yaw=20)[0] == 0
    assert moved("EyeballLeft", eye_left_pitch=20)[1] < -5
    assert moved("EyeballLeft", eye_left_x=0.5)[0] == pytest.approx(0.5 * rig.eye_distance / 6.3)
    assert moved("EyeballLeft", head_y=0.5)[1] == pytest.approx(-0.5 * rig.eye_distance / 6.3)
    assert feature(rig, "8.3", REST)[0][0] > rig.eyes[0] > feature(rig, "8.4", REST)[0][0]
    assert moved("8.3", cheek_lower_left=1)[1] < -5 and abs(moved("8.4", cheek_lower_left=1)[1]) < 1
    assert moved("4.3", brow_inner_left=1)[1] < -5 and moved("4.4", brow_inner_left=1)[1] == 0
    assert moved("2.1", mouth_jaw=1)[1] > 15


@HUMANS
def test_the_head_is_pitched_then_turned_then_tilted(kind: str) -> None:
    """A point of the chin's ridge goes where yaw and pitch say, as gaze counts on, 1.3 d below the eyes."""
    rig = RIGS[kind]
    d, pivot = rig.eye_distance, rig.eyes[1] + 1.3 * rig.eye_distance
    x, y = feature(rig, "2.1", REST)[0] - (rig.eyes[0], pivot)
    z = d * (0.2 + 0.84 * (1.30 - 0.2))
    yaw, pitch, roll = 20.0, -15.0, 10.0
    sin, cos = ([f(math.radians(a)) for a in (yaw, pitch, roll)] for f in (math.sin, math.cos))
    y1, z1 = y * cos[1] - z * sin[1], z * cos[1] + y * sin[1]
    x1 = x * cos[0] + z1 * sin[0]
    turned = feature(rig, "2.1", pose(head_yaw=yaw, head_pitch=pitch, head_roll=roll))[0] - (rig.eyes[0], pivot)
    assert turned == pytest.approx([x1 * cos[2] - y1 * sin[2], x1 * sin[2] + y1 * cos[2]], abs=0.02 * d)


@KINDS
def test_expressions_differ(kind: str) -> None:
    """Disgust is not anger, fear not surprise: some feature differs by 5 px or more between any two."""
    rig = RIGS[kind]
    shown = [
        pose(cheek_lower=1, cheek_upper=0.4),
        pose(brow_lower=1, lip_press=0.9),
        pose(nose_upper=1, lip_corner=0.6, lip_lower=0.6, brow_lower=0.3),
        pose(brow_inner=1, brow_outer=1, lid=-0.3, mouth_open=0.6, mouth_jaw=0.6),
        pose(brow_inner=0.9, brow_outer=0.6, brow_lower=0.6, lip_stretch=0.9, lid=-0.3),
        pose(brow_inner=1, brow_lower=0.6, lip_corner=0.9, chin=0.3),
    ]
    at = rig.features(np.stack(shown)) if rig.feature_names else rig.draw(np.stack(shown)).points
    for i in range(len(shown)):
        for j in range(i):
            assert np.abs(at[i] - at[j]).max() > 5, (i, j)


@KINDS
def test_no_outline_of_the_eye_or_mouth_turns_over(kind: str) -> None:
    """In any pose the white's upper edge is above its lower one, and the upper lip above the lower."""
    rig = RIGS[kind]
    frames = some(60, seed=11)
    frames[:, [INDEX[f"head.{axis}"] for axis in ("yaw", "pitch", "roll")]] *= 0.2
    picture = rig.draw(frames)
    for side in SIDES:
        white = anchors(rig, picture, f"eye-white-{side}")
        assert (white[:, [7, 6, 5], 1] - white[:, 1:4, 1] > -2.5).all()
    upper, lower = inner_edges(rig, picture)
    assert (lower[..., 1] - upper[..., 1] > -0.5).all()
