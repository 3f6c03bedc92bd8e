"""The lines of a score to one track of sound, made a block at a time: hours of it never lie in memory."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from facescript.speech.model import Spoken
from facescript.speech.sound.resample import resampled, resampled_length

RATES = (22_050, 24_000, 32_000, 44_100, 48_000)
"""The rates a track may have, Hz: every player and every encoder takes them. It is the first that loses nothing of any
line, the default voice's own where nothing needs more."""

FADE = 0.02
"""Seconds over which a line that is cut dies away, up to the cut."""

KNEE = 0.8
"""Below this part of full scale sound passes as it is; above, it nears full scale and never passes it."""

FULL = 32767.0

BLOCK = 1 << 20
"""Samples of a block: 22 to 48 seconds."""

Floats = NDArray[np.float32]
Samples = NDArray[np.int16]


class Line(Protocol):
    """A spoken line at its time (a score's `TimedLine`): `start` and `cut` in seconds, `volume` a factor."""

    @property
    def start(self) -> float: ...
    @property
    def spoken(self) -> Spoken: ...
    @property
    def volume(self) -> float: ...
    @property
    def cut(self) -> float | None: ...


class Lines(Protocol):
    """What a score has that can be heard; `duration` in seconds."""

    @property
    def lines(self) -> Sequence[Line]: ...
    @property
    def duration(self) -> float: ...


@dataclass(frozen=True)
class Soundtrack:
    """What is heard of `lines` from sample `first` to sample `last`: mono, 16 bit, `rate` Hz."""

    lines: Sequence[Line]
    rate: int
    first: int
    last: int

    def __len__(self) -> int:
        """How many samples it has."""
        return self.last - self.first

    @property
    def seconds(self) -> float:
        return len(self) / self.rate

    @property
    def silent(self) -> bool:
        """Whether nothing is heard in it; made up to the first sound."""
        return not any(block.any() for block in self.blocks())

    def between(self, start: float, end: float) -> Soundtrack:
        """The seconds `start` to `end` of the film, exactly that long."""
        return replace(self, first=round(start * self.rate), last=round(end * self.rate))

    def blocks(self) -> Iterator[Samples]:
        """The sound, a block after another. It is the same however it is cut into blocks."""
        for first in range(self.first, self.last, BLOCK):
            yield self._mixed(first, min(first + BLOCK, self.last))

    def samples(self) -> Samples:
        """All of it at once, for what is short: 2 bytes a sample, 160 MB an hour and more."""
        return np.concatenate([np.zeros(0, dtype=np.int16), *self.blocks()])

    def _mixed(self, first: int, last: int) -> Samples:
        part = np.zeros(last - first, dtype=np.float32)
        for line in self.lines:
            _lay(part, line, first, self.rate)
        loud = np.abs(part) > KNEE * FULL
        part[loud] = _limited(part[loud])
        return np.rint(part).astype(np.int16)


def soundtrack(score: Lines) -> Soundtrack:
    """The sound of all lines, as long as the score."""
    most = max((line.spoken.rate for line in score.lines if line.spoken.sound), default=0)
    rate = next((rate for rate in RATES if rate >= most), RATES[-1])
    return Soundtrack(score.lines, rate, 0, round(score.duration * rate))


def _lay(block: Floats, line: Line, first: int, rate: int) -> None:
    """Add what falls of one line, at its time and volume and up to its cut, into the block that starts at `first`."""
    begin = round(line.start * rate) - first
    length = resampled_length(len(line.spoken.sound) // 2, line.spoken.rate, rate)
    until = length if line.cut is None else min(max(round((line.cut - line.start) * rate), 0), length)
    start, end = max(begin, 0), min(begin + until, len(block))
    if end <= start:
        return
    sound = np.frombuffer(line.spoken.pcm, dtype="<i2")
    part = _samples(sound, line.spoken.rate, rate, start - begin, end - begin) * np.float32(line.volume)
    if line.cut is not None:
        part *= _fading(until, rate, start - begin, end - begin)
    block[start:end] += part


def _samples(sound: Samples, own: int, rate: int, first: int, last: int) -> Floats:
    """Samples `first` to `last` at `rate` Hz of a sound at `own` Hz."""
    if own == rate:
        return sound[first:last].astype(np.float32)
    return resampled(sound, own, rate, first, last)


def _fading(until: int, rate: int, first: int, last: int) -> Floats:
    """How loud the samples `first` to `last` of a line are that ends at sample `until`."""
    fading = min(round(FADE * rate), until)
    loud = np.ones(last - first, dtype=np.float32)
    begun = until - fading
    falling = np.linspace(1, 0, fading, dtype=np.float32)[max(first - begun, 0) : max(last - begun, 0)]
    loud[len(loud) - len(falling) :] = falling
    return loud


def _limited(samples: Floats) -> Floats:
    """Full scale's soft limit: the identity's slope at the knee, full scale at infinity."""
    room = np.float32((1 - KNEE) * FULL)
    over = np.abs(samples) - np.float32(KNEE * FULL)
    limited: Floats = np.sign(samples) * (np.float32(KNEE * FULL) + room * np.tanh(over / room))
    return limited
