"""A scan to how long it stays on each of a crowd: the time written, or one as people's fixations have it."""

from __future__ import annotations

from collections.abc import Hashable
from math import log1p

from facescript.ir.acts import Scan
from facescript.ir.random import chance
from facescript.schedule.defaults import seconds

BRIEFEST, WAIT, LONGEST = 0.35, 0.125, 1.2
"""Seconds: a natural dwell is the first and two exponential waits of the second, 0.6 s in the mean, skewed as fixations
are (`motion.md` 1), and cut at the third. A fixation of a face takes 0.25 to 0.35 s; to be greeted takes one or two."""


def dwells(scan: Scan, count: int, seed: int, place: tuple[Hashable, ...]) -> list[float]:
    """Seconds for each of `count` members; `place` names the scan to the seed."""
    if scan.dwell is not None:
        return [seconds(scan.dwell)] * count
    return [_natural(seed, *place, "dwell", number) for number in range(count)]


def _natural(seed: int, *place: Hashable) -> float:
    waits = sum(-log1p(-chance(seed, *place, part)) for part in (1, 2))
    return min(BRIEFEST + WAIT * waits, LONGEST)
