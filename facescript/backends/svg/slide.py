"""An outline that moves as a whole to a translation of its own: what slides need not be written point by point."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from facescript.backends.svg.ease import Keys
from facescript.backends.svg.limit import Apart

Floats = NDArray[np.float64]

FAR = 0.5
"""Pixels: what moves less as a whole does not slide."""

BENT = 0.6
"""How much an outline may change its form, beside how far it moves, and still slide."""

OFF = 0.8
"""Quanta that a translation may be off; outlines must make good what more it is."""


@dataclass(frozen=True, slots=True)
class Slide:
    """Where the middle of one shape's points is over time, in quanta."""

    keys: Keys = field(default_factory=Keys)

    @classmethod
    def of(cls, poses: Floats) -> Slide | None:
        """A slide for outlines array[pose, point, xy] in pixels, where they are such that it pays."""
        middles = poses.mean(axis=1)
        moved = np.linalg.norm(middles - middles.mean(axis=0), axis=1)
        form = poses - middles[:, None]
        bent = np.linalg.norm(form - form.mean(axis=0), axis=2).max(axis=1)
        return cls() if moved.max() > FAR and bent.mean() <= BENT * moved.mean() else None

    def follow(self, times: Floats, points: Floats, quantum: float) -> Floats:
        """Go on through more moments; gives points array[moment, point, xy], px, as they stand beside the slide."""
        middles = points.mean(axis=1) / quantum
        self.keys.follow(times, middles, Apart(middles, OFF))
        beside: Floats = points - self.keys.at(times)[:, None] * quantum
        return beside
