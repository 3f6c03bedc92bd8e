"""Spoken lines to what is heard in them: loudness, onsets, pitch. Of the sound alone, apart from the voice's events."""

from __future__ import annotations

import numpy as np
from bars import Floats

from facescript.speech.model import Spoken

WINDOW = 0.005
"""Seconds over which loudness is taken."""

HEARD = 0.02
"""The share of a line's greatest loudness from which it is heard: 34 dB below."""


def samples(spoken: Spoken) -> Floats:
    """The sound, -1..1."""
    return np.frombuffer(spoken.pcm, dtype="<i2").astype(np.float64) / 32768.0


def loudness(sound: Floats, rate: float, window: float = WINDOW) -> Floats:
    """Root mean square in a window that is centred on each sample."""
    width = max(1, round(window * rate))
    power = np.concatenate([[0.0], np.cumsum(sound**2)])
    last = np.minimum(np.arange(len(sound)) + width // 2 + 1, len(sound))
    first = np.maximum(np.arange(len(sound)) - (width - width // 2 - 1), 0)
    return np.sqrt(np.maximum(power[last] - power[first], 0.0) / (last - first))


def heard(spoken: Spoken) -> tuple[float, float]:
    """When a line is first and last heard, seconds from its start."""
    loud = loudness(samples(spoken), spoken.rate)
    found = np.flatnonzero(loud > HEARD * loud.max())
    return float(found[0] / spoken.rate), float(found[-1] / spoken.rate)


FRAME, HOP = 0.04, 0.01
"""Seconds of a window in which pitch is sought, and from one to the next."""

LOWEST, HIGHEST = 70.0, 420.0
"""Pitch in Hz."""

VOICED = 0.5
"""The share of a window's power that comes back a period later, from which it is voiced."""


def pitch(spoken: Spoken) -> tuple[Floats, Floats]:
    """Times (s from the line's start) and pitch (Hz, nan where the sound is not voiced), by autocorrelation."""
    rate, sound = spoken.rate, samples(spoken)
    width, hop = round(FRAME * rate), round(HOP * rate)
    windows = np.lib.stride_tricks.sliding_window_view(sound, width)[::hop]
    windows = (windows - windows.mean(axis=1, keepdims=True)) * np.hanning(width)
    power = np.abs(np.fft.rfft(windows, 2 * width)) ** 2
    echo = np.fft.irfft(power)[:, :width]
    taper = np.fft.irfft(np.abs(np.fft.rfft(np.hanning(width), 2 * width)) ** 2)[:width]
    share = echo / np.maximum(echo[:, :1], 1e-12) / (taper / taper[0] + 1e-9)
    first, last = round(rate / HIGHEST), round(rate / LOWEST)
    lags = first + _first_peaks(share[:, first:last])
    strength = share[np.arange(len(share)), lags]
    loud = np.sqrt((windows**2).mean(axis=1))
    voiced = (strength > VOICED) & (loud > 0.05 * loud.max())
    return (np.arange(len(share)) * hop + width / 2) / rate, np.where(voiced, rate / lags, np.nan)


def _first_peaks(share: Floats) -> np.ndarray:
    """Of each row the first place that comes near its greatest value: the period itself, not two of it."""
    near = share >= 0.9 * share.max(axis=1, keepdims=True)
    first = near.argmax(axis=1)
    best = [at + int(row[at : at + 12].argmax()) for at, row in zip(first, share, strict=True)]
    return np.array(best)
