"""How like its text a recording is, frame by frame, to how sure each word is, and to what an author should know."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.speech.align.activity import Stretch
from facescript.speech.align.features import Floats
from facescript.speech.align.reference import HOP
from facescript.speech.model import Doubt, WordTime

EVEN, STEP = 0.96, 0.04
"""The likeness at which a word is as likely said as not, and by how much less it is likely by e to 1."""

AROUND = 0.3
"""Seconds around a word that are weighed with it: one word is too short to tell. All of the recording is weighed as
well, for as much."""

LEAST = 0.02
"""Seconds of a word that is heard."""

UNLIKE, SHORT = 0.945, 0.08
"""The likeness of a recording that does not say its text, and how much higher it is for one of 1 s of speech."""

FASTEST, SLOWEST = 0.33, 4.0
"""How many times as long as a voice a speaker is who says the same."""

FEW = 2
"""Words that may be lacking without a word about it."""


@dataclass(frozen=True, slots=True)
class Likeness:
    """How much nearer the recording is to the text than to its sounds in another order, from frame `first` on: about
    0.85 where it says it, about 1 where it does not."""

    first: int
    frames: Floats


def confidences(words: Sequence[WordTime], found: Sequence[Likeness]) -> tuple[float, ...]:
    """How sure each word is, 0 to 1."""
    mean = float(np.concatenate([each.frames for each in found]).mean())
    frames = np.full(max(each.first + len(each.frames) for each in found), mean)
    for each in found:
        frames[each.first : each.first + len(each.frames)] = each.frames
    sums = np.concatenate([[0.0], np.cumsum(frames)])
    return tuple(_sure(word, sums, mean) for word in words)


def _sure(word: WordTime, sums: NDArray[np.float64], whole: float) -> float:
    if word.end - word.start < LEAST:
        return 0.0
    first = max(round((word.start - AROUND) / HOP), 0)
    last = min(round((word.end + AROUND) / HOP), len(sums) - 1)
    if last <= first:
        return 0.0
    mean = (float(sums[last] - sums[first]) / (last - first) + whole) / 2
    return 1 / (1 + math.exp((mean - EVEN) / STEP))


def unlike(spoken: Sequence[Stretch], duration: float) -> Doubt | None:
    """What shows before anything is compared that a recording with speech in the stretches `spoken` does not say a
    text for which a voice takes `duration` seconds."""
    if not spoken:
        return Doubt("FS510", "nobody is heard in it")
    pace = sum(each.length for each in spoken) / duration
    if FASTEST < pace < SLOWEST:
        return None
    return Doubt("FS510", f"a voice takes {duration:.1f} s for it, and somebody speaks for {pace * duration:.1f} s")


def doubts(words: Sequence[WordTime], sure: Sequence[float], found: Sequence[Likeness]) -> tuple[Doubt, ...]:
    """What an author should know: that another text is said (FS510), or not all of it (FS511)."""
    frames = np.concatenate([each.frames for each in found])
    seconds = max(len(frames) * HOP, HOP)
    mean = float(frames.mean())
    if mean > UNLIKE + SHORT / seconds:
        percent = 100 / (1 + math.exp((mean - EVEN) / STEP))
        return (Doubt("FS510", f"they are alike by {percent:.0f} %"),)
    return _lacking(words, sure)


def _lacking(words: Sequence[WordTime], sure: Sequence[float]) -> tuple[Doubt, ...]:
    """The words at the start and at the end that are not heard."""
    said = [number for number, each in enumerate(sure) if each > 0.0]
    first, last = (said[0], said[-1] + 1) if said else (len(words), len(words))
    if first > FEW:
        return (Doubt("FS511", f"the first {first} words, to `{words[first - 1].text}`, are not heard in it"),)
    if len(words) - last > FEW:
        return (
            Doubt("FS511", f"the last {len(words) - last} words, from `{words[last].text}` on, are not heard in it"),
        )
    return ()
