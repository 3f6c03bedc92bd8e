"""A turned head is a head: features on the face, hair beside it, far parts hidden, eyes that look where told."""

from __future__ import annotations

import math

import numpy as np
import pytest

from facescript.performance.channels import INDEX, SIDES
from facescript.resolve.kinds.library import PEOPLE
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.picture import Picture
from facescript.rig.rigs import rig as rig_of
from rig.outline import anchors, inside, outside, polygon
from rig.poses import plain, pose, some

RIGS = {name: rig_of(plain(name)) for name in PEOPLE}
KINDS = pytest.mark.parametrize("kind", sorted(RIGS))
TURNS = [(yaw, pitch) for yaw in (-45, -25, 0, 25, 45) for pitch in (-30, -15, 0, 15, 30)]
HEADS = np.stack([pose(head_yaw=yaw, head_pitch=pitch) for yaw, pitch in TURNS])
FEATURES = ("eye-white-", "eye-line-", "brow-body-", "mouth-lip-", "nose-under", "nose-nostrils")
MASSES = ("hair-front-right", "hair-front-left", "hair-top", "hair-side-right", "hair-side-left")


def named(rig: CartoonRig, *starts: str) -> list[str]:
    """Ids of the shapes whose names begin so."""
    return [shape.id for shape in rig.shapes if shape.id.startswith(starts)]


def opacity(rig: CartoonRig, picture: Picture, shape: str) -> np.ndarray:
    return picture.opacity[:, [one.id for one in rig.shapes].index(shape)]


@KINDS
def test_features_lie_on_the_face(kind: str) -> None:
    """To 45 degrees aside and 30 up and down nothing of eyes, nose and mouth stands out beyond the face's outline; a
    brow's tail and a lid's line may, by as much as they are thick."""
    rig = RIGS[kind]
    picture = rig.draw(HEADS)
    face = polygon(rig, picture, "face-skin")
    for name in named(rig, *FEATURES):
        allowed = 4.0 if name.startswith(("brow-", "eye-line-")) else 0.5
        for turn, drawn, outline in zip(TURNS, polygon(rig, picture, name, steps=3), face, strict=True):
            assert outside(drawn, outline) <= allowed, (name, turn)


@KINDS
def test_hair_covers_neither_eyes_nor_mouth(kind: str) -> None:
    """Locks beside the face stay behind the far cheek."""
    rig = RIGS[kind]
    picture = rig.draw(HEADS)
    for hair in (name for name in MASSES if name in named(rig, *MASSES)):
        mass = polygon(rig, picture, hair)
        for name in named(rig, "eye-white-", "mouth-lip-"):
            for turn, drawn, outline in zip(TURNS, polygon(rig, picture, name, steps=3), mass, strict=True):
                assert not any(inside(point, outline) for point in drawn), (hair, name, turn)


@KINDS
def test_the_far_ear_hides_and_the_near_one_shows(kind: str) -> None:
    """From 15 degrees on the far ear's middle lies behind face or hair; the near one is drawn before the cheek."""
    rig = RIGS[kind]
    yaws = (15, 30, 45)
    picture = rig.draw(np.stack([pose(head_yaw=yaw) for yaw in yaws]))
    covers = [polygon(rig, picture, name) for name in named(rig, "face-skin", *MASSES)]
    middle = anchors(rig, picture, "ear-left").mean(axis=1)
    for frame in range(len(yaws)):
        assert any(inside(middle[frame], cover[frame]) for cover in covers)
    for part in ("ear-near", "ear-near-inner"):
        assert (opacity(rig, picture, f"{part}-left") == 0).all()
        assert opacity(rig, picture, f"{part}-right")[-1] > 0.5
    ids = [shape.id for shape in rig.shapes]
    assert ids.index("ear-left") < ids.index("face-skin") < ids.index("ear-near-left")


@KINDS
def test_near_and_far_differ(kind: str) -> None:
    """At 45 degrees the far eye is narrower than the near one, and the nose's edge shows against the far cheek only."""
    rig = RIGS[kind]
    picture = rig.draw(np.stack([pose(), pose(head_yaw=45)]))
    near, far = (np.ptp(anchors(rig, picture, f"eye-white-{side}")[:, :, 0], axis=1) for side in ("right", "left"))
    assert near[0] == pytest.approx(far[0], abs=0.1)
    assert far[1] < 0.7 * near[1]
    assert opacity(rig, picture, "nose-edge-left")[1] > 0.4 and opacity(rig, picture, "nose-edge-right")[1] == 0
    assert opacity(rig, picture, "nose-edge-left")[0] == 0


@KINDS
def test_the_skull_does_not_narrow_like_a_card(kind: str) -> None:
    """Turned by 45 degrees, the back of the head is at least as wide as from the front."""
    rig = RIGS[kind]
    picture = rig.draw(np.stack([pose(), pose(head_yaw=45)]))
    front, turned = np.ptp(polygon(rig, picture, "hair-back-mass")[:, :, 0], axis=1)
    assert front <= turned <= 1.2 * front


@KINDS
def test_a_chin_seen_from_below_is_a_bow(kind: str) -> None:
    """With the head tipped back by 30 degrees the jaw's line still falls from its corners towards the chin."""
    rig = RIGS[kind]
    jaw = anchors(rig, rig.draw(pose(head_pitch=30)[None]), "face-skin")[0]
    for corner, half_way in ((7, 8), (13, 12)):
        assert jaw[half_way, 1] - jaw[corner, 1] > 0.07 * rig.eye_distance


@KINDS
def test_gaze_is_true_in_any_pose(kind: str) -> None:
    """The iris stands 0.3 d before the middle of the ball where eye and head, one after the other, turn it."""
    rig = RIGS[kind]
    frames = some(30, seed=8)
    frames[:, [INDEX["head.x"], INDEX["head.y"]]] = 0
    straight = frames.copy()
    straight[:, [INDEX[f"eye.{side}.{axis}"] for side in SIDES for axis in ("yaw", "pitch")]] = 0
    there, ahead = (rig.draw(each) for each in (frames, straight))
    turn = _heads(frames)
    for side in SIDES:
        iris, middle = (anchors(rig, each, f"eye-iris-{side}").mean(axis=1) for each in (there, ahead))
        yaw, pitch = (np.radians(frames[:, INDEX[f"eye.{side}.{axis}"]]) for axis in ("yaw", "pitch"))
        looks = np.stack([np.sin(yaw) * np.cos(pitch), -np.sin(pitch), np.cos(yaw) * np.cos(pitch)], axis=-1)
        size = frames[:, INDEX[f"eye.{side}.scale"]]
        moved = size[:, None] * (looks - [0, 0, 1])
        expected = np.einsum("fij,fj->fi", turn, moved) * (0.3 * rig.eye_distance)
        expected = expected[:, :2] * frames[:, [INDEX["head.scale"]]]
        assert iris - middle == pytest.approx(expected, abs=0.05)


def _heads(frames: np.ndarray) -> np.ndarray:
    """Pitch, then yaw, then roll, as matrices on x right, y down, z towards the viewer."""
    out = []
    for yaw, pitch, roll in np.radians(frames[:, [INDEX[f"head.{axis}"] for axis in ("yaw", "pitch", "roll")]]):
        (sy, cy), (sp, cp), (sr, cr) = ((math.sin(a), math.cos(a)) for a in (yaw, pitch, roll))
        tip = np.array([[1, 0, 0], [0, cp, -sp], [0, sp, cp]])
        turn = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
        tilt = np.array([[cr, -sr, 0], [sr, cr, 0], [0, 0, 1]])
        out.append(tilt @ turn @ tip)
    return np.array(out)


@KINDS
def test_shoulders_follow_a_little(kind: str) -> None:
    """The chest turns along, by less than a quarter of what the chin does, and the bust's lower edge stays."""
    rig = RIGS[kind]
    picture = rig.draw(np.stack([pose(), pose(head_yaw=40)]))
    clothes = named(rig, "clothes-")
    way = max(np.abs(np.diff(anchors(rig, picture, name), axis=0))[..., 0].max() for name in clothes)
    chin = anchors(rig, picture, "face-skin")[:, 10]
    assert 5 < way < 0.25 * abs(chin[1, 0] - chin[0, 0])


@KINDS
def test_layers_lie_in_order(kind: str) -> None:
    """Back to front; all of the eye's ball is bound by the white, and the lid's line lies over it."""
    rig = RIGS[kind]
    order = [shape.id for shape in rig.shapes]
    groups = list(dict.fromkeys(shape.group for shape in rig.shapes))
    assert groups == GROUPS
    for side in SIDES:
        ball = [f"eye-{part}-{side}" for part in ("iris", "rays", "pupil", "shade", "light")]
        assert all(shape.clip == (f"eye-white-{side}",) for shape in rig.shapes if shape.id in ball)
        places = [order.index(name) for name in (f"eye-lid-{side}", f"eye-white-{side}", *ball, f"eye-line-{side}")]
        assert places == sorted(places)


GROUPS = [
    "hair-back", "neck", "clothes", "ears", "face", "cheeks", "nose", "mouth", "eye-right", "eye-left", "brow-right",
    "brow-left", "hair-front",
]  # fmt: skip
