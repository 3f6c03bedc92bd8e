"""Loudness in bands to where somebody speaks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.speech.align.features import Floats

QUIET_SHARE, LOUD_SHARE = 0.05, 0.95
"""The shares of frames below which it is quiet, and above which somebody speaks loudly."""

RANGE = 2.0
"""Natural log power between quiet and loud: with less there is no telling, and all of it is speech."""

OPENS, HOLDS = 0.3, 0.18
"""Shares of the range, over the noise, at which speech begins, and above which it goes on."""

SHORTEST, GAP = 0.05, 0.1
"""Seconds: a shorter sound is a click, a shorter gap is a plosive's closure."""

BREATH = 0.02
"""Seconds before the first and after the last loud frame that belong to speech as well."""

SILENT = 3.0
"""Natural log power of a band, of 16-bit samples, that nobody's voice stays below."""


@dataclass(frozen=True, slots=True)
class Stretch:
    """Seconds `start` to `end` of a recording."""

    start: float
    end: float

    @property
    def length(self) -> float:
        return self.end - self.start


def speaking(bands: Floats, hop: float) -> tuple[Stretch, ...]:
    """Where somebody speaks, in order, apart by `GAP` at least; `bands` are log powers, a frame each `hop` seconds."""
    level = _level(bands)
    if not len(level):
        return ()
    quiet, loud = np.quantile(level, (QUIET_SHARE, LOUD_SHARE))
    if loud < SILENT:
        return ()
    if loud - quiet < RANGE:
        return (Stretch(0.0, len(level) * hop),)
    opened = level > quiet + OPENS * (loud - quiet)
    held = level > quiet + HOLDS * (loud - quiet)
    runs = [(first, last) for first, last in _runs(held) if opened[first:last].any()]
    return _joined(runs, hop, len(level))


def _level(bands: Floats) -> Floats:
    """How loud each frame is where it is loudest over the noise: the mean of the best third of its bands."""
    count = max(bands.shape[1] // 3, 1)
    noise = np.quantile(bands, 0.1, axis=0) if len(bands) else np.zeros(bands.shape[1])
    above = bands - np.minimum(noise, bands.mean(0) if len(bands) else 0).astype(np.float32)
    strongest = np.partition(above, above.shape[1] - count, axis=1)[:, -count:]
    level: Floats = strongest.mean(1) + np.float32(noise.mean())
    return level


def _runs(flags: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and one past the last frame of each run of true flags."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    return [(int(first), int(last)) for first, last in edges.reshape(-1, 2)]


def _joined(runs: list[tuple[int, int]], hop: float, count: int) -> tuple[Stretch, ...]:
    """Runs as stretches: short gaps between them closed, clicks left out."""
    found: list[list[float]] = []
    for first, last in runs:
        start, end = max(first * hop - BREATH, 0.0), min(last * hop + BREATH, count * hop)
        if found and start - found[-1][1] < GAP:
            found[-1][1] = end
        else:
            found.append([start, end])
    return tuple(Stretch(start, end) for start, end in found if end - start >= SHORTEST + 2 * BREATH)
