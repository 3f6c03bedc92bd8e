"""Numbers over time to few key frames: straight lines through them that never leave a given tolerance."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


class Swing:
    """A swing filter over many tracks in step (Elmeleegy and others 2009): each track is a run of columns that share
    their key frames, and a key frame is set as late as the tolerance of every column allows.

    `starts` are the first columns of the tracks; rows are in units of the quantum, so key values are whole numbers.
    `tolerance` is the farthest a line may be from a row, in the same units, half a quantum of rounding included.
    """

    def __init__(self, starts: Ints, columns: int, tolerance: float) -> None:
        self.starts = starts
        self.widths = np.diff(np.append(starts, columns))
        self.reach = tolerance - 0.5
        self.keys: list[list[tuple[float, Ints]]] = [[] for _ in starts]
        self.begun = False
        self.time = 0.0
        self.row: Floats = np.zeros(columns)

    def begin(self, time: float, row: Floats) -> None:
        """The first row: a key frame of every track."""
        self.begun = True
        self.anchor = np.rint(row)
        self.since = np.full(len(row), time)
        self.low = np.full(len(row), -np.inf)
        self.high = np.full(len(row), np.inf)
        for track in range(len(self.starts)):
            self._set(track, time)
        self.time, self.row = time, row

    def push(self, time: float, row: Floats) -> None:
        """The next row in time."""
        low, high = self._narrowed(time, row)
        broken = np.logical_or.reduceat(low > high, self.starts)
        if broken.any():
            self._commit(np.flatnonzero(broken))
            low, high = self._narrowed(time, row)
        self.low, self.high, self.time, self.row = low, high, time, row

    def finish(self) -> None:
        """The last row becomes a key frame of every track that moved since its last one."""
        self._commit(np.arange(len(self.starts)))

    def _narrowed(self, time: float, row: Floats) -> tuple[Floats, Floats]:
        span = time - self.since
        away = row - self.anchor
        return np.maximum(self.low, (away - self.reach) / span), np.minimum(self.high, (away + self.reach) / span)

    def _commit(self, tracks: Ints) -> None:
        """Set key frames of `tracks` at the last row and start their lines anew there."""
        columns = np.concatenate([np.arange(self.starts[t], self.starts[t] + self.widths[t]) for t in tracks])
        span = self.time - self.since[columns]
        slope = np.zeros(len(columns))
        np.divide(self.row[columns] - self.anchor[columns], span, out=slope, where=span > 0)
        slope = np.clip(slope, self.low[columns], self.high[columns])
        self.anchor[columns] = np.rint(self.anchor[columns] + slope * span)
        self.since[columns] = self.time
        self.low[columns], self.high[columns] = -np.inf, np.inf
        for track in tracks:
            self._set(int(track), self.time)

    def _set(self, track: int, time: float) -> None:
        first = self.starts[track]
        values = self.anchor[first : first + self.widths[track]].astype(np.int64)
        keys = self.keys[track]
        if len(keys) > 1 and np.array_equal(keys[-1][1], values) and np.array_equal(keys[-2][1], values):
            keys.pop()
        keys.append((time, values))
