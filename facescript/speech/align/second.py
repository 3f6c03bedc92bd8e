"""What one way of aligning found, and another's starts of phones, to the better of both."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from facescript.speech.align.piece import Heard
from facescript.speech.model import Doubt

USUAL, FARTHEST = 0.08, 0.35
"""Seconds that two ways differ by at most where both are right: half of the phones, and any phone."""

SURE = 0.96
"""The likeness up to which the first way is believed where they differ: half sure (`likeness.EVEN`)."""


@dataclass(frozen=True, slots=True)
class Part:
    """What is heard in a stretch, and when its phones begin as people label them."""

    heard: Heard
    labelled: list[float]
    doubts: tuple[Doubt, ...] = ()


def better(part: Part, starts: Sequence[float | None] | None) -> Part:
    """The part with its phones at the second way's starts; as it is where there are none, and where they differ grossly
    and the first is the more plausible."""
    if starts is None:
        return part
    known = [
        (old, new, number)
        for number, (old, new) in enumerate(zip(part.labelled, starts, strict=True))
        if new is not None
    ]
    apart = [abs(old - new) for old, new, _ in known]
    if not apart:
        return part
    if np.median(apart) <= USUAL and max(apart) <= FARTHEST:
        return _moved(part, known)
    first = float(part.heard.likeness.mean()) < SURE
    word = _word_at(part, known[int(np.argmax(apart))][0])
    taken = "the voice's" if first else "PocketSphinx's"
    doubt = Doubt("FS512", f"near `{word}` they differ by {max(apart):.2f} s, and {taken} are taken")
    return replace(part if first else _moved(part, known), doubts=(doubt,))


def _moved(part: Part, known: Sequence[tuple[float, float, int]]) -> Part:
    """All times as the second way has them, and what it does not know in step with its neighbours."""
    old = np.maximum.accumulate([start for start, _, _ in known])
    new = np.maximum.accumulate([start for _, start, _ in known])
    old = np.concatenate([[old[0] - 1], old, [old[-1] + 1]])
    new = np.concatenate([[new[0] - 1], new, [new[-1] + 1]])

    def at(moment: float) -> float:
        return max(float(np.interp(moment, old, new)), 0.0)

    words = tuple(replace(word, start=at(word.start), end=at(word.end)) for word in part.heard.words)
    phones = tuple(replace(phone, start=at(phone.start), end=at(phone.end)) for phone in part.heard.phones)
    heard = replace(part.heard, words=words, phones=phones)
    return replace(part, heard=heard, labelled=[at(start) for start in part.labelled])


def _word_at(part: Part, moment: float) -> str:
    return min(part.heard.words, key=lambda word: abs(word.start - moment)).text
