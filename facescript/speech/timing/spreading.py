"""Words over a stretch of time, each by the length that it usually takes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from facescript.speech.estimate import pause_between, word_length
from facescript.speech.lines import Word

DRAWN_OUT = 1.6
"""How many times its usual length a word takes at most where its end is not known."""

LEAST = 0.06
"""Seconds of a word that has no letters to count."""


def spread(
    text: str, found: Sequence[Word], start: float, end: float, slowest: float = math.inf
) -> list[tuple[float, float]]:
    """The beginning and end of each word `found` in `text`, over the seconds from `start` to `end`; they take at most
    `slowest` times as long as usual."""
    lengths = [word_length(text[word.first : word.last]) or LEAST for word in found]
    pauses = [pause_between(text[before.last : word.first]) for before, word in pairwise(found)] + [0.0]
    pace = min((end - start) / (sum(lengths) + sum(pauses)), slowest) if found else 0.0
    spans = []
    at = start
    for length, pause in zip(lengths, pauses, strict=False):
        spans.append((at, min(at + pace * length, end)))
        at = min(at + pace * (length + pause), end)
    return spans
