"""What the cells of a sheet ask for is what the face does, as it would in a film."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from goldens import page_of

from facescript.compile import compile_source
from facescript.motion.perform import perform
from facescript.performance.channels import INDEX, MOUTH
from facescript.sheet.cells import Cell
from facescript.sheet.poses import poses
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.mouth.visemes import SHAPES
from facescript.text import Source
from facescript.world import World

SCRIPT = """\
film 480x480
face ada = woman
    life still
    size 120%
    at 0% -7%
expression wry = smile.left 60% + lid.right 30%
expression AU12 = cheek.lower 50%
expression much(strength) = smile strength
show {what} over 1ms
wait 1s
"""


def film(what: str) -> tuple[np.ndarray, object]:
    """The pose in which a film shows something, and its score."""
    source = Source("script.face", SCRIPT.format(what=what))
    compiled = compile_source(source, World(Path(__file__).parent), EstimatedVoice())
    assert compiled.score is not None, [item.message for item in compiled.diagnostics]
    performance = perform(compiled.score)
    (face,) = performance.faces
    return performance.sample_face(face, np.array([0.9]))[0], compiled.score


def cells(units: bool = False) -> dict[str, Cell]:
    spots = page_of(SCRIPT.format(what="wry"), units=units).spots
    return {spot.cell.label: spot.cell for spot in reversed(spots)}


def posed(*wanted: Cell) -> list[dict[str, float]]:
    found = poses(film("wry")[1], wanted)  # type: ignore[arg-type]
    return [dict(zip(INDEX, row.tolist(), strict=True)) for row in found]


@pytest.mark.parametrize("what", ["surprise", "sadness", "inquisitive", "blinking", "wry", "smile", "tilting", "AU64"])
def test_expression_is_posed_as_in_a_film(what: str) -> None:
    shown, score = film(what)
    assert np.abs(poses(score, [cells(units=True)[what]])[0] - shown).max() < 1e-9  # type: ignore[arg-type]


def test_rest_is_a_films_rest() -> None:
    shown, score = film("neutral")
    assert np.abs(poses(score, [cells()["at rest"]])[0] - shown).max() < 1e-9  # type: ignore[arg-type]


def test_every_expression_has_a_cell() -> None:
    """The author's first, each once; units only where they are wanted; none that needs a value."""
    labels = [spot.cell.label for spot in page_of(SCRIPT.format(what="wry")).spots]
    assert labels[3] == "wry" and labels.count("happiness") == 1
    assert not {"AU1", "AU12", "much"} & set(labels)
    with_units = [spot.cell.label for spot in page_of(SCRIPT.format(what="wry"), units=True).spots]
    assert with_units.count("AU12") == 1 and {"AU1", "AU64"} <= set(with_units) and "much" not in with_units
    assert set(SHAPES) <= set(labels)


def test_mouth_has_the_shapes_of_speech() -> None:
    for name, values in SHAPES.items():
        pose = posed(Cell(name, spoken=values))[0]
        assert [pose[f"mouth.{part}"] for part in MOUTH] == pytest.approx(list(values)), name


def test_head_takes_the_eyes_along() -> None:
    for pose in posed(Cell("", turn=(-45.0, 30.0)), Cell("", turn=(30.0, -15.0))):
        assert abs(pose["eye.left.yaw"] + pose["eye.right.yaw"]) < 0.5, "they converge, and go neither way"
        assert abs(pose["eye.left.pitch"]) < 0.5
    turned = posed(Cell("", turn=(-45.0, 30.0)))[0]
    assert (turned["head.yaw"], turned["head.pitch"]) == pytest.approx((-45.0, 30.0), abs=0.5)


def test_gaze_turns_the_eyes_alone_and_the_lids_follow() -> None:
    rest, up, down = posed(Cell(""), Cell("", gaze=(30.0, 20.0)), Cell("", gaze=(30.0, -20.0)))
    assert up["head.yaw"] == rest["head.yaw"] and up["eye.left.yaw"] - rest["eye.left.yaw"] == pytest.approx(30, abs=2)
    assert up["lid.left"] < rest["lid.left"] < down["lid.left"]


def test_blink_phases_shut_evenly_and_a_wink_shuts_one_eye() -> None:
    found = cells()
    phases = posed(*(found[f"{phase} %"] for phase in (0, 25, 50, 75, 100)))
    assert np.diff([pose["lid.left"] for pose in phases]) == pytest.approx([0.25] * 4, abs=0.02)
    left, right = posed(found["wink left"], found["wink right"])
    assert left["lid.left"] == right["lid.right"] == 1.0
    assert left["lid.right"] < 0.1 and right["lid.left"] < 0.1
