"""Sound at any rate, in blocks, to the same sound at the rate of the ear, as far as it is known by then."""

from __future__ import annotations

from math import ceil, gcd

import numpy as np

from facescript.live.hearing.activity import RATE, Samples
from facescript.speech.sound.resample import REACH, resampled


class Flow:
    """Makes of blocks what `resampled` makes of the whole; the newest few milliseconds wait for what comes after."""

    def __init__(self, rate: int) -> None:
        divisor = gcd(rate, RATE)
        self._rate = rate
        self._in, self._out = rate // divisor, RATE // divisor
        self._margin = ceil(REACH * max(1.0, rate / RATE)) + 1
        self._held: Samples = np.zeros(0, np.int16)
        self._made = 0

    def take(self, block: Samples) -> Samples:
        """What can be made with a further block."""
        if self._rate == RATE:
            return block
        self._held = np.concatenate([self._held, block])
        last = max((len(self._held) - self._margin) * self._out // self._in, self._made)
        made = resampled(self._held, self._rate, RATE, self._made, last)
        past = max(last * self._in // self._out - self._margin, 0) // self._in
        self._held, self._made = self._held[past * self._in :], last - past * self._out
        return np.clip(np.round(made), -32_768, 32_767).astype(np.int16)
