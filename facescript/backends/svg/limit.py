"""What is drawn beside what should be: whether the one keeps near enough to the other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from facescript.backends.svg.curves import Curves

Floats = NDArray[np.float64]

WIDE = 2.0
"""Tolerances beyond which no choice of the end can make a way straight enough."""


class Way(Protocol):
    """The rows of some moments beside an anchor that a straight way starts from."""

    def holds(self, course: Floats, step: Floats) -> bool:
        """Whether the anchor and `course`, array[moment], times `step` may stand for these rows."""
        ...


class Limit(Protocol):
    """A limit for rows array[moment, coordinate], x and y in turn."""

    @property
    def rough(self) -> float:
        """How far from a straight line the points of a way may be for a closer look to be worth it."""
        ...

    def way(self, moments: slice, anchor: Floats) -> Way:
        """What holds for a way from `anchor` through these moments."""
        ...


@dataclass(frozen=True, slots=True)
class Apart:
    """No point is farther than `tolerance` from its row."""

    rows: Floats
    tolerance: float

    @property
    def rough(self) -> float:
        return WIDE * self.tolerance

    def way(self, moments: slice, anchor: Floats) -> Way:
        return _Points(anchor - self.rows[moments], self.tolerance)


@dataclass(frozen=True, slots=True)
class _Points:
    away: Floats
    tolerance: float

    def holds(self, course: Floats, step: Floats) -> bool:
        return apart(self.away + course[:, None] * step) <= self.tolerance


@dataclass(frozen=True, slots=True)
class Edge:
    """No sample of a curve is farther than 1 from the true outline, straight across it; at corners, any way.

    Samples are `basis` times the controls. `x` and `y`, array[moment, sample], are the directions across, as long as
    distances there count; `true` is where the outline lies along them. `rough` is in units of the controls.
    """

    basis: Floats
    x: Floats
    y: Floats
    true: Floats
    rough: float

    @classmethod
    def of(cls, curves: Curves, points: Floats, tolerances: Floats, unit: float) -> Edge:
        """The limit of outlines array[moment, point, 2] whose controls are in `unit`; `tolerances`, array[moment,
        spot], are how far each of the curves' spots may be off, in the unit of the points."""
        spots, along = curves.spots @ points, curves.slope @ points
        smooth = len(curves.slope)
        counts = 1 / tolerances
        along *= counts[:, :smooth, None] / np.maximum(np.linalg.norm(along, axis=2), 1e-9)[..., None]
        ends, none = counts[:, smooth:], np.zeros_like(counts[:, smooth:])
        x = np.concatenate([-along[..., 1], ends, none], axis=1)
        y = np.concatenate([along[..., 0], none, ends], axis=1)
        spots = np.concatenate([spots, spots[:, smooth:]], axis=1)
        basis = np.concatenate([curves.basis, curves.basis[smooth:]]) * unit
        return cls(basis, x, y, spots[..., 0] * x + spots[..., 1] * y, WIDE * float(tolerances.min()) / unit)

    def way(self, moments: slice, anchor: Floats) -> Way:
        x, y = self.x[moments], self.y[moments]
        return _Samples(self.basis, x, y, _across(self.basis, x, y, anchor) - self.true[moments])


@dataclass(frozen=True, slots=True)
class _Samples:
    basis: Floats
    x: Floats
    y: Floats
    away: Floats

    def holds(self, course: Floats, step: Floats) -> bool:
        lean = _across(self.basis, self.x, self.y, step)
        lean *= course[:, None]
        lean += self.away
        return bool(max(lean.max(), -lean.min()) <= 1)


def _across(basis: Floats, x: Floats, y: Floats, controls: Floats) -> Floats:
    """How far across the outline, array[moment, sample], the samples of some controls lie."""
    across: Floats = x * (basis @ controls[::2])
    across += y * (basis @ controls[1::2])
    return across


def apart(away: Floats) -> float:
    """The longest of the vectors whose x and y stand in turn."""
    return float(np.sqrt((away[:, ::2] ** 2 + away[:, 1::2] ** 2).max()))
