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


class Limit(Protocol):
    """A limit for rows array[moment, coordinate], x and y in turn."""

    @property
    def rough(self) -> float:
        """How far from a straight line the points of a way may be for a closer look to be worth it."""
        ...

    def holds(self, moments: slice, drawn: Floats) -> bool:
        """Whether `drawn` may stand for the rows of these moments."""
        ...


@dataclass(frozen=True, slots=True)
class Apart:
    """No point is farther than `tolerance` from its row."""

    rows: Floats
    tolerance: float

    @property
    def rough(self) -> float:
        return WIDE * self.tolerance

    def holds(self, moments: slice, drawn: Floats) -> bool:
        return apart(drawn - self.rows[moments]) <= self.tolerance


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

    def holds(self, moments: slice, drawn: Floats) -> bool:
        x, y = drawn[:, ::2] @ self.basis.T, drawn[:, 1::2] @ self.basis.T
        return bool((np.abs(x * self.x[moments] + y * self.y[moments] - self.true[moments]) <= 1).all())


def apart(away: Floats) -> float:
    """The longest of the vectors whose x and y stand in turn."""
    return float(np.sqrt((away[:, ::2] ** 2 + away[:, 1::2] ** 2).max()))
