"""Where hair lies at rest -> how far it is moved when locks trail behind the head (the channels `hair.*`).

A lock stays where it grows and trails most at its tip. Hair that hangs below the ears is the slower the lower it
hangs; short hair stands up on the crown and is quick, long hair lies flat there by its weight.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.rig.cartoon.depth import smooth

Floats = NDArray[np.float64]
Share = tuple[float, float, float]
"""How much an anchor has of the slow, the middle and the quick locks: 0 where it grows, 1 at a tip that hangs free."""

LOCKS = ("slow", "middle", "quick")

REACH = 0.018
"""How far (d) a tip moves for a degree that its lock trails."""

UPRIGHT = 0.3
"""How much of that is up and down: hair is lifted less than it swings."""

EARS, TIPS = 0.25, 2.4
"""Between which heights (d below the eyes' middle) hair hangs ever more freely."""

HEAVY = (0.7, 2.1)
"""Between which heights it is ever slower."""

CROWN = (1.5, 2.05)
"""Between which heights (d above the eyes' middle) short hair stands ever more freely."""

TUFT = 0.6
"""How far short hair moves beside the tip of a long lock."""

LONG = 1.0
"""Hair that reaches lower (d) is long."""


def shares(places: Sequence[tuple[float, float]]) -> list[Share]:
    """The shares of all anchors of a face's hair, by where they lie (x, y in d from the eyes' middle, y down)."""
    long = max((y for _, y in places), default=0.0) > LONG
    return [_share(y, long) for _, y in places]


def _share(y: float, long: bool) -> Share:
    hangs, heavy = smooth(EARS, TIPS, y), smooth(*HEAVY, y)
    return hangs * heavy, hangs * (1.0 - heavy), 0.0 if long else TUFT * smooth(*CROWN, -y)


@dataclass(frozen=True, slots=True)
class Sway:
    """The anchors that sway, and how far (px) each lock moves them for a degree: array[lock, anchor, 1]."""

    rows: NDArray[np.intp]
    reach: Floats

    @classmethod
    def of(cls, rows: NDArray[np.intp], x: Floats, y: Floats, d: float) -> Sway:
        """The hair's anchors, `rows` of those at x, y (px from the eyes' middle)."""
        each = np.array(shares([(x[row] / d, y[row] / d) for row in rows.tolist()])).reshape(-1, len(LOCKS))
        moved = each.any(axis=1)
        return cls(rows[moved], REACH * d * each[moved].T[:, :, None])

    def move(self, x: Floats, y: Floats, named: dict[str, Floats]) -> None:
        """Moves anchors, array[anchor, frame], y down, by the channels `hair.*`, array[frame] each."""
        for lock, reach in zip(LOCKS, self.reach, strict=True):
            aside, up = named[f"hair.{lock}.x"], named[f"hair.{lock}.y"]
            if aside.any() or up.any():
                x[self.rows] += reach * aside
                y[self.rows] -= UPRIGHT * reach * up
