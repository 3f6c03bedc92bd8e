"""What an animal's face has of its own: the muzzle whose edge the lips are, teeth on the skull, rims, ears, fur."""

from __future__ import annotations

import numpy as np
import pytest

from facescript.performance.performance import REST
from facescript.resolve.kinds.library import library_kind
from facescript.rig.rigs import rig
from rig.outline import anchors, inside, polygon
from rig.poses import plain, pose, some

ANIMALS = ("dog", "gorilla", "rodent")
RIGS = {name: rig(plain(name)) for name in ANIMALS}
KINDS = pytest.mark.parametrize("kind", ANIMALS)


@KINDS
def test_the_lips_line_hangs_lower_beside_the_middle(kind: str) -> None:
    """A muzzle's mouth is a W, shut and open: the lobes hang lower than the middle."""
    rig = RIGS[kind]
    frames = np.stack([REST, pose(mouth_open=0.3), pose(mouth_open=1, mouth_jaw=0.8)])
    edge = anchors(rig, rig.draw(frames), "mouth-cavity")[:, 1:4, 1]
    assert (edge[:, [0, 2]] > edge[:, [1]] + 2).all()


@KINDS
def test_the_muzzle_ends_where_the_mouth_opens(kind: str) -> None:
    """In every pose the muzzle covers the lips' upper edge, by the same hair: no skin shows between."""
    rig = RIGS[kind]
    frames = some(40, seed=8)
    frames[:, :6] = REST[:6]
    picture = rig.draw(frames)
    edge = anchors(rig, picture, "mouth-cavity")[:, 1:4]
    muzzle = anchors(rig, picture, "mouth-muzzle")
    gaps = [np.abs(muzzle - edge[:, [k]]).sum(axis=2).min(axis=1) for k in range(3)]
    assert np.max(gaps) < 3.0


@pytest.mark.parametrize("kind", ["dog", "gorilla"])
def test_a_lip_that_rises_bares_the_teeth(kind: str) -> None:
    """Teeth stand on the skull: the lip goes up and they do not."""
    rig = RIGS[kind]
    said = {"mouth_open": 0.4, "mouth_teeth": 0.7}
    picture = rig.draw(np.stack([pose(**said), pose(lip_upper=1, **said)]))
    teeth = anchors(rig, picture, "mouth-teeth-upper")
    lip = anchors(rig, picture, "mouth-cavity")[:, 2, 1]
    assert np.abs(teeth[1] - teeth[0]).max() < 0.1 and lip[0] - lip[1] > 5


@KINDS
def test_a_rim_rings_the_eye(kind: str) -> None:
    """The dark ring lies outside the lids' opening, open and narrowed."""
    rig = RIGS[kind]
    for lid in (-0.3, 0, 0.5):
        picture = rig.draw(pose(lid=lid, cheek_upper=0.5)[None])
        ring = polygon(rig, picture, "eye-rim-left")[0]
        assert all(inside(spot, ring) for spot in anchors(rig, picture, "eye-white-left")[0]), lid


@KINDS
def test_far_features_stay_on_the_head(kind: str) -> None:
    """Turned to 45 degrees, the far eye and the mouth's far corner lie within the head's outline."""
    rig = RIGS[kind]
    for pitch in (-15, 0, 15):
        picture = rig.draw(pose(head_yaw=45, head_pitch=pitch)[None])
        head = polygon(rig, picture, "head")[0]
        for spot in (anchors(rig, picture, "eye-white-left")[0, 4], anchors(rig, picture, "mouth-cavity")[0, 4]):
            assert inside(spot, head), pitch


def test_the_far_ear_leaves_the_brow_free() -> None:
    """A dog's hanging ear lies along the side of its head: turned away it does not cover the brow."""
    rig = RIGS["dog"]
    for yaw in (20, 35, 45):
        picture = rig.draw(pose(head_yaw=yaw)[None])
        ear, brow = polygon(rig, picture, "ear-left")[0], anchors(rig, picture, "brow-body-left")[0]
        assert not any(inside(spot, ear) for spot in brow), yaw


@KINDS
def test_fur_takes_a_colour_of_the_kinds_own(kind: str) -> None:
    """Each kind names colours for what it has, and shapes of that family take them."""
    tints = dict(library_kind(kind).head.tints)
    assert {"hair", "eyes", "clothes"} <= set(tints)
    black = next(tint.colour for tint in tints["hair"] if tint.name == "black")
    usual, dyed = rig(plain(kind)), rig(plain(kind, fur=black))
    changed = {a.id for a, b in zip(usual.shapes, dyed.shapes, strict=True) if a.fill != b.fill}
    assert {"head", "body-fur", "tuft", "brow-body-left"} <= changed
    assert not changed & {"nose", "mouth-tongue", "eye-iris-left"}
