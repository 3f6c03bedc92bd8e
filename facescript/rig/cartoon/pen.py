"""Outlines that eye and mouth draw afresh in every pose: points over frames -> rows of the anchor table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from facescript.rig.cartoon.outline import POINTED, Loop

Floats = NDArray[np.float64]
Number = float | Floats
"""A number, the same in all frames, or array[frame]."""

Spot = tuple[Number, Number] | tuple[Number, Number, bool]
"""x, y in px from the eyes' middle, and whether the outline has a corner there."""

Stroke = tuple[Number, Number, Number] | tuple[Number, Number, Number, bool]
"""x, y, the stroke's width there, and whether it bends sharply."""


def lerp(a: Number, b: Number, t: Number) -> Number:
    return a + (b - a) * t


def step(low: float, high: float, value: Number) -> Floats:
    """0 below `low`, 1 above `high`, a smooth step between."""
    t = np.clip((np.asarray(value, dtype=np.float64) - low) / (high - low), 0.0, 1.0)
    smooth: Floats = t * t * (3 - 2 * t)
    return smooth


def soft_max(a: Number, b: Number, width: float) -> Number:
    """The greater of two, rounded off over about `width`; equal to 0 where both are 0."""
    difference = np.asarray(a) - b
    larger: Floats = (np.asarray(a) + b + np.sqrt(difference * difference + width * width) - width) / 2
    return larger


@dataclass
class Pen:
    """Collects loops by the id of the part they belong to, and opacities."""

    loops: dict[str, list[list[Spot]]] = field(default_factory=dict)
    opacity: dict[str, Number] = field(default_factory=dict)
    depth: dict[str, list[Number]] = field(default_factory=dict)

    def loop(self, part: str, points: Sequence[Spot], forward: Sequence[Number] = ()) -> None:
        """A closed outline; `forward` is how far each point stands out (px) of the part's own depth, for all of a
        part's outlines or for none."""
        self.loops.setdefault(part, []).append(list(points))
        if forward:
            self.depth.setdefault(part, []).extend(forward)

    def ribbon(self, part: str, points: Sequence[Stroke]) -> None:
        """A tapered stroke; an end whose width is a plain number under 0.02 is a point."""
        left: list[Spot] = []
        right: list[Spot] = []
        last = len(points) - 1
        for i, point in enumerate(points):
            x, y, width = point[0], point[1], point[2]
            before, after = points[max(i - 1, 0)], points[min(i + 1, last)]
            dx, dy = after[0] - before[0], after[1] - before[1]
            half = width / 2 / np.maximum(np.sqrt(dx * dx + dy * dy), 1e-6)
            sharp = i in (0, last) or len(point) > 3
            left.append((x - dy * half, y + dx * half, sharp))
            right.append((x + dy * half, y - dx * half, sharp))
        if _pointed(points[last]):
            right.pop()
        if _pointed(points[0]):
            right.pop(0)
        self.loop(part, left + right[::-1])

    def shift(self, ending: str, x: float, y: float) -> None:
        """Move all outlines of the parts whose ids end so."""
        if x == y == 0.0:
            return
        for part, loops in self.loops.items():
            if part.endswith(ending):
                for points in loops:
                    points[:] = [(spot[0] + x, spot[1] + y, len(spot) > 2 and bool(spot[2])) for spot in points]

    def outlines(self, part: str) -> tuple[Loop, ...]:
        """The loops of a part drawn in a single frame, as plain outlines."""
        return tuple(
            tuple((_number(spot[0]), _number(spot[1]), len(spot) > 2 and bool(spot[2])) for spot in points)
            for points in self.loops[part]
        )

    def write(self, part: str, x: Floats, y: Floats, forward: Floats) -> None:
        """Fill the part's rows [anchor, frame] of x, y and forward."""
        row = 0
        for points in self.loops[part]:
            for spot in points:
                x[row], y[row] = spot[0], spot[1]
                row += 1
        for row, value in enumerate(self.depth.get(part, ())):
            forward[row] = value


def _pointed(point: Stroke) -> bool:
    return isinstance(point[2], float) and point[2] < POINTED


def _number(value: Number) -> float:
    return float(np.asarray(value).reshape(-1)[0])
