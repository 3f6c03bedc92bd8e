"""Frames of a recording and of a voice to which frame of the voice is heard in each of the recording.

Every frame of the recording goes on by 0 to 3 frames of the voice, so that a row of costs follows from the row before it
at once, without the diagonals of the usual way, and each frame counts once, however fast somebody speaks.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.speech.align.features import Floats

Indices = NDArray[np.int64]

TOLLS = (0.15, 0.0, 0.15, 0.375)
"""What it costs to go on by 0, 1, 2 and 3 frames, as distances: a voice as fast as the recording costs nothing."""

LEAPS = len(TOLLS) - 1

UNSAID = 0.05
"""What a frame of the voice costs that is left out at the start or at the end: a recording may lack words there."""

FAR = np.float32(1e9)
ROWS = 64
"""Rows whose distances are found at once."""


@dataclass(frozen=True, slots=True)
class Warp:
    """`path` has the voice's frame for each frame of the recording, never backwards; `distances` how unlike they are:
    about 0.8 where they say the same, 1 and more where not."""

    path: Indices
    distances: Floats


def warp(recording: Floats, voice: Floats, reach: int, centre: Indices | None = None) -> Warp:
    """The cheapest way through, at most `reach` frames of the voice from `centre`, or else from where it is best so
    far; both have the same columns."""
    band = min(2 * reach + 1, len(voice))
    last = len(voice) - band
    firsts = np.zeros(len(recording), np.int64)
    costs = np.empty((len(recording), band), np.float32)
    came = np.zeros((len(recording), band), np.int8)
    if centre is not None:
        firsts = np.maximum.accumulate(np.clip(centre - reach, 0, last))
    total = np.arange(firsts[0], firsts[0] + band, dtype=np.float32) * np.float32(UNSAID)
    rows = _Rows(recording, voice)
    for row in range(len(recording)):
        if row and centre is None:
            firsts[row] = min(max(firsts[row - 1], firsts[row - 1] + int(total.argmin()) - reach), last)
        if row:
            total, came[row] = _on(total, int(firsts[row] - firsts[row - 1]))
        costs[row] = rows.distances(row, int(firsts[row]), band)
        total += costs[row]
    total += (len(voice) - 1 - firsts[-1] - np.arange(band)) * np.float32(UNSAID)
    return _back(int(total.argmin()), firsts, costs, came)


class _Rows:
    """Distances of a frame of the recording to a stretch of the voice's frames."""

    def __init__(self, recording: Floats, voice: Floats) -> None:
        self._recording, self._voice = recording, voice
        self._squares = np.square(voice).sum(1)
        self._own = np.square(recording).sum(1)
        self._share = np.float32(1 / voice.shape[1])

    def distances(self, row: int, first: int, band: int) -> Floats:
        """Root of the mean square over the columns."""
        products = self._voice[first : first + band] @ self._recording[row]
        squares = self._squares[first : first + band] - 2 * products
        found: Floats = np.sqrt(np.maximum((squares + self._own[row]) * self._share, 0))
        return found


def _on(total: Floats, moved: int) -> tuple[Floats, NDArray[np.int8]]:
    """The least cost of each place of the next row, and by how many frames it went on; the row begins `moved` later."""
    band = len(total)
    before = np.full(band + moved + LEAPS, FAR, np.float32)
    before[LEAPS : LEAPS + band] = total
    best = before[LEAPS + moved : LEAPS + moved + band] + np.float32(TOLLS[0])
    came = np.zeros(band, np.int8)
    for leap in range(1, LEAPS + 1):
        option = before[LEAPS + moved - leap : LEAPS + moved - leap + band] + np.float32(TOLLS[leap])
        came[option < best] = leap
        np.minimum(best, option, out=best)
    return best, came


def _back(at: int, firsts: Indices, costs: Floats, came: NDArray[np.int8]) -> Warp:
    """The way that ends at place `at` of the last row."""
    path = np.empty(len(firsts), np.int64)
    distances = np.empty(len(firsts), np.float32)
    place = at + int(firsts[-1])
    for row in range(len(firsts) - 1, -1, -1):
        at = place - int(firsts[row])
        path[row], distances[row] = place, costs[row, at]
        place -= int(came[row, at])
    return Warp(path, distances)
