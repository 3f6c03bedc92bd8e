"""Channels to the 68 facial animation parameters of MPEG-4, in their units, and back."""

from __future__ import annotations

from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import POSE
from facescript.shapes.limits import limits
from facescript.shapes.measures import AT, COLUMNS, measured, mouth_from_lips, posed, teeth_shown
from facescript.shapes.rows import rows
from facescript.shapes.solver import Floats, Solver, matrix

NAMES: tuple[str, ...] = tuple(row["name"] for row in rows("fap"))
"""FAP 1 to FAP 68. FAP 1 and 2 (viseme, expression) are always 0: what they would say is in the others."""

INDEX = {name: number for number, name in enumerate(NAMES)}

BY_MEASURE = ("mouth.open", "mouth.upper", "mouth.lower", "mouth.teeth")
"""Channels that are told by measures."""


def shapes(poses: Floats) -> Floats:
    """array[n, POSE] of one face to array[n, 68], in 1/1024 of the face's own units (FAPU), angles in 1e-5 rad. Files
    have whole numbers of them."""
    factors, low, high = _factors()
    return np.clip(measured(poses) @ factors.T, low, high)


def poses(shapes: Floats, told: tuple[str, ...] = NAMES) -> Floats:
    """array[n, 68] to array[n, POSE]: the channels that make these parameters, within their limits; of the parameters
    only those `told` count. Channels that these do not tell of are at rest (`channels`)."""
    rows_, solver = _solver(told)
    columns = solver(np.asarray(shapes, dtype=np.float64)[:, rows_])
    found = posed(columns)
    mouth_from_lips(found, columns)
    teeth_shown(found)
    return found


def channels(told: tuple[str, ...] = NAMES) -> tuple[str, ...]:
    """The channels that come back from the parameters `told`, in the order of a pose: those most of which shows in
    them."""
    found = set(np.array(COLUMNS)[_held(_rows(told))])
    if "lips.rise" in found:
        found |= set(BY_MEASURE)
    return tuple(channel.name for channel in POSE if channel.name in found)


def made() -> NDArray[np.bool_]:
    """Which parameters some channel makes: array[68]."""
    found: NDArray[np.bool_] = np.any(_factors()[0] != 0.0, axis=1)
    return found


@cache
def _factors() -> tuple[Floats, Floats, Floats]:
    table = rows("fap")
    factors = matrix((row["made of"] for row in table), COLUMNS)
    return factors, np.array([float(row["low"]) for row in table]), np.array([float(row["high"]) for row in table])


def _rows(told: tuple[str, ...]) -> NDArray[np.intp]:
    return np.array(sorted(INDEX[name] for name in told), dtype=np.intp)


def _held(rows_: NDArray[np.intp]) -> NDArray[np.bool_]:
    """The columns of which at least two fifths of what they do are in these rows: outer or inner lips are enough."""
    factors = _factors()[0] / np.maximum(np.abs(_factors()[2]), 1.0)[:, None]
    whole, seen = np.square(factors).sum(axis=0), np.square(factors[rows_]).sum(axis=0)
    held: NDArray[np.bool_] = (whole > 0.0) & (seen >= 0.4 * whole)
    held[AT["tongue.out"]] = False
    return held


@lru_cache(maxsize=8)
def _solver(told: tuple[str, ...]) -> tuple[NDArray[np.intp], Solver]:
    found = _rows(told)
    factors = np.where(_held(found), _factors()[0][found], 0.0)
    return found, Solver(factors, *limits())
