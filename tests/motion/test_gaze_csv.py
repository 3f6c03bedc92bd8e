"""The bars once more from the .csv of a whole build: script to channels through every pass, 1000 frames a second."""

from __future__ import annotations

from pathlib import Path

import pytest
from bars import Trace, bar, final_share, head_lag_ms, movement, read, vor_error, vor_gain

from facescript.cli.main import main

SCRIPT = """film 640x360, screen none, 60fps
face ada = woman
    life still
target there at {yaw}deg {pitch}deg 3m
scene opening:
    wait 500ms
    look at there{manner}
    wait 1500ms
"""


def build(folder: Path, yaw: float, pitch: float = 0, manner: str = "") -> Trace:
    script, table = folder / "look.face", folder / "look.csv"
    script.write_text(SCRIPT.format(yaw=yaw, pitch=pitch, manner=manner), "utf-8")
    assert main(["build", str(script), "-o", str(table), "--fps", "1000", "--quiet"]) == 0
    return read(table)


def within(value: float, name: str, case: str) -> None:
    low, high = bar(name, case)
    assert low <= value <= high, f"{name} {case}: {value:.3f} is not in {low}..{high}"


@pytest.mark.parametrize(("yaw", "case"), [(5, "5"), (30, "30")])
def test_eyes_only(tmp_path: Path, yaw: int, case: str) -> None:
    seen = build(tmp_path, yaw, manner=", eyes only")
    saccade = movement(seen, seen.eye("yaw"))
    within(saccade.lasts_ms, "S1", case)
    within(saccade.peak, "S2", case)
    within(saccade.peak_over_mean, "S4", "5..30")
    within(saccade.peak_part, "S6", case)


def test_up(tmp_path: Path) -> None:
    seen = build(tmp_path, 0, 20, ", eyes only")
    within(movement(seen, seen.eye("pitch")).peak, "S3", "20")


def test_eyes_then_head(tmp_path: Path) -> None:
    seen = build(tmp_path, 30)
    within(head_lag_ms(seen, "yaw"), "H1", "30")
    within(final_share(seen, "yaw", 30), "H4", "horizontal 20..60")
    error, slip = vor_error(seen, "yaw", 30)
    within(error, "H7", "mean error")
    within(slip, "H7", "retinal slip rms")
    within(vor_gain(seen, "yaw", 30), "H8", "far target")
