"""Blocks of sound to when somebody begins to speak and when she has done, as it comes."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.speech.align.features import WINDOW, Floats, spectrum

Samples = NDArray[np.int16]

RATE, HOP = 16_000, 160
"""Samples a second, and of a frame (10 ms)."""

SIZE = round(WINDOW * RATE)

OPENS, HOLDS = 2.2, 1.2
"""Natural log power over the noise, in the best third of the bands, at which speech begins, and above which it goes on:
noise alone comes to about 0.8 of it."""

RISE, OF = 4, 6
"""Speech begins when so many of the last frames are loud: a click is shorter."""

HANG = 25
"""Frames of quiet after which she has done: longer than a plosive's closure, shorter than a pause between sentences."""

FALLS, LEARNS, HEALS = 0.2, 0.02, 0.002
"""Shares of the way to a frame that the noise's estimate goes: downwards, upwards in quiet, upwards in speech."""

BREATHLESS = 6 * RATE
"""Samples after which what sounds on without a pause is thought to be noise, and learned as such."""

FAINTEST = 4.0
"""Natural log power of a band, of 16-bit samples, that the noise is never thought to stay below."""

SMOOTH = 0.5
"""Share of the newest frame in the loudness: a single frame of noise is rough."""


@dataclass(frozen=True, slots=True)
class Turn:
    """Somebody begins to speak, or has done, at a sample of the sound: one that begins was seen to a little later."""

    begins: bool
    at: int


class Activity:
    """Follows the noise of each band of the ear, so that what always sounds (a fan, a hum) is not taken for speech."""

    def __init__(self) -> None:
        self._held = np.zeros(0, np.int16)
        self._at = 0
        self._noise: Floats | None = None
        self._bands: Floats | None = None
        self._loud: deque[bool] = deque(maxlen=OF)
        self._last = self._since = 0
        self.speaking = False

    def take(self, samples: Samples) -> Iterator[Turn]:
        """What begins and ends within the next stretch of the sound, whatever pieces it comes in."""
        sound = np.concatenate([self._held, samples])
        count = max((len(sound) - SIZE) // HOP + 1, 0)
        self._held = sound[count * HOP :]
        for bands in _frames(sound, count) if count else ():
            turn = self._framed(bands)
            self._at += HOP
            if turn is not None:
                yield turn

    def skip(self, count: int) -> None:
        """So many samples pass unheard, and nobody speaks in them; what the noise is stays known."""
        self._at += len(self._held) + count
        self._held = self._held[:0]
        self._hush()

    def _hush(self) -> None:
        self.speaking = False
        self._loud.clear()

    def _framed(self, bands: Floats) -> Turn | None:
        level = self._level(bands)
        self._loud.append(level > OPENS)
        if level > HOLDS:
            self._last = self._at
        if not self.speaking and sum(self._loud) >= RISE:
            self.speaking, self._since = True, self._at
            return Turn(True, self._at - (len(self._loud) - 1) * HOP)
        if self.speaking and self._at - self._last >= HANG * HOP:
            self._hush()
            return Turn(False, self._last + HOP)
        return None

    def _level(self, bands: Floats) -> float:
        """How loud a frame is over the noise, which is learned of it."""
        if self._noise is None or self._bands is None:
            self._noise = self._bands = np.maximum(bands, np.float32(FAINTEST))
        self._bands = self._bands + np.float32(SMOOTH) * (bands - self._bands)
        above = self._bands - self._noise
        best = np.partition(above, len(above) * 2 // 3)[len(above) * 2 // 3 :]
        up = HEALS if self.speaking and self._at - self._since < BREATHLESS else LEARNS
        step = np.where(above < 0, np.float32(FALLS), np.float32(up)) * above
        self._noise = np.maximum(self._noise + step, np.float32(FAINTEST))
        return float(best.mean())


def _frames(sound: Samples, count: int) -> Floats:
    """The bands of the frames that begin at each `HOP`: those of `spectrum` are centred on its hops."""
    half = SIZE // 2
    assert half == HOP
    return spectrum(sound[: (count - 1) * HOP + SIZE], RATE, HOP / RATE)[1 : count + 1]
