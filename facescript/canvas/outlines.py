"""Points and opacities of all shapes to ThorVG's outlines: what changed since the last frame, and where."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.canvas.box import NOWHERE, Box
from facescript.canvas.thorvg import Outline
from facescript.rig.picture import Shape

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

GRID = 64.0
"""Steps a pixel: ThorVG rounds coordinates to them, so what stays on its step looks the same."""


class Outlines:
    """The outlines of a list of shapes and what they were in the last frame taken.

    `paints` are in the shapes' order. A shape with clips is drawn inside the union of their outlines.
    """

    def __init__(self, shapes: Sequence[Shape]) -> None:
        rows = [_rows(shape) for shape in shapes]
        self._order = np.concatenate(rows) if rows else np.zeros(0, dtype=np.intp)
        ends = np.cumsum([len(each) for each in rows], dtype=np.intp)
        self._starts = np.concatenate([[0], ends[:-1]]).astype(np.intp)[: len(shapes)]
        self._slices = [slice(int(end) - len(each), int(end)) for each, end in zip(rows, ends, strict=True)]
        place = {shape.id: number for number, shape in enumerate(shapes)}
        self._clips = [[place[name] for name in shape.clip] for shape in shapes]
        self._clip_paints = [_clip([shapes[number] for number in clips]) for clips in self._clips]
        self.paints = [
            Outline(_lengths([shape]), shape.fill, clip) for shape, clip in zip(shapes, self._clip_paints, strict=True)
        ]
        self._reach = _reach(self._clips)
        self._points = np.full((len(self._order), 2), np.nan, dtype=np.float32)
        self._levels = np.zeros(len(shapes), dtype=np.int64)
        self._stale = np.ones(len(shapes), dtype=bool)
        self._low = np.zeros((len(shapes), 2), dtype=np.float32)
        self._high = np.zeros((len(shapes), 2), dtype=np.float32)
        self._before = self._low, self._high, self._levels

    def take(self, points: Floats, opacity: Floats) -> Bools:
        """Take a frame, points array[point, 2] in px and opacity array[shape]; which shapes look other than before."""
        self._before = self._low, self._high, self._levels
        fresh = (np.rint(points[self._order] * GRID) / GRID).astype(np.float32)
        moved = self._moved(fresh)
        self._points = fresh
        self._levels = np.rint(255 * np.clip(opacity, 0.0, 1.0)).astype(np.int64)
        shaded = self._levels != self._before[2]
        # A new opacity needs a new outline too: ThorVG mixes it into a gradient's colours only then.
        self._stale |= moved | shaded
        self._push(shaded)
        touched: Bools = (moved | shaded) & ((self._levels > 0) | (self._before[2] > 0))
        return touched

    def touched_box(self, touched: Bools) -> Box:
        """Where the touched shapes were before the last frame and are now."""
        low, high, levels = self._before
        was, now = touched & (levels > 0), touched & (self._levels > 0)
        return _box(np.concatenate([low[was], self._low[now]]), np.concatenate([high[was], self._high[now]]))

    def seen_box(self, first: int) -> Box:
        """Where the visible shapes from number `first` on are."""
        seen = self._levels > 0
        seen[:first] = False
        return _box(self._low[seen], self._high[seen])

    def _moved(self, fresh: NDArray[np.float32]) -> Bools:
        """Which shapes or their clips moved; keeps the boxes of all outlines."""
        if not len(self._starts):
            return np.zeros(0, dtype=bool)
        differs = (fresh != self._points).any(axis=1)
        moved = np.logical_or.reduceat(differs, self._starts)
        self._low = np.minimum.reduceat(fresh, self._starts, axis=0)
        self._high = np.maximum.reduceat(fresh, self._starts, axis=0)
        return np.asarray(self._reach @ moved)

    def _push(self, shaded: Bools) -> None:
        """Give ThorVG what it needs to draw the visible shapes."""
        due = self._stale & (self._levels > 0)
        for number in np.flatnonzero(due).tolist():
            clip = self._clip_paints[number]
            if clip is not None:
                clip.shape(np.concatenate([self._points[self._slices[other]] for other in self._clips[number]]))
            self.paints[number].shape(self._points[self._slices[number]])
        self._stale &= ~due
        for number in np.flatnonzero(shaded).tolist():
            self.paints[number].shade(int(self._levels[number]))


def _rows(shape: Shape) -> NDArray[np.intp]:
    """The rows of the point array that a shape uses, contour after contour."""
    return np.concatenate([np.arange(each.first, each.first + each.count) for each in shape.contours])


def _lengths(shapes: Sequence[Shape]) -> list[int]:
    return [contour.count for shape in shapes for contour in shape.contours]


def _clip(shapes: Sequence[Shape]) -> Outline | None:
    return Outline(_lengths(shapes), "#000000") if shapes else None


def _reach(clips: Sequence[Sequence[int]]) -> Bools:
    """array[shape, other]: whether a shape's look hangs on another's outline: its own, and its clips'."""
    reach = np.eye(len(clips), dtype=bool)
    for number, others in enumerate(clips):
        reach[number, list(others)] = True
    return reach


def _box(low: NDArray[np.float32], high: NDArray[np.float32]) -> Box:
    """The whole pixels that outlines between these corners can touch."""
    if not len(low):
        return NOWHERE
    left, top = np.floor(low.min(axis=0)).astype(int).tolist()
    right, bottom = np.ceil(high.max(axis=0)).astype(int).tolist()
    return Box(left - 1, top - 1, right + 1, bottom + 1)
