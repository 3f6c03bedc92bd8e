"""Points and opacities of all shapes to ThorVG's outlines: what changed since the last frame, and where."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from facescript.canvas.box import Box, bands
from facescript.canvas.slant import Slants
from facescript.canvas.thorvg import Clipped, Outline
from facescript.rig.picture import Shape

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

GRID = 64.0
"""Steps a pixel: ThorVG rounds coordinates to them, so what stays on its step looks the same."""


class Outlines:
    """The outlines of a list of shapes and what they were in the last frame taken.

    A shape with clips is drawn inside the union of their outlines.
    """

    def __init__(self, shapes: Sequence[Shape]) -> None:
        rows = [_rows(shape) for shape in shapes]
        self._order = np.concatenate([np.zeros(0, dtype=np.intp), *rows])
        self._ends = np.cumsum([len(each) for each in rows], dtype=np.intp)
        self._starts = self._ends - np.array([len(each) for each in rows], dtype=np.intp)
        self._slants = Slants(shapes, self._starts)
        self._shapes = [Outline(_lengths([shape]), shape.fill) for shape in shapes]
        place = {shape.id: number for number, shape in enumerate(shapes)}
        self._reach = _reach([[place[name] for name in shape.clip] for shape in shapes])
        self._groups = [_Group(members, [place[name] for name in clip], shapes) for clip, members in _runs(shapes)]
        self._points = np.full((len(self._order), 2), np.nan, dtype=np.float32)
        self._levels = np.zeros(len(shapes), dtype=np.int64)
        self._stale = np.ones(len(shapes), dtype=bool)
        self._low = np.zeros((len(shapes), 2), dtype=np.float32)
        self._high = np.zeros((len(shapes), 2), dtype=np.float32)
        self._before = self._low, self._high, self._levels

    def paints(self) -> list[tuple[range, Outline | Clipped]]:
        """What a canvas draws, in order, and which shapes each paint holds: neighbours with one clip go together."""
        return [(group.members, group.paint(self._shapes)) for group in self._groups]

    def take(self, points: Floats, opacity: Floats, turns: Floats) -> Bools:
        """Take a frame, points array[point, 2] in px, opacity array[shape] and turns array[shape], by how many radians
        clockwise the frames of gradients are turned; which shapes look other than before."""
        self._before = self._low, self._high, self._levels
        fresh = (np.rint(points[self._order] * GRID) / GRID).astype(np.float32)
        moved = self._moved(fresh) | self._slants.take(turns)
        self._points = fresh
        self._levels = np.rint(255 * np.clip(opacity, 0.0, 1.0)).astype(np.int64)
        shaded = self._levels != self._before[2]
        # A new opacity needs a new outline too: ThorVG mixes it into a gradient's colours only then.
        self._stale |= moved | shaded
        self._push(shaded)
        touched: Bools = (moved | shaded) & ((self._levels > 0) | (self._before[2] > 0))
        return touched

    def touched_boxes(self, touched: Bools, whole: Box) -> tuple[Box, ...]:
        """Where the touched shapes were before the last frame and are now."""
        low, high, levels = self._before
        was, now = touched & (levels > 0), touched & (self._levels > 0)
        return bands(np.concatenate([low[was], self._low[now]]), np.concatenate([high[was], self._high[now]]), whole)

    def seen_boxes(self, first: int, whole: Box) -> tuple[Box, ...]:
        """Where the visible shapes from number `first` on are."""
        seen = self._levels > 0
        seen[:first] = False
        return bands(self._low[seen], self._high[seen], whole)

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
        for group in self._groups:
            if group.clip is not None and due[group.members].any():
                union = np.concatenate([self._points[self._starts[n] : self._ends[n]] for n in group.clips])
                group.clip.shape(union.ctypes.data)
        address, step = self._points.ctypes.data, self._points.strides[0]
        starts = (address + step * self._starts).tolist()
        places = self._slants.places(self._points, due)
        for number in np.flatnonzero(due).tolist():
            self._shapes[number].shape(starts[number], places.get(number, ()))
        self._stale &= ~due
        for number in np.flatnonzero(shaded).tolist():
            self._shapes[number].shade(int(self._levels[number]))


class _Group:
    """Neighbouring shapes with the same clip, which ThorVG then needs to work out once."""

    def __init__(self, members: range, clips: Sequence[int], shapes: Sequence[Shape]) -> None:
        self.members = members
        self.clips = clips
        self.clip = Outline(_lengths([shapes[number] for number in clips]), "#000000") if clips else None

    def paint(self, outlines: Sequence[Outline]) -> Outline | Clipped:
        own = outlines[self.members.start : self.members.stop]
        return Clipped(self.clip, own) if self.clip is not None else own[0]


def _runs(shapes: Sequence[Shape]) -> Iterator[tuple[tuple[str, ...], range]]:
    """Runs of shapes that are drawn as one: those with the same clip and the same `moving`, others alone."""
    at = 0
    for (clip, _, _), run in groupby(enumerate(shapes), lambda item: _kin(*item)):
        count = len(list(run))
        yield clip, range(at, at + count)
        at += count


def _kin(number: int, shape: Shape) -> tuple[tuple[str, ...], bool, int]:
    return shape.clip, shape.moving, -1 if shape.clip else number


def _rows(shape: Shape) -> NDArray[np.intp]:
    """The rows of the point array that a shape uses, contour after contour."""
    return np.concatenate([np.arange(each.first, each.first + each.count) for each in shape.contours])


def _lengths(shapes: Sequence[Shape]) -> list[int]:
    return [contour.count for shape in shapes for contour in shape.contours]


def _reach(clips: Sequence[Sequence[int]]) -> Bools:
    """array[shape, other]: whether a shape's look hangs on another's outline: its own, and its clips'."""
    reach = np.eye(len(clips), dtype=bool)
    for number, others in enumerate(clips):
        reach[number, list(others)] = True
    return reach
