"""Sound at one rate to the same sound at another: a sum of windowed sincs, exact for every ratio of whole numbers.

Each sample is a sum of its own in a fixed order, so that a stretch is the same bytes whatever else is asked for.
"""

from __future__ import annotations

from functools import lru_cache
from math import ceil, gcd

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

Floats = NDArray[np.float32]
Samples = NDArray[np.int16]

REACH = 48
"""Zeros of the sinc to either side that a sample is made of, at the lower of the two rates."""

BETA = 9.0
"""Of the Kaiser window: what is to be silent is 90 dB down."""

STEP = 4096
"""Samples made together: what they are made of stays near."""

EDGE = 0.94
"""Where the filter has fallen by half, as a part of half the lower rate: what lies beyond that half is silent."""


def resampled(sound: Samples, rate: int, wanted: int, first: int, last: int) -> Floats:
    """The samples `first` to `last` at `wanted` Hz of a sound at `rate` Hz; there is silence around the sound.

    Sample n is at second n / `wanted`: nothing is delayed. A pure function, and only what it needs of `sound` is read.
    """
    divisor = gcd(rate, wanted)
    up, down = wanted // divisor, rate // divisor
    weights = _filters(up, down)
    made = np.empty(last - first, dtype=np.float32)
    for begin in range(first, last, STEP):
        places, phases = np.divmod(np.arange(begin, min(begin + STEP, last)) * down, up)
        windows = _windows(sound, places - (weights.shape[1] // 2 - 1), weights.shape[1])
        made[begin - first : begin - first + len(places)] = (windows * weights[phases]).sum(axis=1)
    return made


def resampled_length(count: int, rate: int, wanted: int) -> int:
    """How many samples at `wanted` Hz last as long as `count` at `rate` Hz."""
    return round(count * wanted / rate)


def _windows(sound: Samples, starts: NDArray[np.int64], width: int) -> Floats:
    """`width` samples from each of `starts` on, which rise, array[start, tap]; there is silence around the sound."""
    first, last = int(starts[0]), int(starts[-1]) + width
    stretch = np.zeros(last - first, dtype=np.float32)
    begin, end = max(first, 0), min(last, len(sound))
    if end > begin:
        stretch[begin - first : end - first] = sound[begin:end]
    windows: Floats = sliding_window_view(stretch, width)[starts - first]
    return windows


@lru_cache(maxsize=16)
def _filters(up: int, down: int) -> Floats:
    """The weights of the samples around a place, array[phase, tap]: a phase is by how many `up`ths of a sample the
    place lies behind one, which has tap `width / 2 - 1`. Weights of a phase sum to 1."""
    slower = min(1.0, up / down)
    half = ceil(REACH / slower)
    offsets = np.arange(2 * half) - (half - 1) - np.arange(up)[:, None] / up
    window = np.i0(BETA * np.sqrt(np.clip(1.0 - np.square(offsets / half), 0.0, None)))
    weights = np.sinc(offsets * slower * EDGE) * window
    filters: Floats = (weights / weights.sum(axis=1, keepdims=True)).astype(np.float32)
    return filters
