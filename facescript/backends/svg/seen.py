"""Frames of shapes to when each can be seen, and how far its edge may be off: what is hidden need not be written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.backends.svg.depth import depths, traced
from facescript.backends.svg.shading import edge_opacity, most_stretch, opaque
from facescript.rig.picture import Shape

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Ints = NDArray[np.int64]

MARGIN = 1.0
"""Pixels by which a shape may miss its clip, or lie under another, and is still taken as seen."""

WHILE = 2.0
"""Seconds: what is out of sight for less is not switched off, which costs more than drawing it."""

LEAST = 0.03
"""What is less opaque cannot be seen."""

SPARSE = 6
"""Of the places of an outline, how many apart those are that tell first whether it may be covered."""

AROUND = 2
"""Moments before and after it is seen in which a shape is still followed, while it fades."""

FAINT = 0.25
"""An edge this opaque or less is allowed to be off by more, so that it changes pixels as much as one this opaque."""

FAINTEST = 4.0
"""By how much more at most."""


@dataclass(frozen=True, slots=True)
class Sight:
    """What of some frames can be seen. `points` is array[moment, point, xy] in pixels, `columns` the points of each
    shape, `opacity` array[moment, shape]."""

    shapes: Sequence[Shape]
    columns: Sequence[Ints]
    points: Floats
    opacity: Floats

    def shown(self, times: Floats) -> Floats:
        """The opacity at the moments `times` (s); 0 where it is less than LEAST, and for as long as a shape is out of
        sight: its box misses the box of what clips it, or a later shape covers it."""
        shown = np.where(self.opacity < LEAST, 0.0, self.opacity)
        for number, shape in enumerate(self.shapes):
            if not shown[:, number].any():
                continue
            hidden = self._covered(number)
            if shape.clip:
                mine = self._outline(number)
                hidden |= self._missed(number, mine.min(axis=1), mine.max(axis=1)) > MARGIN
            shown[_lasting(hidden, times), number] = 0
        return shown

    def cut(self, number: int) -> bool:
        """Whether a shape ever comes near the edge of its clip; where not it can be drawn without, which is faster."""
        for place, shape in enumerate(self.shapes):
            if shape.id in self.shapes[number].clip:
                where, clip = self._places(number), self._outline(place)
                seen = self.opacity[:, number] >= LEAST
                boxed = (where.min(axis=1) > clip.min(axis=1)) & (where.max(axis=1) < clip.max(axis=1))
                if len(shape.contours) == 1 and boxed[seen].all():
                    return bool((depths(where[seen], clip[seen]) <= MARGIN).any())
        return bool(self.shapes[number].clip)

    def tolerances(self, number: int, spots: Floats, off: float) -> Floats:
        """How far spots (sums of the shape's points) may be off, array[moment, spot], where at least `off` is allowed:
        more where the shape is faint, and by as much as they are hidden outside of what clips it or under others; but
        not so far that a gradient, which fits its box, would be seen to change."""
        outline = self._outline(number)
        where, fill = spots @ outline, self.shapes[number].fill
        low, high = outline.min(axis=1), outline.max(axis=1)
        opacity = self.opacity[:, number, None] * edge_opacity(fill, where, low, high)
        allowed = off * FAINT / np.clip(opacity, FAINT / FAINTEST, FAINT)
        allowed = np.maximum(allowed, self._hidden(number, where) - MARGIN)
        return np.minimum(allowed, off + most_stretch(fill, (high - low).min(axis=1))[:, None])

    def _outline(self, number: int) -> Floats:
        return self.points[:, self.columns[number]]

    def _places(self, number: int) -> Floats:
        """Places along all contours of a shape, array[moment, place, xy]."""
        contours = self.shapes[number].contours
        return np.concatenate(
            [traced(self.points[:, each.first : each.first + each.count]) for each in contours], axis=1
        )

    def _covered(self, number: int) -> Bools:
        """The moments at which one later shape covers all of a shape."""
        where = self._places(number)
        covered = np.zeros(len(self.points), dtype=bool)
        for place, at in self._covers(number, where, whole=True):
            for some in (where[:, ::SPARSE], where):
                inside = depths(some[at], self._outline(place)[at]).min(axis=1) > MARGIN
                at = at[inside]
            covered[at] = True
        return covered

    def _hidden(self, number: int, where: Floats) -> Floats:
        """Pixels by which places array[moment, place, xy] of a shape lie outside of its clip or under a later shape;
        not positive where they may be seen."""
        hidden = np.full(where.shape[:2], -np.inf)
        clips = [place for place, shape in enumerate(self.shapes) if shape.id in self.shapes[number].clip]
        if clips and all(len(self.shapes[place].contours) == 1 for place in clips):
            hidden = np.min([-depths(where, self._outline(place)) for place in clips], axis=0)
        for place, at in self._covers(number, where, whole=False):
            outline = self._outline(place)[at]
            low, high = outline.min(axis=(0, 1)), outline.max(axis=(0, 1))
            near = np.flatnonzero(((where[at] > low) & (where[at] < high)).all(axis=2).any(axis=0))
            if len(near):
                here = np.ix_(at, near)
                hidden[here] = np.maximum(hidden[here], depths(where[here], outline))
        return hidden

    def _covers(self, number: int, where: Floats, whole: bool) -> Iterator[tuple[int, Ints]]:
        """The later shapes that may hide the places, all of them where it is to be `whole`, and at which moments."""
        low, high = (where.min(axis=1), where.max(axis=1))
        for place in range(number + 1, len(self.shapes)):
            cover = self.shapes[place]
            if len(cover.contours) > 1 or cover.clip or not opaque(cover.fill):
                continue
            outline = self._outline(place)
            first, last = outline.min(axis=1), outline.max(axis=1)
            apart = (low < first) | (high > last) if whole else (high < first) | (low > last)
            at = np.flatnonzero((self.opacity[:, place] == 1) & ~apart.any(axis=1))
            if len(at):
                yield place, at

    def _missed(self, number: int, low: Floats, high: Floats) -> Floats:
        """Pixels between boxes array[moment, xy] and the box of what clips a shape, the nearest of several."""
        gaps = []
        for place, shape in enumerate(self.shapes):
            if shape.id in self.shapes[number].clip:
                clip = self._outline(place)
                gaps.append(np.maximum(low - clip.max(axis=1), clip.min(axis=1) - high).max(axis=-1))
        return np.asarray(np.min(gaps, axis=0))


def _lasting(hidden: Bools, times: Floats) -> Bools:
    """The moments of those spells of hiding that last for WHILE, or to an end of the times."""
    edges = np.flatnonzero(np.diff(hidden.astype(np.int8), prepend=0, append=0)).reshape(-1, 2)
    lasting = np.zeros_like(hidden)
    for first, end in edges.tolist():
        lasting[first:end] = times[end - 1] - times[first] >= WHILE or first == 0 or end == len(times)
    return lasting


def around(seen: Bools) -> Bools:
    """The moments to follow a shape at: where it is seen, AROUND moments before and after, and both ends."""
    near: Bools = np.convolve(seen, np.ones(2 * AROUND + 1))[AROUND : AROUND + len(seen)] > 0
    near[[0, -1]] = True
    return near
