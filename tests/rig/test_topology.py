"""No outline folds and nothing leaps, through the whole range of every channel and from any pose to any other."""

from __future__ import annotations

import numpy as np
import pytest

from facescript.performance.channels import INDEX, NAMES
from facescript.resolve.kinds.library import PEOPLE
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.rigs import rig as rig_of
from rig.outline import folded, polygon
from rig.poses import plain, pose, some, sweep

RIGS = {name: rig_of(plain(name)) for name in PEOPLE}
KINDS = pytest.mark.parametrize("kind", sorted(RIGS))
MOVING = [name for name in NAMES if not name.startswith("gaze.")]
SECOND = 60
"""Frames of a second at 60 fps, in which a channel goes through its whole range: faster than any muscle."""

SOFT = ("eye-white-", "eye-lid-", "eye-line-", "eye-crease-", "mouth-lip-", "mouth-teeth-upper")
FIRM = ("face-skin", "brow-body-", "neck-skin", "clothes-top", "clothes-jacket-", "hair-back-mass", "hair-top")
SPECK = 9.0
"""Lids and lips may cross themselves by this area (px^2 of 720 x 720): where they meet at a corner or shut on one
another a crossing of three px by three is of their own colour and cannot be seen."""

SLIT = 20.0
"""Closed, the mouth's cavity is a slit of a fifth of a px, which the lips cover: there its edges may cross."""

JERK = 2.0
"""A point's way from frame to frame changes by at most this (px of 720): straight paths through all channels at once
measure 1.3, from the curvature of the poses themselves; a jump of 2 px in a frame is where one begins to see it."""


@KINDS
def test_no_point_leaps_from_frame_to_frame(kind: str) -> None:
    """At 60 fps each point goes on as it went: through every channel, and from one random pose to another."""
    rig = RIGS[kind]
    paths = [sweep(name, SECOND) for name in MOVING]
    paths += [_between(*some(2, seed=seed)) for seed in range(20)]
    for name, frames in zip([*MOVING, *range(20)], paths, strict=True):
        picture = rig.draw(frames)
        jerk = np.linalg.norm(np.diff(picture.points, n=2, axis=0), axis=2)
        assert jerk.max() <= JERK, (name, jerk.max())
        assert np.abs(np.diff(picture.opacity, axis=0)).max() <= 0.15, name


@KINDS
def test_outlines_do_not_fold_through_any_channel(kind: str) -> None:
    """Three stations of each channel, at rest and on a turned head."""
    turned = pose(head_yaw=30, head_pitch=15)
    frames = np.concatenate([sweep(name, 3, base) for name in MOVING for base in (pose(), turned)])
    _check(RIGS[kind], frames, SOFT + FIRM, SPECK)
    _check(RIGS[kind], frames, ("mouth-cavity",), SLIT)


@KINDS
def test_outlines_do_not_fold_in_any_pose(kind: str) -> None:
    frames = some(60, seed=21)
    frames[:, INDEX["head.scale"]] = 1
    _check(RIGS[kind], frames, SOFT + FIRM, SPECK)
    _check(RIGS[kind], frames, ("mouth-cavity",), SLIT)


@KINDS
def test_the_near_ear_and_the_locks_do_not_fold(kind: str) -> None:
    """The ear while it shows; locks by no more than their tip, which is of one colour."""
    rig = RIGS[kind]
    for side, sign in (("left", -1), ("right", 1)):
        frames = np.stack([pose(head_yaw=sign * yaw, head_pitch=p) for yaw in (0, 20, 45) for p in (-30, 0, 30)])
        _check(rig, frames, (f"ear-near-{side}",), SPECK)
    frames = np.stack([pose(head_yaw=yaw, head_pitch=p) for yaw in (-45, -20, 0, 20, 45) for p in (-30, 0, 30)])
    _check(rig, frames, ("hair-front-right", "hair-front-left"), 250.0)


def _between(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """A second's straight way from pose to pose."""
    way: np.ndarray = start + (end - start) * np.linspace(0, 1, SECOND)[:, None]
    return way


def _check(rig: CartoonRig, frames: np.ndarray, starts: tuple[str, ...], allowed: float) -> None:
    picture = rig.draw(frames)
    for name in (shape.id for shape in rig.shapes if shape.id.startswith(starts)):
        for k, outline in enumerate(polygon(rig, picture, name, steps=5)):
            assert folded(outline) <= allowed, (name, k)
