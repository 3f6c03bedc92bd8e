"""A stretch of a recording and the sentences said in it, to when each word and phone is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from facescript.speech.align.features import Floats, with_change
from facescript.speech.align.reference import HOP, Reference
from facescript.speech.align.warp import Warp, warp
from facescript.speech.model import PhoneTime, WordTime

CHANGE = 2
"""Frames on either side over which a frame's change is taken."""

REACH = 80
"""Frames (0.8 s) of a voice that a recording may be beside the coarse course."""


@dataclass(frozen=True, slots=True)
class Heard:
    """Words and phones as voices have them, at the recording's seconds; `likeness` for each frame from `first` on is
    how much nearer the recording is to the text than to the same sounds in another order: about 0.85 where it says it,
    1 where it does not."""

    words: tuple[WordTime, ...]
    phones: tuple[PhoneTime, ...]
    first: int
    likeness: Floats


def heard(bands: Floats, first: int, places: NDArray[np.float64], voices: Sequence[Reference]) -> Heard:
    """The frames `bands` of a recording, its frame `first` and on, as `voices` say them; `places` is about the first
    voice's frame for each."""
    own = with_change(bands, CHANGE)
    length = len(voices[0].bands)
    evened = [with_change(_evened(voice.bands, length), CHANGE) for voice in voices]
    turned = [np.roll(voice, length // 2, axis=0) for voice in evened]
    near = np.round(places).astype(np.int64)
    both = warp(own, np.stack(evened + turned), REACH, near)
    ways, wrong = both[: len(voices)], both[len(voices) :]
    likeness = _distance(ways) / _distance(wrong).mean()
    times = [
        (voice, _Clock(way.path * (len(voice.bands) / length), first)) for voice, way in zip(voices, ways, strict=True)
    ]
    return Heard(_words(times), _phones(times), first, likeness)


def _distance(ways: Sequence[Warp]) -> Floats:
    """How unlike each frame is, over the voices."""
    found: Floats = np.mean([way.distances for way in ways], axis=0)
    return found


def _evened(bands: Floats, length: int) -> Floats:
    """The frames of a voice, spread over another number of frames."""
    return bands[np.minimum((np.arange(length) + 0.5) * len(bands) / length, len(bands) - 1).astype(np.int64)]


class _Clock:
    """A voice's seconds to the recording's: a frame of the voice is in the middle of those that it was found in."""

    def __init__(self, path: NDArray[np.floating], first: int) -> None:
        places, which, counts = np.unique(path, return_inverse=True, return_counts=True)
        self._places = places * HOP
        self._moments = (first + np.bincount(which, np.arange(len(path))) / counts) * HOP

    def __call__(self, seconds: Sequence[float]) -> NDArray[np.float64]:
        found: NDArray[np.float64] = np.interp(seconds, self._places, self._moments)
        return found


def _words(times: Sequence[tuple[Reference, _Clock]]) -> tuple[WordTime, ...]:
    """The words of the first voice at the median of what the voices say."""
    first = times[0][0].words
    alike = [(voice, clock) for voice, clock in times if _spans(voice.words) == _spans(first)]
    starts = np.median([clock([word.start for word in voice.words]) for voice, clock in alike], axis=0)
    ends = np.median([clock([word.end for word in voice.words]) for voice, clock in alike], axis=0)
    return tuple(
        replace(word, start=float(start), end=float(max(start, end)))
        for word, start, end in zip(first, starts, ends, strict=True)
    )


def _phones(times: Sequence[tuple[Reference, _Clock]]) -> tuple[PhoneTime, ...]:
    first = times[0][0].phones
    alike = [(voice, clock) for voice, clock in times if _symbols(voice.phones) == _symbols(first)]
    starts = np.median([clock([phone.start for phone in voice.phones]) for voice, clock in alike], axis=0)
    ends = np.median([clock([phone.end for phone in voice.phones]) for voice, clock in alike], axis=0)
    return tuple(
        replace(phone, start=float(start), end=float(max(start, end)))
        for phone, start, end in zip(first, starts, ends, strict=True)
    )


def _spans(words: Sequence[WordTime]) -> list[int]:
    return [word.first for word in words]


def _symbols(phones: Sequence[PhoneTime]) -> list[str]:
    return [phone.symbol for phone in phones]
