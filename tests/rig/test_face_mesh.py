"""An independent look: MediaPipe's face mesh, trained on photographs, finds the drawn humans and sees what they do."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from facescript.canvas.painter import Painter
from facescript.rig.cartoon.backdrop import backdrop
from facescript.rig.rigs import rig as rig_of
from rig.poses import plain, pose

KINDS = pytest.mark.parametrize("kind", ["man", "woman"])
SIZE = 480
Floats = NDArray[np.float64]

NOSE, LEFT, RIGHT, BROW, CHIN = 1, 454, 234, 10, 152
LIPS = (13, 14)
LIDS = (((159, 145), (33, 133)), ((386, 374), (362, 263)))
"""Numbers of the mesh's points; of each eye the upper and lower lid, and both corners."""


@pytest.fixture(scope="module")
def mesh() -> Iterator[Any]:
    """The mesh for single pictures; the package comes with its weights."""
    mediapipe = pytest.importorskip("mediapipe", reason="the package mediapipe is not installed")
    with mediapipe.solutions.face_mesh.FaceMesh(static_image_mode=True, refine_landmarks=True) as found:
        yield found


@KINDS
def test_it_finds_the_face_frontal_and_turned(mesh: Any, kind: str) -> None:
    """To 30 degrees aside, 20 up and down and 30 of tilt; and the nose goes across the face with the turn."""
    yaws = (-30, -20, -10, 0, 10, 20, 30)
    seen = _look(mesh, kind, [pose(head_yaw=yaw) for yaw in yaws])
    across = (seen[:, NOSE, 0] - seen[:, RIGHT, 0]) / (seen[:, LEFT, 0] - seen[:, RIGHT, 0])
    assert (np.diff(across) > 0).all() and across[0] < 0.3 and across[-1] > 0.7
    seen = _look(mesh, kind, [pose(head_pitch=pitch) for pitch in (-20, -10, 0, 10, 20)])
    down = (seen[:, NOSE, 1] - seen[:, BROW, 1]) / (seen[:, CHIN, 1] - seen[:, BROW, 1])
    assert (np.diff(down) < 0).all()
    _look(mesh, kind, [pose(head_roll=roll) for roll in (-30, -15, 15, 30)])


@KINDS
def test_its_mouth_opens_with_ours(mesh: Any, kind: str) -> None:
    opened = np.linspace(0, 1.2, 13)
    seen = _look(mesh, kind, [pose(mouth_open=gap, mouth_jaw=0.6 * gap, mouth_teeth=0.4) for gap in opened])
    assert _rank_correlation(opened, _apart(seen, *LIPS) / _apart(seen, BROW, CHIN)) > 0.9


@KINDS
def test_its_eyes_shut_with_ours(mesh: Any, kind: str) -> None:
    shut = np.linspace(-0.3, 1.0, 14)
    seen = _look(mesh, kind, [pose(lid=lid) for lid in shut])
    opening = sum(_apart(seen, *lids) / _apart(seen, *corners) for lids, corners in LIDS)
    assert _rank_correlation(shut, -np.asarray(opening)) > 0.9


def _look(mesh: Any, kind: str, poses: list[Floats]) -> Floats:
    """The mesh's points in the drawn poses, array[pose, 478, 2] as parts of the picture; every face must be found."""
    out = []
    for number, picture in enumerate(_pictures(kind, np.stack(poses))):
        faces = mesh.process(picture).multi_face_landmarks
        assert faces, f"no face in pose {number}"
        out.append([(point.x, point.y) for point in faces[0].landmark])
    return np.array(out)


def _pictures(kind: str, frames: Floats) -> Iterator[NDArray[np.uint8]]:
    """The poses on their own ground, array[y, x] of R, G, B."""
    rig = rig_of(plain(kind))
    still, ground = backdrop(rig.style)
    count = ground.points.shape[1]
    over = tuple(
        replace(shape, contours=tuple(replace(one, first=one.first + count) for one in shape.contours))
        for shape in rig.shapes
    )
    painter = Painter(SIZE, SIZE, (*still, *over))
    white = np.full((SIZE, SIZE), 0xFFFFFFFF, dtype=np.uint32)
    drawn = rig.draw(frames)
    for points, opacity in zip(drawn.points, drawn.opacity, strict=True):
        at = np.concatenate([ground.points[0], points]) * (SIZE / rig.box[0])
        painter.draw(at, np.concatenate([ground.opacity[0], opacity]), white)
        yield np.ascontiguousarray(painter.pixels.view(np.uint8).reshape(SIZE, SIZE, 4)[:, :, 2::-1])


def _apart(seen: Floats, one: int, other: int) -> Floats:
    distance: Floats = np.linalg.norm(seen[:, one] - seen[:, other], axis=1)
    return distance


def _rank_correlation(a: Floats, b: Floats) -> float:
    """Spearman's, for values that are all different."""
    ranks = [np.argsort(np.argsort(values)).astype(np.float64) for values in (a, b)]
    return float(np.corrcoef(ranks[0], ranks[1])[0, 1])
