"""Sightings of one person, irregular and trembling, to where she is taken to be and how fast she goes.

A Kalman filter of constant velocity, whose gains are the same for all three axes: a camera knows a direction better
than a distance, and what is wrong with the distance draws all three towards it or away. How much she is taken to speed
up hangs on how far she has lately been from where she was expected: one who stands is calm, one who sets off is caught
up with.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from math import exp, hypot, log, sqrt

Triple = tuple[float, float, float]

TREMBLE = 0.005
"""How far off a sighting is from side to side, as a part of the distance (standard deviation): 0.3 degrees."""

FINEST = 0.1
"""A sighting is off by so much at least, cm."""

STANDING, MOVING = 60.0, 6000.0
"""How much a person speeds up, cm^2/s^3: one who stands or goes evenly, and one who does not."""

MEMORY = 0.15
"""For so long it counts how far she was from where she was expected, s."""

CALM, STIRRED = 1.0, 4.0
"""How far that is on average, as a share of what trembling makes of it (square), below and above which she is taken to
go evenly, or to do something new."""

UNLIKELY, LEAP = 5.0, 20.0
"""A sighting further from where she is expected than so many deviations, and so many cm, is not believed alone."""

AGREE = 0.35
"""Two sightings agree on where she leapt to that are within this part of the leap."""

FIRST_SPEED = 100.0
"""How fast a person may be when she is seen first, cm/s."""

LONGEST = 1.0
"""After so long without a sighting nothing is left of what was known, s."""


@dataclass(slots=True)
class Estimate:
    """Where a person was at the `time` (s) of the last sighting, cm, and how fast, cm/s. `between` is the time from one
    sighting to the next, on average; `leapt` whether the last one was believed against all that was known."""

    time: float
    place: Triple
    speed: Triple = (0.0, 0.0, 0.0)
    between: float | None = None
    leapt: bool = False
    counts: Counter[str] = field(default_factory=Counter)
    _doubt: Triple | None = None
    _off: tuple[float, float] = (0.0, 0.0)
    _spread: Triple = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        self._begin(self.time, self.place)

    def take(self, time: float, place: Triple) -> bool:
        """Learn from a sighting; False for one that is older than what is known, or not believed yet."""
        step = time - self.time
        self.leapt = False
        if step <= 0.0:
            self.counts["sightings out of order"] += 1
            return False
        if step > LONGEST:
            self.leapt, self.between = True, step
            self._begin(time, place)
            return True
        self.between = step if self.between is None else self.between + 0.2 * (step - self.between)
        return self._correct(step, time, place)

    def _begin(self, time: float, place: Triple) -> None:
        self.time, self.place, self.speed = time, place, (0.0, 0.0, 0.0)
        self._doubt, self._off = None, (0.0, 0.0)
        self._spread = (self._noise(place), 0.0, FIRST_SPEED * FIRST_SPEED)

    @staticmethod
    def _noise(place: Triple) -> float:
        """The variance of a sighting, cm^2."""
        off = max(FINEST, TREMBLE * abs(place[2]))
        return off * off

    def _correct(self, step: float, time: float, place: Triple) -> bool:
        expected = tuple(x + u * step for x, u in zip(self.place, self.speed, strict=True))
        new = tuple(x - y for x, y in zip(place, expected, strict=True))
        noise = self._noise(place)
        a, b, c = self._ahead(step)
        deviation = sqrt(a + noise)
        far = hypot(new[0], new[1])
        if far > max(UNLIKELY * deviation, LEAP) and not self._agreed(place, far):
            self.counts["sightings not believed"] += 1
            self._doubt = place
            return False
        if self._doubt is not None and far > max(UNLIKELY * deviation, LEAP):
            self.leapt = True
            self._begin(time, place)
            return True
        self._doubt = None
        self._note(step, new, deviation)
        k, m = a / (a + noise), b / (a + noise)
        x, y, z = (value + k * off for value, off in zip(expected, new, strict=True))
        u, v, w = (value + m * off for value, off in zip(self.speed, new, strict=True))
        self.time, self.place, self.speed = time, (x, y, z), (u, v, w)
        self._spread = (a - k * a, b - k * b, c - m * b)
        return True

    def _agreed(self, place: Triple, far: float) -> bool:
        doubt = self._doubt
        return doubt is not None and hypot(place[0] - doubt[0], place[1] - doubt[1]) < AGREE * far

    def _ahead(self, step: float) -> Triple:
        """The spread of place and speed a step later: variances of both and what they share."""
        a, b, c = self._spread
        q = self._stir()
        return a + step * (2 * b + step * c) + q * step**3 / 3, b + step * c + q * step * step / 2, c + q * step

    def _stir(self) -> float:
        """How much she is taken to speed up."""
        share = (self._off[0] ** 2 + self._off[1] ** 2 - CALM) / (STIRRED - CALM)
        share = min(1.0, max(0.0, share))
        return STANDING * exp(share * log(MOVING / STANDING))

    def _note(self, step: float, new: tuple[float, ...], deviation: float) -> None:
        """Note how far off a sighting is, as a share of what trembling alone leaves of many."""
        kept = exp(-step / MEMORY)
        white = sqrt((1.0 + kept) / (1.0 - kept))
        x, y = (value / deviation for value in new[:2])
        scale = white * (1.0 - kept)
        was = self._off
        self._off = was[0] * kept + scale * x, was[1] * kept + scale * y
