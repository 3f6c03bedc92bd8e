"""Smile, wink and a turn of the head at once: each channel is the sum of its parts under the blending law, exactly."""

from __future__ import annotations

import csv
from math import tanh
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from facescript.cli.main import main
from facescript.performance.channels import INDEX, MUSCLES, NAMES, SIDES
from facescript.performance.performance import REST

PARTS = {"smile": "show smile {degree}", "wink": "add wink.left", "turn": "add head.yaw 15deg + head.roll 5deg"}
AU6_LID = 0.1
"""How much of a lid AU6 closes beside its cheek (`stdlib/facs.face`): a wink has half of it."""

MUSCLE_COLUMNS = [INDEX[f"{muscle}.{side}"] for muscle in MUSCLES for side in SIDES]


def rows(folder: Path, *acts: str) -> NDArray[np.float64]:
    """The channels of a script that does these at once, array[row, channel], 100 rows a second."""
    name = folder / "script.face"
    lines = "".join(f"        {act}\n" for act in acts)
    name.write_text(f"face ada = woman\n    life still\nscene a:\n    together:\n{lines}    wait 1s\n")
    assert main(["build", str(name), "-o", str(folder / "out.csv"), "--fps", "100", "--to", "1.2s"]) == 0
    with (folder / "out.csv").open(encoding="utf-8") as table:
        return np.array([[float(row[channel]) for channel in NAMES] for row in csv.DictReader(table)])


def limited(sum_of_parts: NDArray[np.float64]) -> NDArray[np.float64]:
    """The law's soft limit, written out."""
    return np.vectorize(lambda x: max(x, 0.0) if x <= 0.8 else 0.8 + 0.2 * tanh((x - 0.8) / 0.2))(sum_of_parts)


@pytest.mark.parametrize("degree", ["50%", "100%"])
def test_smile_wink_and_turn(degree: str, tmp_path: Path) -> None:
    acts = {name: text.format(degree=degree) for name, text in PARTS.items()}
    alone = {name: rows(tmp_path, text) for name, text in acts.items()}
    together = rows(tmp_path, *acts.values())
    quiet = {name: rows(tmp_path, text.format(degree="50%")) for name, text in PARTS.items()}
    smile = quiet["smile"] * (2 if degree == "100%" else 1)

    raw = smile[:, MUSCLE_COLUMNS] + quiet["wink"][:, MUSCLE_COLUMNS] + quiet["turn"][:, MUSCLE_COLUMNS]
    assert together[:, MUSCLE_COLUMNS] == pytest.approx(limited(raw), abs=3e-6)
    assert together[:, MUSCLE_COLUMNS].max() > 0.5

    for side in SIDES:
        lid = INDEX[f"lid.{side}"]
        by_smile, by_wink = alone["smile"][:, lid], AU6_LID * alone["wink"][:, INDEX[f"cheek.upper.{side}"]]
        not_blinking = (1 - alone["wink"][:, lid]) / (1 - by_wink)
        by_gaze = 1 - alone["turn"][:, lid]
        opening = (1 - by_smile - by_wink) * not_blinking * by_gaze
        assert 1 - together[:, lid] == pytest.approx(opening, abs=3e-6)
    assert together[-1, INDEX["lid.left"]] == pytest.approx(1)

    for axis in ("yaw", "pitch", "roll", "x", "y", "scale"):
        head = INDEX[f"head.{axis}"]
        moved = sum(part[:, head] - REST[head] for part in alone.values())
        assert together[:, head] - REST[head] == pytest.approx(moved, abs=3e-6)
    assert together[-1, INDEX["head.yaw"]] == pytest.approx(15)

    for axis in ("yaw", "pitch"):
        gaze = INDEX[f"gaze.{axis}"]
        assert alone["turn"][:, gaze] == pytest.approx(0, abs=1e-4), "the eyes stay on the camera while the head turns"
        assert together[:, gaze] == pytest.approx(alone["wink"][:, gaze], abs=0.1), "a lid that closes pulls its eye"
