"""The announcer against the thesis's distributions: an hour each of ten seeds, Kolmogorov and Smirnov's test."""

from __future__ import annotations

from collections.abc import Sequence

from distributions import announcer_p_values

SEEDS = range(10)
LEAST, OFTEN = 0.01, 9
"""The p that each statistic has to exceed, and in how many of the ten seeds."""

PValues = dict[str, float]


def p_values(seed: int) -> PValues:
    """The p of each statistic for one seed."""
    return announcer_p_values(seed)


def printed(found: Sequence[PValues]) -> str:
    """A row a statistic."""
    lines = ["| announcer, an hour, ten seeds | least p | seeds with p over 0.01 | bar | |", "|---|---|---|---|---|"]
    for name in found[0]:
        each, verdict = [one[name] for one in found], "pass" if passes(found, name) else "FAIL"
        lines.append(
            f"| {name} | {min(each):.3f} | {_good(each)} of {len(each)} | {OFTEN} of {len(each)} | {verdict} |"
        )
    return "\n".join(lines)


def passes(found: Sequence[PValues], name: str) -> bool:
    return _good([one[name] for one in found]) >= OFTEN


def _good(each: Sequence[float]) -> int:
    return sum(p > LEAST for p in each)
