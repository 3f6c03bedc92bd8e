"""Parts and their outlines at rest -> one table of anchors, and the constant map from anchors to a picture's points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.rig.cartoon.outline import Depths, Loop, Part, spine
from facescript.rig.cartoon.spline import Term, handle_map
from facescript.rig.picture import Contour

Floats = NDArray[np.float64]
Loops = Mapping[str, Sequence[Loop]]
"""Outlines by part."""

WARY = 0.5
"""How wary corners of eye and mouth are (`spline.handle_map`): their neighbours move past one another."""


@dataclass(frozen=True, slots=True)
class Table:
    """Anchors of all parts, and each point of the picture as a sum of at most three of them.

    `x`, `y` are the anchors at rest (px), `middle` where their depth is taken, `deep` their own depths,
    `rows` and `contours` each part's share; `source` and `weight` are array[3, point] and array[3, point, 1].
    """

    x: Floats
    y: Floats
    middle: tuple[tuple[float, float], ...]
    owner: tuple[tuple[str, str], ...]
    deep: Depths
    rows: dict[str, slice]
    contours: dict[str, tuple[Contour, ...]]
    source: NDArray[np.intp]
    weight: Floats

    def points(self, values: Floats) -> Floats:
        """The picture's points array[point, frame] of one coordinate of the anchors array[anchor, frame]."""
        total: Floats = values[self.source[0]] * self.weight[0]
        total += values[self.source[1]] * self.weight[1]
        total += values[self.source[2]] * self.weight[2]
        return total


def build(parts: Sequence[Part], rest: Loops, fit: Loops, bare: str = "") -> Table:
    """The table of `parts` with outlines `rest`; handles are fitted where the anchors are in `fit`.

    Parts of the group `bare` have anchors only: they are moved, and not drawn.
    """
    spots: list[tuple[float, float]] = []
    middle: list[tuple[float, float]] = []
    owner: list[tuple[str, str]] = []
    deep: list[float | None] = []
    terms: list[tuple[Term, ...]] = []
    rows: dict[str, slice] = {}
    contours: dict[str, tuple[Contour, ...]] = {}
    for part in parts:
        wary = 0.0 if part.loops else WARY
        begin = len(spots)
        mine = []
        for outline, fitted in zip(rest[part.id], fit[part.id], strict=True):
            first, base = len(terms), len(spots)
            spots += [(x, y) for x, y, _ in outline]
            middle += spine(outline)
            terms += _path(fitted, base, wary) if part.group != bare else []
            mine.append(Contour(first, len(terms) - first))
        rows[part.id] = slice(begin, len(spots))
        contours[part.id] = tuple(mine)
        owner += [(part.id, part.depth)] * (len(spots) - begin)
        own = [depth for depths in part.depths for depth in depths] or [None] * (len(spots) - begin)
        deep += [part.z if depth is None else depth for depth in own]
    x, y = (np.array(column, dtype=np.float64) for column in zip(*spots, strict=True))
    source, weight = _padded(terms)
    return Table(x, y, tuple(middle), tuple(owner), tuple(deep), rows, contours, source, weight)


def _path(outline: Loop, base: int, wary: float) -> list[tuple[Term, ...]]:
    """Start, then handle, handle, anchor of each segment, as sums of the table's anchors."""
    points: list[tuple[Term, ...]] = [((base, 1.0),)]
    for i, pair in enumerate(handle_map(outline, wary)):
        points += [tuple((base + k, w) for k, w in handle) for handle in pair]
        points.append(((base + (i + 1) % len(outline), 1.0),))
    return points


def _padded(terms: Sequence[tuple[Term, ...]]) -> tuple[NDArray[np.intp], Floats]:
    source = np.zeros((3, len(terms)), dtype=np.intp)
    weight = np.zeros((3, len(terms), 1))
    for column, term in enumerate(terms):
        for k in range(3):
            anchor, share = term[k] if k < len(term) else (term[0][0], 0.0)
            source[k, column], weight[k, column, 0] = anchor, share
    return source, weight
