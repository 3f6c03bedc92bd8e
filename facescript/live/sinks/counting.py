"""What all sinks share: frames at a rate, what was sent and dropped, and pauses that grow."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator

from facescript.live.model import Frame, Mark, Utterance

FIRST_PAUSE, LONGEST_PAUSE = 0.5, 15.0
"""Seconds between two tries to reach who is not there yet."""


class Counting:
    """A sink that takes `rate` frames a second (None: all), counts, and makes nothing of marks and utterances."""

    def __init__(self, rate: float | None = None) -> None:
        self._rate, self._slot = rate, -1
        self._counts: Counter[str] = Counter(sent=0, dropped=0)

    def due(self, frame: Frame) -> bool:
        """Whether a frame is sent: the first in each `1/rate` of the run."""
        if self._rate is None:
            return True
        slot = math.floor(frame.time * self._rate + 1e-6)
        due, self._slot = slot != self._slot, slot
        return due

    def mark(self, mark: Mark) -> None:
        """Nothing: the peer has no use for it."""

    def utter(self, utterance: Utterance) -> None:
        """Nothing: the peer has no use for it."""

    def counts(self) -> dict[str, int]:
        return dict(self._counts)


def pauses() -> Iterator[float]:
    """Seconds to wait before each next try, growing."""
    pause = FIRST_PAUSE
    while True:
        yield pause
        pause = min(2 * pause, LONGEST_PAUSE)
