"""When phones are heard to when they begin as people label them: a plosive with its closure, others where the sound
changes most."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.speech.align.features import spectrum
from facescript.speech.mandarin.syllables import PREFIX
from facescript.speech.model import PhoneTime
from facescript.speech.timing.times import is_plosive

HOP = 0.005
"""Seconds from frame to frame."""

AFFRICATES = ("tʃ", "dʒ", "ts", "dz", "tɕ", "dʑ", "pf")

LONGEST_CLOSURE = 0.12
"""Seconds."""

DIP = 1.0
"""Natural log power by which a closure is quieter than what is before it."""

SPAN = 0.06
"""Seconds on either side of an edge that are weighed."""

REACH = 0.03
"""Seconds that an edge may move."""

PULL = 0.3
"""What a move of 10 ms costs, in mean square deviations of a frame."""


class Edges:
    """A recording's stretch, `samples` at `rate` from `start` seconds on, and where phones begin in it."""

    def __init__(self, samples: NDArray[np.int16], rate: int, start: float) -> None:
        self._start = start
        bands = spectrum(samples, rate, HOP)
        self._level = np.log(np.exp(bands).sum(1))
        steady = (bands - bands.mean(0)) / (bands.std(0) + np.float32(0.1))
        zero = np.zeros((1, bands.shape[1]))
        self._sums = np.concatenate([zero, np.cumsum(steady, axis=0, dtype=np.float64)])
        self._squares = np.concatenate([[0.0], np.cumsum(np.square(steady).mean(1), dtype=np.float64)])

    def labelled(self, phones: Sequence[PhoneTime]) -> list[float]:
        """When each phone begins, in seconds of the recording, never before the one before it."""
        starts: list[float] = []
        for number, phone in enumerate(phones):
            before = phones[number - 1].start if number else phone.start - SPAN
            start = phone.start
            if phone.symbol.startswith(PREFIX):
                pass  # a mouth shape, not a sound
            elif number and _is_closed(phone) and phones[number - 1].symbol:
                start = self._closure(before, phone.start)
            elif phone.symbol:
                start = self._change(before, phone.start, phone.end)
            starts.append(max(start, starts[-1]) if starts else start)
        return starts

    def _closure(self, before: float, burst: float) -> float:
        """When it grows quiet before a burst: halfway down from the loudest to the quietest after `before`."""
        first, last = self._frame(max(before, burst - LONGEST_CLOSURE)), self._frame(burst + HOP)
        level = self._level[first : last + 1]
        if len(level) < 3:
            return burst
        quiet = int(level.argmin())
        loudest, quietest = float(level[: quiet + 1].max()), float(level[quiet])
        if loudest - quietest < DIP:
            return burst
        half = (loudest + quietest) / 2
        at = quiet
        while at and level[at - 1] < half:
            at -= 1
        share = float(half - level[at]) / float(level[at - 1] - level[at]) if at else 0.0
        return self._start + (first + at - share) * HOP

    def _change(self, before: float, edge: float, after: float) -> float:
        """The moment near `edge` that parts what is before it and after it into two even sounds best."""
        first, last = self._frame(max(before, edge - SPAN)), self._frame(min(after, edge + SPAN))
        cuts = np.arange(first + 1, last)
        moments = self._start + (cuts - 0.5) * HOP
        near = np.abs(moments - edge) <= REACH
        cuts, moments = cuts[near], moments[near]
        if not len(cuts):
            return edge
        cost = self._scatter(np.full_like(cuts, first), cuts) + self._scatter(cuts, np.full_like(cuts, last))
        return float(moments[int((cost + PULL * np.square((moments - edge) / 0.01)).argmin())])

    def _scatter(self, first: NDArray[np.int64], last: NDArray[np.int64]) -> NDArray[np.float64]:
        """The squared deviations of the frames `first` to `last` from their mean, over the bands."""
        sums = self._sums[last] - self._sums[first]
        scatter: NDArray[np.float64] = (
            self._squares[last] - self._squares[first] - np.square(sums).mean(1) / (last - first)
        )
        return scatter

    def _frame(self, moment: float) -> int:
        return min(max(round((moment - self._start) / HOP), 0), len(self._level) - 1)


def _is_closed(phone: PhoneTime) -> bool:
    """Whether it begins with a closure: a plosive, or an affricate."""
    return is_plosive(phone) or phone.symbol.startswith(AFFRICATES)
