"""Frames of a recording and of voices to which frame of each voice is heard in each of the recording.

Every frame of the recording goes on by 0 to 3 frames of the voice, so that a row of costs follows from the row before
it at once, without the diagonals of the usual way, and each frame counts once, however fast somebody speaks.
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

UNSAID = 0.12
"""What a frame of the voice costs that is left out at the start or at the end: a recording may lack words there."""

FAR = np.float32(1e9)

PRODUCTS = 200_000
"""Multiplications of one matrix product: more start threads, which cost more than they give."""

AT_ONCE = 8
"""Rows whose distances are found at once, at most."""


@dataclass(frozen=True, slots=True)
class Warp:
    """`path` has the voice's frame for each frame of the recording, never backwards; `distances` how unlike they are:
    about 0.8 where they say the same, 1 and more where not."""

    path: Indices
    distances: Floats


def warp(recording: Floats, voices: Floats, reach: int, centre: Indices | None = None) -> tuple[Warp, ...]:
    """The cheapest way of each of the `voices` (by voice, frame and column), at most `reach` frames from `centre`, or
    else from where the first is best so far; the recording has the same columns."""
    count, length = voices.shape[:2]
    band = min(2 * reach + 1, length)
    firsts = np.zeros(len(recording), np.int64)
    if centre is not None:
        firsts = np.maximum.accumulate(np.clip(centre - reach, 0, length - band))
    came = np.zeros((len(recording), count, band), np.int8)
    near = _Near(recording, voices, band)
    total = np.repeat(np.arange(firsts[0], firsts[0] + band, dtype=np.float32)[None] * np.float32(UNSAID), count, 0)
    for row in range(len(recording)):
        if row:
            if centre is None:
                best = int(firsts[row - 1] + total[0].argmin()) - reach
                firsts[row] = min(max(int(firsts[row - 1]), best), int(firsts[row - 1]) + LEAPS, length - band)
            total = _on(total, int(firsts[row] - firsts[row - 1]), came[row])
        total += near.distances(row, int(firsts[row]))
    total += (length - 1 - firsts[-1] - np.arange(band)) * np.float32(UNSAID)
    paths = [_back(int(total[each].argmin()), firsts, came[:, each]) for each in range(count)]
    return tuple(Warp(path, _distances(recording, voice[path])) for path, voice in zip(paths, voices, strict=True))


class _Near:
    """Distances of a frame of the recording to the frames of the voices in the band, found for several rows at once."""

    def __init__(self, recording: Floats, voices: Floats, band: int) -> None:
        self._recording, self._voices, self._band = recording, voices, band
        self._squares, self._own = np.square(voices).sum(2), np.square(recording).sum(1)
        self._share = np.float32(1 / voices.shape[2])
        self._rows = max(min(PRODUCTS // (band * voices.shape[2]), AT_ONCE), 1)
        self._found: Floats = np.empty((0, 0, 0), np.float32)
        self._row = self._first = 0

    def distances(self, row: int, first: int) -> Floats:
        """Root of the mean square over the columns, by voice and frame."""
        at = first - self._first
        if row - self._row >= len(self._found) or at + self._band > self._found.shape[2]:
            self._find(row, first)
            at = 0
        found: Floats = self._found[row - self._row, :, at : at + self._band]
        return found

    def _find(self, row: int, first: int) -> None:
        last = first + self._band + LEAPS * self._rows
        rows = self._recording[row : row + self._rows]
        products = np.matmul(rows[None], self._voices[:, first:last].transpose(0, 2, 1)).transpose(1, 0, 2)
        squares = self._squares[:, first:last] - 2 * products + self._own[row : row + self._rows, None, None]
        self._found, self._row, self._first = np.sqrt(np.maximum(squares * self._share, 0)), row, first


def _on(total: Floats, moved: int, came: NDArray[np.int8]) -> Floats:
    """The least cost of each place of the next row, which begins `moved` frames later; by how many it went on is put
    into `came`."""
    count, band = total.shape
    before = np.empty((count, band + moved + LEAPS), np.float32)
    before[:, :LEAPS] = FAR
    before[:, LEAPS : LEAPS + band] = total
    before[:, LEAPS + band :] = FAR
    best = before[:, LEAPS + moved :] + np.float32(TOLLS[0])
    for leap in range(1, LEAPS + 1):
        option = before[:, LEAPS + moved - leap : LEAPS + moved - leap + band] + np.float32(TOLLS[leap])
        np.copyto(came, leap, where=option < best)
        np.minimum(best, option, out=best)
    return best


def _back(at: int, firsts: Indices, came: NDArray[np.int8]) -> Indices:
    """The way that ends at place `at` of the last row."""
    path = np.empty(len(firsts), np.int64)
    place = at + int(firsts[-1])
    for row in range(len(firsts) - 1, -1, -1):
        path[row] = place
        place -= int(came[row, place - int(firsts[row])])
    return path


def _distances(recording: Floats, voice: Floats) -> Floats:
    found: Floats = np.sqrt(np.square(recording - voice).mean(1))
    return found
