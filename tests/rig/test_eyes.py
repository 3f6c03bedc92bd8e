"""Faces with one eye or many: all of them look at the one point that the usual two converge on."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from facescript.diagnostics.catalogue.kinds import KINDS
from facescript.ir.play import Film
from facescript.motion.gaze.eyes import eyes
from facescript.performance.channels import INDEX
from facescript.performance.performance import REST
from facescript.rig.cartoon.backdrop import backdrop
from facescript.rig.cartoon.depth import BALL
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.rigs import rig
from facescript.space.layout import Standing
from facescript.stage.actor import Actor
from rig.poses import script_face

GOOD = next(entry.good for entry in KINDS if entry.code == "FS240")
ROW = "    eye half-width 26"
DISTANCE = 100.0
CM = 6.3


def face(*eyes: str) -> CartoonRig:
    """The example's face with these eyes, by name and place, instead of the usual two."""
    head, _, rest = GOOD.partition(ROW)
    measures, _, after = rest.partition("    mouth")
    rows = "".join(f"    eye {eye}, half-width 26{measures}" for eye in eyes)
    return rig(script_face(head + rows + "    mouth" + after))


def looking(yaw: float, pitch: float, distance: float) -> NDArray[np.float64]:
    """A pose that looks at a point so far away (cm), as gaze sets it."""
    pose = REST.copy()
    both = eyes(np.array([[yaw, pitch, distance]]), np.zeros((1, 3)))[0]
    for side, angles in zip(("left", "right"), both, strict=True):
        for axis, value in zip(("yaw", "pitch", "roll"), angles, strict=True):
            pose[INDEX[f"eye.{side}.{axis}"]] = value
    return pose


def direction(drawn: CartoonRig, name: str, at: tuple[float, float], pose: NDArray[np.float64]) -> NDArray[np.float64]:
    """Where an iris points: a unit vector (right, up, ahead) from where it is drawn on its ball."""
    (contour,) = next(shape for shape in drawn.shapes if shape.id == f"eye-iris-{name}").contours
    ring = drawn.draw(pose[None]).points[0, contour.first : contour.first + contour.count - 1 : 3]
    aside, down = (ring.mean(axis=0) - np.array(drawn.eyes) - at) / (BALL * DISTANCE)
    return np.array([aside, -down, np.sqrt(1.0 - aside * aside - down * down)])


@settings(deadline=None)
@given(st.floats(-20, 20), st.floats(-12, 12), st.floats(25, 300))
def test_every_eye_looks_at_the_same_point(yaw: float, pitch: float, distance: float) -> None:
    places = {"low": (0.0, 60.0), "aside": (-90.0, -20.0), "middle": (0.0, 0.0)}
    drawn = face(*(f"{name} at ({x:g} {y:g})" for name, (x, y) in places.items()))
    y, p = np.radians([yaw, pitch])
    target = distance * np.array([np.sin(y) * np.cos(p), np.sin(p), np.cos(y) * np.cos(p)])
    for name, at in places.items():
        eye = np.array([at[0], -at[1], 0.0]) * CM / DISTANCE
        wanted = (target - eye) / np.linalg.norm(target - eye)
        assert direction(drawn, name, at, looking(yaw, pitch, distance)) @ wanted == pytest.approx(1.0, abs=2e-4)


def test_the_smallest_kind_is_drawn_without_a_ground_of_its_own() -> None:
    shapes, still = backdrop(rig(script_face(GOOD)).style)
    assert shapes == () and still.points.shape == (1, 0, 2)
    actor = Actor(script_face(GOOD), Standing(0.0, 0.0, 1.0), Film())
    drawn = actor.draw(REST[None]).points
    assert np.isfinite(drawn).all() and actor.ground is None
    assert drawn[..., 1].max() < 500.0


def test_one_eye_shuts_by_half_where_one_of_two_would() -> None:
    drawn = face("middle at (0 0)")
    assert [shape.id for shape in drawn.shapes if shape.id.startswith("eye-white")] == ["eye-white-middle"]

    def height(left: float, right: float) -> float:
        pose = REST.copy()
        pose[INDEX["lid.left"]], pose[INDEX["lid.right"]] = left, right
        (contour,) = next(shape for shape in drawn.shapes if shape.id == "eye-white-middle").contours
        points = drawn.draw(pose[None]).points[0, contour.first : contour.first + contour.count]
        return float(np.ptp(points[:, 1]))

    assert height(1.0, 1.0) < height(1.0, 0.0) == height(0.5, 0.5) < height(0.0, 0.0)
