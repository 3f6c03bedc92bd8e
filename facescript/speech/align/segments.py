"""A recording to its sentence utterances: by the pause after the first (Algorithm 3.1), or by the best fit."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from facescript.speech.align.activity import Stretch

SHARE, MARGIN = 0.95, 1.45
"""c1 and c2 of Algorithm 3.1."""

CLEAR = 0.35
"""Seconds of the shortest pause that is clearly one between sentences."""

EDGE = 0.03
"""Seconds at both ends of a pause that was found by itself, in which the voice may still fade."""

SHORTEST = 0.12
"""Seconds of a pause that a sentence may end in."""

NEAREST = 0.7
"""Seconds by which a sentence's beginning, as the course has it, may lie beside the pause before it."""

WORTH = 0.5
"""Seconds farther that a pause may be for each second that it is longer, up to `LONG`."""

LONG = 1.0


def silences(samples: NDArray[np.int16], rate: int, pause: Stretch) -> tuple[Stretch, ...]:
    """Algorithm 3.1: the silences from the chosen `pause` on, as quiet and about as long as it."""
    first, last = round(pause.start * rate), round(pause.end * rate)
    loudest = int(np.abs(samples[first:last].astype(np.int32)).max(initial=0))
    least = SHARE * pause.length * rate
    loud = np.flatnonzero(np.abs(samples[first:].astype(np.int32)) >= max(MARGIN * loudest, 1)) + first
    edges = np.concatenate([[first - 1], loud, [len(samples)]])
    longer = np.flatnonzero(np.diff(edges) - 1 > least)
    return tuple(Stretch((int(edges[at]) + 1) / rate, int(edges[at + 1]) / rate) for at in longer)


def speaking_parts(quiet: Sequence[Stretch], duration: float) -> tuple[Stretch, ...]:
    """Steps 6 and 7 of Algorithm 3.1: what no silence occupies."""
    moments = [0.0, *(moment for each in quiet for moment in (each.start, each.end)), duration]
    parts = (Stretch(*moments[at : at + 2]) for at in range(0, len(moments), 2))
    return tuple(part for part in parts if part.length > 0)


def first_clear(spoken: Sequence[Stretch]) -> Stretch | None:
    """The first pause that is clearly one between sentences, as one would choose it by hand."""
    for before, after in pairwise(spoken):
        if after.start - before.end >= CLEAR + 2 * EDGE:
            return Stretch(before.end + EDGE, after.start - EDGE)
    return None


def pauses_between(spoken: Sequence[Stretch]) -> tuple[Stretch, ...]:
    """The pauses between stretches of speech that a sentence may end in."""
    gaps = (Stretch(before.end, after.start) for before, after in pairwise(spoken))
    return tuple(gap for gap in gaps if gap.length >= SHORTEST)


def fitting(starts: Sequence[float], pauses: Sequence[Stretch]) -> tuple[Stretch | None, ...]:
    """For each sentence but the first, expected to begin at one of `starts`: the pause before it, or None where there
    is none. The row of pauses is the best in all: near what is expected, and long."""
    gains = [_gains(start, pauses) for start in starts]
    rows = [np.zeros(len(pauses) + 1)]
    for gain in gains:
        with_it = np.concatenate([[0.0], rows[-1][:-1] + gain])
        rows.append(np.maximum.accumulate(np.maximum(rows[-1], with_it)))
    found: list[Stretch | None] = []
    at = len(pauses)
    for row, before in zip(rows[:0:-1], rows[-2::-1], strict=True):
        while at and row[at] == row[at - 1]:
            at -= 1
        taken = row[at] > before[at]
        at -= taken
        found.append(pauses[at] if taken else None)
    return tuple(found[::-1])


def _gains(start: float, pauses: Sequence[Stretch]) -> NDArray[np.float64]:
    """What each pause is worth before a sentence that begins at about `start`; nothing where it is too far."""
    begins = np.array([pause.start for pause in pauses])
    ends = np.array([pause.end for pause in pauses])
    far = np.maximum(np.maximum(begins - start, start - ends), 0.0)
    return np.where(far <= NEAREST, NEAREST - far + WORTH * np.minimum(ends - begins, LONG), -np.inf)
