"""The draws of a face's life: each a pure function of the seed, the face, the scene, the behaviour and a number."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import cos, exp, log, log1p, pi, sqrt

from facescript.ir.random import chance

WIDEST = 2.5
"""Standard deviations beyond which a normal draw is cut: nobody waits a minute for a blink."""


@dataclass(frozen=True, slots=True)
class Dice:
    """Draws for one face (`place`: its name and its scene's) by behaviour, number and purpose."""

    seed: int
    place: tuple[object, ...]

    def at(self, *place: object) -> Dice:
        """The draws of something in the scene that has a place of its own."""
        return Dice(self.seed, (*self.place, *place))

    def chance(self, behaviour: str, index: int, purpose: str) -> float:
        """Uniform in [0, 1)."""
        return chance(self.seed, *self.place, behaviour, index, purpose)

    def between(self, low: float, high: float, behaviour: str, index: int, purpose: str) -> float:
        """Uniform in [low, high)."""
        return low + (high - low) * self.chance(behaviour, index, purpose)

    def normal(self, mean: float, deviation: float, behaviour: str, index: int, purpose: str) -> float:
        """Normal, cut at `WIDEST` standard deviations (Box and Muller's transform of two uniform draws)."""
        radius = sqrt(-2.0 * log1p(-self.chance(behaviour, index, purpose)))
        turn = 2.0 * pi * self.chance(behaviour, index, f"{purpose} turn")
        return mean + deviation * min(WIDEST, max(-WIDEST, radius * cos(turn)))

    def log_normal(self, mean: float, variation: float, behaviour: str, index: int, purpose: str) -> float:
        """Log-normal by its mean and coefficient of variation: positively skewed, as the times between blinks are."""
        variance = log1p(variation * variation)
        return exp(self.normal(log(mean) - variance / 2.0, sqrt(variance), behaviour, index, purpose))

    def gamma(self, theta: float, behaviour: str, index: int, purpose: str) -> float:
        """Gamma with shape 2: the sum of two exponential waits of mean `theta` (thesis 4.3)."""
        waits = (log1p(-self.chance(behaviour, index, f"{purpose} {part}")) for part in (1, 2))
        return -theta * sum(waits)


Waits = Callable[[int], float]
"""Seconds by an event's number."""

SHORTEST = 0.02
"""Seconds the shortest event takes, so that there are never too many."""


@dataclass(frozen=True, slots=True)
class Event:
    """One movement of a behaviour: its number, and seconds from the film's start."""

    index: int
    start: float
    end: float


def events(start: float, end: float, gaps: Waits, lengths: Waits, last: Event | None = None) -> Iterator[Event]:
    """The events that begin in [start, end): `gaps(k)` from the end of event k - 1 (0: from `start`) to the start of
    event k, which takes `lengths(k)`. They may go on from the `last` that is known."""
    index, time = (0, start + max(gaps(0), 0.0)) if last is None else (last.index, last.start)
    while time < end:
        over = time + max(lengths(index), SHORTEST)
        yield Event(index, time, over)
        index += 1
        time = over + max(gaps(index), 0.0)
