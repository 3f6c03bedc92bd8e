"""Human motion from the `.csv` itself: scripts built at 1000 rows a second and measured against the published bars.

Onset rule, the same for eye and head: 5 % of the movement's peak speed (`tests/motion/bars.py`).
"""

from __future__ import annotations

import csv
import itertools
from collections.abc import Callable
from math import cos, radians, sin
from pathlib import Path

import numpy as np
import pytest
from bars import (
    Trace,
    bar,
    eye_extremes,
    final_share,
    head_lag_ms,
    movement,
    share_at_landing,
    spearman,
    vergence_error,
    vor_error,
    vor_gain,
)

from facescript.cli.main import main
from facescript.space.layout import BOX, EYES

EYES_UP = (BOX / 2 - EYES[1]) * 50 / BOX
"""Cm that the middle of the eyes is above the picture's centre: the film is 720 px and 50 cm wide."""

Looker = Callable[..., Trace]


@pytest.fixture(scope="module")
def look(tmp_path_factory: pytest.TempPathFactory) -> Looker:
    """A look at a direction, built to a .csv and read back; the same look is built once."""
    built: dict[tuple[object, ...], Trace] = {}

    def one(yaw: float, pitch: float = 0.0, manner: str = "", distance: float = 300.0) -> Trace:
        key = (yaw, pitch, manner, distance)
        if key not in built:
            built[key] = build(tmp_path_factory.mktemp("look"), yaw, pitch, manner, distance)
        return built[key]

    return one


def build(folder: Path, yaw: float, pitch: float, manner: str, distance: float) -> Trace:
    y, p = radians(yaw), radians(pitch)
    place = (distance * cos(p) * sin(y), EYES_UP + distance * sin(p), distance * cos(p) * cos(y))
    where = " ".join(f"{value:.4f}cm" for value in place)
    script = folder / "look.face"
    script.write_text(
        "film 720x720, seed 1, screen none\nface ada = woman\n    life still\n"
        f"target there at {where}\nwait 200ms\nlook at there{manner}\nwait 2s\n"
    )
    assert main(["build", str(script), "-o", str(folder / "look.csv"), "--fps", "1000", "--quiet"]) == 0
    with (folder / "look.csv").open(encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    channels = {
        name: np.array([float(row[name]) for row in rows]) for name in rows[0] if name not in ("time", "marker")
    }
    return Trace(np.array([float(row["time"]) for row in rows]), channels)


def inside(value: float, name: str, case: str) -> None:
    low, high = bar(name, case)
    assert low <= value <= high, f"{name} {case}: {value:.3f} is not in {low} .. {high}"


EYES_ONLY = ", eyes only"


@pytest.mark.parametrize("side", [1, -1])
def test_saccades_sideways(look: Looker, side: int) -> None:
    found = {
        size: movement(trace := look(side * size, manner=EYES_ONLY), trace.eye("yaw"))
        for size in (5, 10, 15, 20, 30, 40)
    }
    for size in (5, 10, 20, 30):
        inside(found[size].lasts_ms, "S1", str(size))
    for size in (5, 15, 30):
        inside(found[size].peak, "S2", str(size))
    for size in (5, 10, 15, 20, 30):
        inside(found[size].peak_over_mean, "S4", "5..30")
    inside(found[40].peak / found[20].peak, "S5", "40/20")
    inside(found[5].peak_part, "S6", "5")
    inside(found[30].peak_part, "S6", "30")
    parts = [found[size].peak_part for size in (5, 10, 20, 30, 40)]
    assert all(later <= earlier for earlier, later in itertools.pairwise(parts)), parts


@pytest.mark.parametrize("side", [1, -1])
def test_saccades_up_and_down(look: Looker, side: int) -> None:
    found = {size: movement(trace := look(0, side * size, EYES_ONLY), trace.eye("pitch")) for size in (5, 10, 15, 20)}
    for size in (5, 10, 20):
        inside(found[size].lasts_ms, "S1", str(size))
        inside(found[size].peak, "S3", str(size))
        inside(found[size].peak_over_mean, "S4", "5..30")
    inside(found[5].peak_part, "S6", "5")


@pytest.mark.parametrize("side", [1, -1])
def test_eyes_and_head_together(look: Looker, side: int) -> None:
    sizes = (10, 20, 30, 40, 50)
    traces = {size: look(side * size) for size in sizes}
    lags = {size: head_lag_ms(traces[size], "yaw") for size in sizes}
    for size in (10, 20, 30, 40):
        inside(lags[size], "H1", str(size))
        inside(eye_peak(traces[size]), "H2", str(size))
    assert lags[10] > lags[40]
    inside(share_at_landing(traces[50], "yaw", side * 50), "H3", "50")
    for size in (20, 30, 40, 50):
        inside(final_share(traces[size], "yaw", side * size), "H4", "horizontal 20..60")
    heads = [movement(traces[size], traces[size].head("yaw")).peak for size in sizes]
    inside(spearman(list(sizes), heads), "H6", "rho")
    inside(max(heads), "H6", "max")
    for size in sizes:
        error, slip = vor_error(traces[size], "yaw", side * size)
        inside(error, "H7", "mean error")
        inside(slip, "H7", "retinal slip rms")
        inside(vor_gain(traces[size], "yaw", side * size), "H8", "far target")
        inside(eye_extremes(traces[size])["yaw"], "S8", "yaw")


def test_head_share_up_and_down(look: Looker) -> None:
    for size in (20, 30, 40):
        inside(final_share(look(0, size), "pitch", size), "H4", "up 20..40")
        inside(final_share(look(0, -size), "pitch", -size), "H4", "down 20..40")
        inside(eye_extremes(look(0, size))["up"], "S8", "up")
        inside(eye_extremes(look(0, -size))["down"], "S8", "down")


@pytest.mark.parametrize("metres", [0.3, 0.5, 1.0, 2.0, 3.0, 6.0])
def test_vergence(look: Looker, metres: float) -> None:
    inside(vergence_error(look(0, 0, EYES_ONLY, metres * 100), metres * 100), "V1", "0.3..6 m")


def eye_peak(trace: Trace) -> float:
    """The eyes' peak speed in the head while gaze moves."""
    gaze = movement(trace, trace.gaze("yaw"))
    part = trace.part(gaze.onset, gaze.end)
    return float(np.abs(part.speed(part.eye("yaw"))).max())
