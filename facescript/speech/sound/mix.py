"""The lines of a score to one track of sound."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from facescript.speech.espeak.parts import RATE
from facescript.speech.model import Spoken

FADE = 0.02
"""Seconds over which a line that is cut dies away, up to the cut."""

KNEE = 0.8
"""Below this part of full scale sound passes as it is; above, it nears full scale and never passes it."""

FULL = 32767.0

BLOCK = 1 << 20
"""Samples mixed at once, so that of what is as long as the film only the sound itself is held."""

Samples = NDArray[np.float32]


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


def soundtrack(score: Lines) -> tuple[NDArray[np.int16], int]:
    """The sound of all lines, as long as the score: mono samples and their rate in Hz."""
    sound = np.zeros(round(score.duration * RATE), dtype=np.int16)
    for first in range(0, len(sound), BLOCK):
        part = np.zeros(min(BLOCK, len(sound) - first), dtype=np.float32)
        for line in score.lines:
            _lay(part, line, first)
        loud = np.abs(part) > KNEE * FULL
        part[loud] = _limited(part[loud])
        sound[first : first + BLOCK] = np.rint(part)
    return sound, RATE


def _lay(block: Samples, line: Line, first: int) -> None:
    """Add what falls of one line, at its time and volume and up to its cut, into the block that starts at `first`."""
    start = round(line.start * RATE) - first
    if start >= len(block) or start + line.spoken.duration * RATE + RATE < 0:
        return
    sound = np.frombuffer(line.spoken.pcm, dtype="<i2").astype(np.float32) * np.float32(line.volume)
    if line.spoken.rate != RATE:
        sound = _resampled(sound, line.spoken.rate)
    if line.cut is not None:
        sound = _cut(sound, line.cut - line.start)
    skipped = max(-start, 0)
    stretch = block[max(start, 0) : max(start, 0) + max(len(sound) - skipped, 0)]
    stretch += sound[skipped : skipped + len(stretch)]


def _cut(sound: Samples, seconds: float) -> Samples:
    kept = sound[: max(round(seconds * RATE), 0)].copy()
    fading = min(round(FADE * RATE), len(kept))
    kept[len(kept) - fading :] *= np.linspace(1, 0, fading, dtype=np.float32)
    return kept


def _resampled(sound: Samples, rate: int) -> Samples:
    """The sound at `RATE`, its samples joined by straight lines."""
    count = round(len(sound) * RATE / rate)
    places = np.arange(count) * (rate / RATE)
    resampled: Samples = np.interp(places, np.arange(len(sound)), sound).astype(np.float32)
    return resampled


def _limited(samples: Samples) -> Samples:
    """Full scale's soft limit: the identity's slope at the knee, full scale at infinity."""
    room = np.float32((1 - KNEE) * FULL)
    over = np.abs(samples) - np.float32(KNEE * FULL)
    limited: Samples = np.sign(samples) * (np.float32(KNEE * FULL) + room * np.tanh(over / room))
    return limited
