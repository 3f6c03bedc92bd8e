"""Spoken lines made by hand: a hum whose F0 and loudness are known, with phones over it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.speech.model import PhoneTime, Spoken, WordTime

Floats = NDArray[np.float64]

RATE = 22_050
SYLLABLE = 0.2
"""Seconds of each phone."""


def bump(times: Floats, middle: float) -> Floats:
    """From 0 to 1 and back within a syllable around `middle` seconds."""
    return np.exp(-0.5 * np.square((times - middle) / (SYLLABLE / 4.0)))


def hum(
    seconds: float, higher: dict[float, float] | None = None, louder: dict[float, float] | None = None,
    stressed: tuple[int, ...] = (), symbol: str = "m", text: str = "hum"
) -> Spoken:  # fmt: skip
    """A voice at 120 Hz that is so many semitones `higher` and dB `louder` around moments (seconds)."""
    times = np.arange(round(seconds * RATE)) / RATE
    tones = sum((up * bump(times, at) for at, up in (higher or {}).items()), np.zeros(len(times)))
    level = sum((up * bump(times, at) for at, up in (louder or {}).items()), np.zeros(len(times)))
    phase = 2.0 * np.pi * np.cumsum(120.0 * 2.0 ** (tones / 12.0)) / RATE
    wave = 0.1 * 10.0 ** (level / 20.0) * sum(np.sin(number * phase) / number for number in (1, 2, 3, 4))
    phones = tuple(
        PhoneTime(symbol, index * SYLLABLE, (index + 1) * SYLLABLE, index in stressed)
        for index in range(round(seconds / SYLLABLE))
    )
    pcm = (np.clip(wave, -1.0, 1.0) * 32767.0).astype("<i2").tobytes()
    return Spoken(pcm, RATE, seconds, (WordTime(text, 0, len(text), 0.0, seconds),), phones)
