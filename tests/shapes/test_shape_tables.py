"""The tables of shapes: what each shape is made of, on which side, with which sign, and what comes back of it."""

from __future__ import annotations

import numpy as np
import pytest

from facescript.performance.channels import INDEX, MUSCLES, POSE, SIDES
from facescript.performance.performance import REST
from facescript.shapes import arkit, fap, vrm
from facescript.shapes.limits import limits
from facescript.shapes.measures import COLUMNS, lid_of
from facescript.shapes.rows import rows, terms
from facescript.shapes.solver import Floats, Solver


def pose(**channels: float) -> Floats:
    """A pose off its rest in some channels: `head_yaw=20`, of a pair without a side both. Lids go with the eyes."""
    found = REST.copy()[None]
    for name, value in channels.items():
        dotted = name.replace("_", ".")
        eye = dotted.replace("eye.", "eye.{}.") if dotted.count(".") == 1 and "eye" in dotted else f"{dotted}.{{}}"
        for each in [dotted] if dotted in INDEX else [eye.format(side) for side in SIDES]:
            found[0, INDEX[each]] = value
    for side in SIDES:
        pitch = found[:, INDEX[f"eye.{side}.pitch"]]
        lid = INDEX[f"lid.{side}"]
        found[:, lid] = lid_of(found[:, lid], pitch)
    return found


def off_rest(made: Floats) -> dict[str, float]:
    """The channels of a pose that are not at rest."""
    moved = np.abs(made[0] - REST) > 1e-3
    return {POSE[at].name: round(float(made[0, at]), 3) for at in np.flatnonzero(moved)}


@pytest.mark.parametrize(("table", "column"), [("arkit", "made of"), ("fap", "made of"), ("vrm", "makes")])
def test_every_row_speaks_of_channels_and_bears_a_name_of_its_own(table: str, column: str) -> None:
    found = rows(table)
    assert len({row["name"] for row in found}) == len(found) == {"arkit": 61, "fap": 68, "vrm": 18}[table]
    assert {name for row in found for name in terms(row[column])} <= set(COLUMNS)


@pytest.mark.parametrize("table", [arkit, fap, vrm])
def test_a_face_at_rest_has_no_shape_and_no_shape_is_rest(table: object) -> None:
    module = {arkit: arkit, fap: fap, vrm: vrm}[table]  # type: ignore[index]
    assert not module.shapes(REST[None]).any()
    assert off_rest(module.poses(np.zeros((1, len(module.NAMES))))) == {}


@pytest.mark.parametrize(
    ("channels", "shape", "value"),
    [
        ({"cheek_lower_left": 0.5}, "MouthSmileLeft", 0.5),
        ({"lid_left": 1.0}, "EyeBlinkLeft", 1.0),
        ({"lid_right": -0.35}, "EyeWideRight", 1.0),
        ({"eye_left_yaw": 15.0}, "EyeLookOutLeft", 0.5),
        ({"eye_right_yaw": 15.0}, "EyeLookInRight", 0.5),
        ({"eye_left_pitch": -15.0}, "EyeLookDownLeft", 0.5),
        ({"head_yaw": 20.0}, "HeadYaw", -np.radians(20.0)),
        ({"head_pitch": 20.0}, "HeadPitch", -np.radians(20.0)),
        ({"head_roll": 20.0}, "HeadRoll", np.radians(20.0)),
        ({"eye_left_yaw": 15.0}, "LeftEyeYaw", -np.radians(15.0)),
        ({"brow_inner_left": 0.8}, "BrowInnerUp", 0.4),
    ],
)
def test_sides_and_signs_of_arkit(channels: dict[str, float], shape: str, value: float) -> None:
    """Left is the face's own. Of recordings of Live Link Face: an eye turned to its own right has a positive yaw, and
    one that looks down a positive pitch."""
    assert arkit.shapes(pose(**channels))[0, arkit.INDEX[shape]] == pytest.approx(value, abs=1e-6)


@pytest.mark.parametrize(
    ("channels", "parameter", "value"),
    [
        ({"head_yaw": 10.0}, "head_yaw", 17453.3),
        ({"head_pitch": 10.0}, "head_pitch", -17453.3),
        ({"head_roll": 10.0}, "head_roll", -17453.3),
        ({"eye_left_yaw": 10.0}, "yaw_l_eyeball", 17453.3),
        ({"lid_left": 1.0}, "close_t_l_eyelid", 922.0),
        ({"mouth_open": 0.5, "mouth_upper": 0.2, "mouth_lower": 0.3}, "raise_b_midlip", -307.2),
        ({"brow_inner_right": 1.0}, "raise_r_i_eyebrow", 226.0),
    ],
)
def test_sides_and_signs_of_mpeg4(channels: dict[str, float], parameter: str, value: float) -> None:
    assert fap.shapes(pose(**channels))[0, fap.INDEX[parameter]] == pytest.approx(value, abs=0.1)


def test_eyes_that_look_down_are_not_half_shut_for_a_face_that_moves_its_lids_itself() -> None:
    looking = pose(eye_pitch=-20.0)
    assert arkit.shapes(looking)[0, arkit.INDEX["EyeBlinkLeft"]] == pytest.approx(0.0, abs=1e-3)
    assert off_rest(arkit.poses(arkit.shapes(looking)))["lid.left"] == pytest.approx(0.396, abs=1e-3)


@pytest.mark.parametrize("muscle", MUSCLES)
@pytest.mark.parametrize("table", [arkit, fap])
def test_a_muscle_comes_back(table: object, muscle: str) -> None:
    """By ARKit both sides, though it has no shape of the whole forehead; by MPEG-4 each side, but for the chin."""
    module = arkit if table is arkit else fap
    both = pose(**{muscle.replace(".", "_"): 0.6})
    told = off_rest(module.poses(module.shapes(both)))
    if module is arkit and muscle == "forehead":
        assert told == dict.fromkeys((f"brow.{part}.{side}" for part in ("inner", "outer") for side in SIDES), 0.6)
    else:
        assert told == dict.fromkeys((f"{muscle}.{side}" for side in SIDES), 0.6)
    if module is fap and muscle != "chin":
        left = pose(**{f"{muscle.replace('.', '_')}_left": 0.6})
        assert off_rest(fap.poses(fap.shapes(left))) == {f"{muscle}.left": 0.6}


def test_what_a_mouth_that_speaks_comes_back_as() -> None:
    """Shape a of speech by ARKit: the corners, drawn in, are lost; how much of the teeth shows is guessed."""
    said = pose(mouth_open=1.1, mouth_upper=0.3, mouth_lower=0.8, mouth_jaw=2 / 3, mouth_wide=-0.125, mouth_teeth=0.3)
    back = off_rest(arkit.poses(arkit.shapes(said)))
    assert back == {
        "mouth.open": 1.1,
        "mouth.upper": 0.3,
        "mouth.lower": 0.8,
        "mouth.jaw": 0.667,
        "mouth.teeth": pytest.approx(0.4, abs=0.01),
    }
    assert off_rest(fap.poses(fap.shapes(said)))["mouth.wide"] == -0.125


@pytest.mark.parametrize("vowel", ["aa", "ih", "ou", "ee", "oh"])
def test_a_vowel_of_vrm_is_that_vowel(vowel: str) -> None:
    one = np.eye(len(vrm.NAMES))[[vrm.INDEX[vowel]]]
    assert np.allclose(vrm.shapes(vrm.poses(one)), one, atol=1e-3)


def test_a_smile_is_joy_and_a_wink_is_one_blink() -> None:
    smile = vrm.shapes(pose(cheek_lower=1.0, cheek_upper=0.4))[0]
    assert {vrm.VRM0[at]: round(smile[at], 2) for at in np.flatnonzero(smile > 0.01)} == {"Joy": 1.0}
    wink = vrm.shapes(pose(lid_left=1.0))[0]
    assert {vrm.NAMES[at]: round(wink[at], 2) for at in np.flatnonzero(wink > 0.01)} == {"blinkLeft": 1.0}


@pytest.mark.parametrize("table", [arkit, fap])
def test_any_shapes_make_a_face_within_its_limits_that_has_nearly_these_shapes(table: object) -> None:
    """Shapes that a face can have come back as they were; wild ones are as near as its limits let them be."""
    module = arkit if table is arkit else fap
    dice = np.random.default_rng(7)
    faces = REST + dice.uniform(0.0, 0.6, (50, len(POSE))) * (dice.random((50, len(POSE))) < 0.2)
    faces[:, [INDEX[name] for name in ("mouth.open", "mouth.upper", "mouth.lower")]] = 0.0
    shown = module.shapes(faces)
    again = module.shapes(module.poses(shown))
    scale = np.maximum(np.abs(shown).max(axis=0), 1.0 if module is arkit else 100.0)
    assert np.median(np.abs(again - shown) / scale) < 0.01
    wild = module.poses(dice.normal(0.0, 3.0 if module is arkit else 3000.0, (50, len(module.NAMES))))
    low, high = limits()
    held = [INDEX[f"{muscle}.{side}"] for muscle in MUSCLES for side in SIDES]
    assert np.all(wild[:, held] >= low[held] - 1e-9) and np.all(wild[:, held] <= high[held] + 1e-9)
    assert np.isfinite(wild).all()


def test_a_row_is_worked_out_by_itself() -> None:
    """The same frame gives the same whatever stands beside it: a stream and a file agree."""
    faces = REST + np.random.default_rng(3).uniform(0.0, 1.0, (20, len(POSE)))
    for module in (arkit, fap, vrm):
        whole = module.shapes(faces)
        assert np.allclose(whole[7:8], module.shapes(faces[7:8]), atol=1e-12)
        assert np.allclose(module.poses(whole)[7:8], module.poses(whole[7:8]), atol=1e-9)


def test_the_search_finds_the_least_squares_within_limits() -> None:
    """Against a search of the corners of a small box."""
    factors = np.array([[1.0, 0.9, 0.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0]])
    solver = Solver(factors, np.zeros(3), np.ones(3))
    wanted = np.array([[2.5, -1.0, 0.7]])
    grid = np.stack(np.meshgrid(*[np.linspace(0.0, 1.0, 41)] * 3), axis=-1).reshape(-1, 3)
    best = np.square(grid @ factors.T - wanted).sum(axis=1).min()
    assert np.square(solver(wanted) @ factors.T - wanted).sum() <= best + 1e-3
