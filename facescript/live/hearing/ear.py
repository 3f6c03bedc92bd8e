"""The sound of a room, as it comes, to the phrases that are said in it, each told once its speaker has done."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from facescript.live.hearing.activity import BREATHLESS, HANG, HOP, RATE, Activity, Samples

BEFORE = round(0.2 * RATE)
"""Samples before the first loud frame that belong to speech as well: its first sound may be faint."""

BEHIND = round(0.1 * RATE)
"""Samples behind the last loud frame that are listened to."""


DEAF = 1 << 31
"""The bit of a length that says that so many samples are passed over (`program.py`)."""


class Recogniser(Protocol):
    """Listens to one utterance after another."""

    def begin(self) -> None: ...

    def take(self, sound: Samples) -> None:
        """More of the utterance, mono at 16,000 samples a second."""
        ...

    def end(self) -> tuple[str, float] | None:
        """The phrase that was said, and how sure that is, 0 to 1; None where there is nothing like one."""
        ...


@dataclass(frozen=True, slots=True)
class Heard:
    """A phrase, said from `start` to `end`, s of the sound; `confidence` is 0 to 1."""

    text: str
    confidence: float
    start: float
    end: float


@dataclass(slots=True)
class Ear:
    """Listens to sound in blocks of any length. `counts` are utterances by what became of them."""

    recogniser: Recogniser
    least: float
    counts: dict[str, int] = field(default_factory=lambda: dict.fromkeys(("heard", "unsure", "long", "deaf"), 0))
    _activity: Activity = field(default_factory=Activity)
    _past: Samples = field(default_factory=lambda: np.zeros(0, np.int16))
    _end: int = 0
    _begun: int | None = None
    _told: int = 0

    def listen(self, sound: Samples) -> Iterator[Heard]:
        """What is heard once the next block is there."""
        for first in range(0, len(sound), HOP):
            block = sound[first : first + HOP]
            self._past = np.concatenate([self._past, block])[-(BEFORE + (HANG + 2) * HOP) :]
            self._end += len(block)
            for turn in self._activity.take(block):
                if turn.begins:
                    self._begin(turn.at)
                else:
                    yield from self._over(turn.at)
            self._go_on()

    def deaf(self, count: int) -> None:
        """Passes over so many samples, and over what is being said: the face itself is speaking."""
        if self._begun is not None:
            self.counts["deaf"] += 1
            self.recogniser.end()
        self._begun, self._past = None, self._past[:0]
        self._end += count
        self._activity.skip(count)

    def _begin(self, at: int) -> None:
        self._begun = self._told = max(at - BEFORE, self._end - len(self._past))
        self.recogniser.begin()

    def _go_on(self) -> None:
        """Hand on what is sure to belong to the utterance; the rest may be the quiet behind it."""
        if self._begun is None:
            return
        if self._end - self._begun > BREATHLESS:
            self.counts["long"] += 1
            self.recogniser.end()
            self._begun = None
            return
        self._hand_on(self._end - HANG * HOP + BEHIND)

    def _hand_on(self, until: int) -> None:
        begin = self._end - len(self._past)
        if until > self._told:
            self.recogniser.take(self._past[self._told - begin : until - begin])
            self._told = until

    def _over(self, at: int) -> Iterator[Heard]:
        if self._begun is None:
            return
        self._hand_on(min(at + BEHIND, self._end))
        start, self._begun = self._begun, None
        found = self.recogniser.end()
        if found is None:
            return
        text, confidence = found
        sure = confidence >= self.least
        self.counts["heard" if sure else "unsure"] += 1
        if sure:
            yield Heard(text, confidence, start / RATE, at / RATE)
