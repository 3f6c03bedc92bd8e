"""One shape's outline over time to its key frames, a chunk of moments after another."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from facescript.backends.svg.carry import Carrier
from facescript.backends.svg.curves import Curves
from facescript.backends.svg.ease import Keys
from facescript.backends.svg.ground import SHADE
from facescript.backends.svg.limit import Edge
from facescript.backends.svg.seen import Sight, around
from facescript.backends.svg.slide import Slide

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Course:
    """The key frames of the shape number `place`, found so far.

    `columns` are its points, `off` how many pixels they may be off inside its carrier's group, `unit` the pixels of a
    whole number. What is `needed` even where it is not seen, as a clip is, is followed everywhere.
    """

    place: int
    columns: Ints
    carrier: Carrier
    off: float
    unit: float
    curves: Curves
    slide: Slide | None
    needed: bool
    keys: Keys = field(default_factory=Keys)

    def follow(self, chunk: Floats, sight: Sight, shown: Floats) -> None:
        """Go on through the moments of `sight`, at which it is `shown` so opaque."""
        kept = around((shown >= SHADE / 2) | self.needed)
        times = chunk[kept]
        mine = self.carrier.inside(times, sight.points[kept][:, self.columns], self.unit / 2)
        if self.slide:
            mine = self.slide.follow(times, mine, self.unit / 2)
        rows = (self.curves.map @ mine / self.unit).reshape(len(mine), -1)
        allowed = sight.tolerances(self.place, self.curves.spots, self.off)[kept]
        self.keys.follow(times, rows, Edge.of(self.curves, mine, allowed, self.unit))
