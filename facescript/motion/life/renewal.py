"""Turns a wait between movements into when they happen, by its hazard: what happened long ago does not matter.

A renewal process is thinned out of candidates that come at random (Lewis and Shedler 1979). A candidate is kept with
the chance that the wait ends there, given that it has lasted so far; the waits then have their distribution exactly.
Candidates lie where a hash puts them, whatever was kept before. So two processes that differ for a while, as when a
line is inserted, come to keep the same candidate soon, and are one from there on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import erfc, exp, inf, log, log1p, pi, sqrt

from facescript.motion.dice import Dice, Event
from facescript.motion.life.memory import Memory
from facescript.motion.life.stretches import NEVER, Stretches

BLOCK = 16
"""Candidates that a block of time has on average; each block is hashed by itself."""

NUMBERS = 1024
"""Numbers a block has for its candidates: more than it could ever need."""

TAIL = 8.0
"""Standard deviations from which on the tail of a normal distribution is taken by its limit."""


@dataclass(frozen=True, slots=True)
class Wait:
    """A positive random time: `hazard` takes seconds waited to the chance (1/s) that the wait ends there, given that
    it has not before; it is never above `ceiling`."""

    hazard: Callable[[float], float]
    ceiling: float


def gamma_wait(theta: float) -> Wait:
    """Gamma with shape 2 and scale `theta` seconds (`thesis` 4.3)."""
    return Wait(lambda waited: waited / (theta * (theta + waited)), 1.0 / theta)


@lru_cache(maxsize=256)
def log_normal_wait(mean: float, variation: float) -> Wait:
    """Log-normal by its mean (s) and coefficient of variation: positively skewed, as times between blinks are."""
    variance = log1p(variation * variation)
    centre, spread = log(mean) - variance / 2.0, sqrt(variance)

    def hazard(waited: float) -> float:
        if waited <= 0.0:
            return 0.0
        return _normal_hazard((log(waited) - centre) / spread) / (spread * waited)

    grid = (exp(centre + spread * (step / 50.0 - 4.0)) for step in range(801))
    return Wait(hazard, 1.01 * max(map(hazard, grid)))


def _normal_hazard(z: float) -> float:
    """The hazard of the standard normal distribution at `z`: its density over what is left above."""
    if z > TAIL:
        return z + 1.0 / z
    return exp(-z * z / 2.0) / (sqrt(2.0 * pi) * 0.5 * erfc(z / sqrt(2.0)))


@dataclass(frozen=True, slots=True)
class Span:
    """From when to when (s) a process runs; at its start it has waited `waited` seconds already."""

    start: float
    end: float
    waited: float = 0.0


def renewals(
    dice: Dice, behaviour: str, wait: Wait, span: Span, lengths: Callable[[int], float],
    closed: Stretches = NEVER, least: float = 0.0, memory: Memory | None = None
) -> Iterator[Event]:  # fmt: skip
    """The events of a process: after a `wait` from the end of one the next begins and takes `lengths(number)`.

    None begins in a stretch that is `closed`, nor when it would begin less than `least` seconds later; one that runs
    into it ends there. After it the wait begins anew. That rule knows no drawn length, so none is made rarer by it.
    With a `memory` it goes on from there, the last events before again.
    """
    rest, since = span.start - span.waited, -inf
    known = memory.state(dice, behaviour) if memory else None
    if memory is not None and known is not None:
        past, rest = known
        since = memory.since
    found = memory.renewing(dice, behaviour, rest, closed) if memory else []
    if known is not None:
        found += past
        yield from past
    for number, time in _candidates(dice, behaviour, wait.ceiling, span, since):
        begun = max(rest, closed.last_end(time))
        shut = closed.next(time)[0]
        if time < begun or time + least > shut:
            continue
        if dice.chance(behaviour, number, "kept") * wait.ceiling < wait.hazard(time - begun):
            rest = min(time + lengths(number), shut)
            found.append(Event(number, time, rest))
            yield found[-1]


def _candidates(dice: Dice, behaviour: str, rate: float, span: Span, since: float) -> Iterator[tuple[int, float]]:
    """Number and time of every candidate from `since` on: `rate` a second, a Poisson process."""
    length = BLOCK / rate
    block = int(max(0.0, since - span.start) / length)
    while block * length < span.end - span.start:
        offset, number = 0.0, block * NUMBERS
        while True:
            offset -= log1p(-dice.chance(behaviour, number, "candidate")) / rate
            time = span.start + block * length + offset
            if offset >= length or time >= span.end:
                break
            if time >= since:
                yield number, time
            number += 1
        block += 1
