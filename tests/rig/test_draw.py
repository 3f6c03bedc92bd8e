"""What people rely on in a drawn face: constant topology, motion without a jump, one answer whatever the chunks."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.performance.channels import INDEX, NAMES
from facescript.performance.performance import REST
from facescript.resolve.kinds.library import kind_names
from facescript.rig.rigs import rig
from rig.outline import anchors
from rig.poses import mirrored, plain, pose, some, span, sweep

RIGS = {name: rig(plain(name)) for name in kind_names()}
KINDS = pytest.mark.parametrize("kind", sorted(RIGS))
HUMANS = pytest.mark.parametrize("kind", sorted(kind for kind, rig in RIGS.items() if rig.feature_names))
"""Kinds with feature points."""
MOVING = [name for name in NAMES if not name.startswith("gaze.")]


@KINDS
def test_points_are_those_of_the_shapes(kind: str) -> None:
    """Every point belongs to exactly one contour, in the order of the shapes."""
    rig = RIGS[kind]
    picture = rig.draw(some(3))
    contours = [contour for shape in rig.shapes for contour in shape.contours]
    assert [contour.first for contour in contours] == np.cumsum([0] + [c.count for c in contours])[:-1].tolist()
    assert all(contour.count % 3 == 1 for contour in contours)
    assert picture.points.shape == (3, sum(contour.count for contour in contours), 2)
    assert picture.opacity.shape == (3, len(rig.shapes))
    assert np.isfinite(picture.points).all()
    assert (picture.opacity >= 0).all() and (picture.opacity <= 1).all()


@KINDS
def test_contours_are_closed(kind: str) -> None:
    """Each outline ends where it began, in every pose."""
    rig = RIGS[kind]
    points = rig.draw(some(4)).points
    for shape in rig.shapes:
        for contour in shape.contours:
            first, last = contour.first, contour.first + contour.count - 1
            assert np.array_equal(points[:, first], points[:, last])


@KINDS
def test_clips_name_shapes(kind: str) -> None:
    ids = [shape.id for shape in RIGS[kind].shapes]
    assert len(ids) == len(set(ids))
    assert {clip for shape in RIGS[kind].shapes for clip in shape.clip} <= set(ids)


@KINDS
@pytest.mark.parametrize("name", MOVING)
def test_a_channel_moves_the_face_without_a_jump(kind: str, name: str) -> None:
    """Through its whole range, at rest and in a full pose, no point leaps: halving the step halves the way."""
    rig = RIGS[kind]
    for base in (REST, pose(mouth_open=0.4, head_yaw=12, head_pitch=-8, cheek_lower=0.6, lid=0.3, brow_lower=0.5)):
        picture = rig.draw(sweep(name, 401, base))
        steps = np.abs(np.diff(picture.points, axis=0)).max(axis=(1, 2))
        coarse = np.abs(picture.points[::4][1:] - picture.points[::4][:-1]).max()
        assert steps.max() <= 0.45 * coarse + 1e-9, f"{name} jumps by {steps.max():.2f} px"
        assert np.abs(np.diff(picture.opacity, axis=0)).max() <= 0.02


@KINDS
def test_every_channel_is_drawn(kind: str) -> None:
    """No channel of a pose is ignored; the derived ones are."""
    rig = RIGS[kind]
    base = pose(mouth_open=0.5)
    still = rig.draw(base[None])
    for name in MOVING:
        frames = sweep(name, 2, base)
        drawn = rig.draw(frames)
        moved = max(np.abs(frame - still.points[0]).max() for frame in drawn.points)
        shown = np.abs(drawn.opacity - still.opacity).max()
        assert moved > 0.5 or shown > 0.02, name


@KINDS
@settings(max_examples=12, deadline=None)
@given(cuts=st.sets(st.integers(1, 36), max_size=5))
def test_chunks_do_not_matter(kind: str, cuts: set[int]) -> None:
    """Frames drawn in any chunks are the same to the bit."""
    rig = RIGS[kind]
    frames = some(37, seed=3)
    whole = rig.draw(frames)
    edges = [0, *sorted(cuts), len(frames)]
    parts = [rig.draw(frames[a:b]) for a, b in pairwise(edges)]
    assert np.array_equal(np.concatenate([part.points for part in parts]), whole.points)
    assert np.array_equal(np.concatenate([part.opacity for part in parts]), whole.opacity)


@HUMANS
def test_a_mirrored_pose_is_the_mirrored_picture(kind: str) -> None:
    """Features (not hair, light and clothes, which are not symmetric) change sides with the pose, to a pixel."""
    rig = RIGS[kind]
    frames = some(20, seed=5)
    frames[:, [INDEX[f"head.{axis}"] for axis in ("yaw", "pitch", "roll", "x", "y")]] *= 0.5
    there, back = rig.features(frames), rig.features(mirrored(frames))
    names = rig.feature_names
    partner = {name: name for name in names} | PAIRS | {right: left for left, right in PAIRS.items()}
    rows = [names.index(partner[name]) for name in names if not name.startswith("hair")]
    kept = [k for k, name in enumerate(names) if not name.startswith("hair")]
    flipped = back[:, rows]
    assert np.abs(there[:, kept, 0] + flipped[:, :, 0] - 2 * rig.eyes[0]).max() < 1.0
    assert np.abs(there[:, kept, 1] - flipped[:, :, 1]).max() < 1.0


PAIRS = {
    "3.7": "3.12", "3.1": "3.2", "3.11": "3.8", "3.3": "3.4", "EyeballLeft": "EyeballRight", "4.1": "4.2", "4.3": "4.4",
    "4.3a": "4.4a", "4.5": "4.6", "I": "F", "H": "G", "8.10": "8.9", "8.3": "8.4", "S": "R", "2.13": "2.14", "K": "J",
    "10.9": "10.10", "M": "L", "11.3": "11.2", "11.3a": "11.2a", "Q": "N", "10.1": "10.2", "10.7": "10.8", "B": "A",
    "9.7": "9.6", "9.13": "9.14", "9.1": "9.2", "9.5": "9.4", "E": "D",
}  # fmt: skip


@KINDS
def test_each_side_does_what_the_other_does_in_a_mirror(kind: str) -> None:
    """Eyes, brows, cheeks and ears change places with the pose; lights on the eyes, clothes and hair need not."""
    rig = RIGS[kind]
    frames = some(12, seed=6)
    frames[:, [NAMES.index(f"head.{axis}") for axis in ("yaw", "pitch", "roll", "x", "y")]] *= 0.5
    there, back = rig.draw(frames), rig.draw(mirrored(frames))
    sides = [shape.id.removesuffix("-left") for shape in rig.shapes if shape.id.endswith("-left")]
    for name in sides:
        if name in ("eye-light", "eye-rays") or not name.startswith(("eye", "brow", "cheek", "ear")):
            continue
        left, right = anchors(rig, there, f"{name}-left"), anchors(rig, back, f"{name}-right")
        assert np.abs(left[..., 0].max(1) + right[..., 0].min(1) - 2 * rig.eyes[0]).max() < 1.0, name
        for edge in (np.min, np.max):
            assert np.abs(edge(left[..., 1], axis=1) - edge(right[..., 1], axis=1)).max() < 1.0, name


@KINDS
def test_ranges_are_wide_enough(kind: str) -> None:
    """Beyond its range a muscle does not go on for ever: nothing flies off the art box."""
    rig = RIGS[kind]
    wild = np.array([[span(name)[1] * 3 for name in INDEX]])
    wild[0, INDEX["head.scale"]] = 1.0
    for axis in ("head.x", "head.y", "head.yaw", "head.pitch", "head.roll"):
        wild[0, INDEX[axis]] = 0.0
    points = rig.draw(wild).points[0]
    assert points[:, 0].min() > -300 and points[:, 0].max() < 1020
