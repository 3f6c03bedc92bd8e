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

TREMBLE, COARSEST = 0.003, 0.03
"""How far off sightings are from side to side at first, as a part of the distance (standard deviation), and at most:
0.17 and 1.7 degrees. How far they are, they show."""

FINEST = 0.05
"""A sighting is off by so much at least, cm."""

LEARNING = 1.0
"""For so long it counts how far off sightings were, s."""

STANDING, MOVING = 10.0, 6000.0
"""How much a person speeds up, cm^2/s^3: one who stands or goes evenly, and one who does not."""

MEMORY = 0.2
"""For so long it counts how far she was from where she was expected, s."""

CALM, STIRRED = 3.0, 9.0
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
    _noise: float = 0.0
    _last: tuple[float, Triple] = (0.0, (0.0, 0.0, 0.0))
    _before: tuple[float, Triple] | None = None

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
        self._noise = self._noise or (TREMBLE * place[2]) ** 2
        self._last, self._before = (time, place), None
        self._spread = (self._noise, 0.0, FIRST_SPEED * FIRST_SPEED)

    def _tremble(self, time: float, place: Triple) -> None:
        """Learn how far off sightings are: by how much the one before was beside the line between its neighbours."""
        if self._before is not None:
            (first, one), (middle, other) = self._before, self._last
            u = (middle - first) / (time - first)
            beside = [other[axis] - one[axis] - u * (place[axis] - one[axis]) for axis in (0, 1)]
            found = (beside[0] ** 2 + beside[1] ** 2) / (2.0 * (1.0 + u * u + (1.0 - u) ** 2))
            kept = exp((middle - time) / LEARNING)
            most = (COARSEST * place[2]) ** 2
            self._noise = max(FINEST * FINEST, kept * self._noise + (1.0 - kept) * min(found, most))
        self._before, self._last = self._last, (time, place)

    def _correct(self, step: float, time: float, place: Triple) -> bool:
        expected = tuple(x + u * step for x, u in zip(self.place, self.speed, strict=True))
        new = tuple(x - y for x, y in zip(place, expected, strict=True))
        noise = self._noise
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
        self._tremble(time, place)
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
        q = STANDING * exp(self.stirred * log(MOVING / STANDING))
        return a + step * (2 * b + step * c) + q * step**3 / 3, b + step * c + q * step * step / 2, c + q * step

    @property
    def stirred(self) -> float:
        """Whether she does something new, 0..1."""
        share = (self._off[0] ** 2 + self._off[1] ** 2 - CALM) / (STIRRED - CALM)
        return min(1.0, max(0.0, share))

    def _note(self, step: float, new: tuple[float, ...], deviation: float) -> None:
        """Note how far off a sighting is, as a share of what trembling alone leaves of many."""
        kept = exp(-step / MEMORY)
        white = sqrt((1.0 + kept) / (1.0 - kept))
        x, y = (value / deviation for value in new[:2])
        scale = white * (1.0 - kept)
        was = self._off
        self._off = was[0] * kept + scale * x, was[1] * kept + scale * y
