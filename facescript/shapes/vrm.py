"""Channels to the expressions of VRM avatars, under their names of VRM 1 and VRM 0, and back.

VRM has no muscles, only whole expressions and five vowels: its table says which channels each makes, and a pose becomes
the mixture that is nearest to it.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from facescript.shapes.limits import limits
from facescript.shapes.measures import COLUMNS, lids_from_shut, measured, posed
from facescript.shapes.rows import rows
from facescript.shapes.solver import Floats, Solver, matrix

NAMES: tuple[str, ...] = tuple(row["name"] for row in rows("vrm"))
"""As VRM 1 has them. `blink` is always 0, as `blinkLeft` and `blinkRight` say it."""

VRM0: tuple[str, ...] = tuple(row["vrm 0"] for row in rows("vrm"))
"""The same in VRM 0, and in VMC's messages; `Surprised` is common there, but no preset."""

INDEX = {name: number for number, name in enumerate(NAMES)}

WEIGHTS = {"mouth.teeth": 0.2, "mouth.wide": 3.0}
"""How much a channel counts for which mixture is nearest, where not 1 (an angle: a thirtieth for each degree)."""


def shapes(poses: Floats) -> Floats:
    """array[n, POSE] of one face to array[n, 19], 0..1 each."""
    return _solver()(measured(poses) * _weights())


def poses(shapes: Floats) -> Floats:
    """array[n, 19] to array[n, POSE]: what the table says that they make, each within 0..1."""
    columns = np.clip(np.clip(shapes, 0.0, 1.0) @ _makes(), *limits())
    found = posed(columns)
    lids_from_shut(found, columns)
    return found


@cache
def _makes() -> Floats:
    return matrix((row["makes"] for row in rows("vrm")), COLUMNS)


@cache
def _weights() -> Floats:
    angles = [1.0 / 30.0 if name.endswith((".yaw", ".pitch", ".roll")) else 1.0 for name in COLUMNS]
    return np.array([WEIGHTS.get(name, angle) for name, angle in zip(COLUMNS, angles, strict=True)])


@cache
def _solver() -> Solver:
    made = _makes() * _weights()
    return Solver(made.T, np.zeros(len(NAMES)), np.ones(len(NAMES)))
