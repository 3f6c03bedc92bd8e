"""Sound to what the ear makes of it: loudness in mel bands, frame by frame, and how it changes."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]
"""Frames in rows, bands in columns."""

WINDOW = 0.02
"""Seconds of a frame."""

BANDS, LOWEST, HIGHEST = 40, 60.0, 8000.0
"""Mel bands, and the hertz they span; a recording of a low rate has fewer."""

QUIETEST = 1.0
"""Power of a band, of 16-bit samples, that counts as silence: below it is only the rounding of samples."""

BLOCK = 16
"""Frames that are transformed at once: few enough that no matrix product starts threads, which cost more than they
give."""


def spectrum(samples: NDArray[np.int16], rate: int, hop: float) -> Floats:
    """The log power in each band, frame `n` centred on `n * hop` seconds."""
    size = round(WINDOW * rate)
    count = int(len(samples) / rate / hop) + 1
    padded = np.concatenate([np.zeros(size, np.int16), samples, np.zeros(size, np.int16)])
    windows = np.lib.stride_tricks.sliding_window_view(padded, size)
    starts = np.round(np.arange(count) * hop * rate).astype(np.int64) + size - size // 2
    length = 1 << (size - 1).bit_length()
    window, filters = _window(size), _filters(rate, length)
    found = np.empty((count, filters.shape[1]), np.float32)
    for at in range(0, count, BLOCK):
        frames = windows[starts[at : at + BLOCK]] * window
        power = np.fft.rfft(frames, length)
        found[at : at + BLOCK] = np.log(
            (np.square(power.real) + np.square(power.imag)).astype(np.float32, copy=False) @ filters + QUIETEST
        )
    return found


@lru_cache(maxsize=16)
def _window(size: int) -> Floats:
    window: Floats = np.hanning(size).astype(np.float32)
    window /= np.float32(np.sqrt(np.sum(window**2)))
    return window


@lru_cache(maxsize=16)
def _filters(rate: int, length: int) -> Floats:
    """Triangles, evenly over the mel scale: a spectrum's power to that of each band."""
    edges = np.linspace(_mel(LOWEST), _mel(HIGHEST), BANDS + 2)
    hertz = 700.0 * (np.exp(edges / 1127.0) - 1.0)
    hertz = hertz[hertz <= max(rate / 2, hertz[2])]
    bins = np.arange(length // 2 + 1) * rate / length
    rising = (bins[:, None] - hertz[None, :-2]) / np.diff(hertz)[None, :-1]
    falling = (hertz[None, 2:] - bins[:, None]) / np.diff(hertz)[None, 1:]
    filters = np.maximum(np.minimum(rising, falling), 0.0)
    shares: Floats = (filters / np.maximum(filters.sum(0), 1e-9)).astype(np.float32)
    return shares


def _mel(hertz: float) -> float:
    return float(1127.0 * np.log1p(hertz / 700.0))


def with_change(bands: Floats, reach: int) -> Floats:
    """The bands, each of mean 0 and deviation 1, and beside them their change over `reach` frames to both sides."""
    steady = (bands - bands.mean(0)) / (bands.std(0) + np.float32(0.1))
    ahead = np.concatenate([steady[reach:], np.repeat(steady[-1:], reach, 0)])[: len(steady)]
    behind = np.concatenate([np.repeat(steady[:1], reach, 0), steady[:-reach]])[: len(steady)]
    return np.concatenate([steady, ahead - behind], 1)
