"""What is learned of a person's place, again and again, to a path that grows: what it said of a time it says for ever.

Each time more is known, a leg is added. It sets off from where the path is by then, and as fast, and goes over to where
the person is taken to be now; with nothing new it comes to rest there, and after a while the person is lost. So the
path is smooth, no leg bends one before it, and where one was taken to be at a time can be asked at any later one.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from math import exp, inf

from facescript.ir.values import Point

STOPPING = 0.3
"""How long the path takes to come to rest where nothing new is learned, s."""

KEPT = 60.0
"""So long are legs kept, s: those that plans of gaze were made by may be asked for again."""

MOST_GAPS = 4096
"""As many stretches in which she was lost are kept."""

UNKNOWN = Point(0.0, 0.0, 60.0)
"""Where one is whom nobody has seen; gaze waits for her elsewhere."""

Triple = tuple[float, float, float]

_NOWHERE: Triple = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Fix:
    """What is known of a person: where she was at a `time` (s of the film), cm, and how fast, cm/s. She is taken to go
    on so for `runs` seconds, then to stop; and is lost at `lost`, where no more is learned by then. A path goes over to
    it at a `rate` (a pole of the third order, 1/s)."""

    time: float
    place: Triple
    speed: Triple
    runs: float
    lost: float
    rate: float = 16.0

    def after(self, time: float) -> Triple:
        """How long (s) she has gone on at a time, how fast (as a part of her speed), and how that changes (1/s)."""
        gone = time - self.time
        if gone <= self.runs:
            return gone, 1.0, 0.0
        u = min(1.0, (gone - self.runs) / STOPPING)
        gone = self.runs + STOPPING * u * (1.0 - u * u * (1.0 - u / 2.0))
        return gone, 1.0 - u * u * (3.0 - 2.0 * u), -6.0 * u * (1.0 - u) / STOPPING


@dataclass(frozen=True, slots=True)
class Leg:
    """The path from a time `since` on, if nothing more is learned: what is known (`fix`), and what is still left of the
    way over to it, an axis a row: (a + b s + c s^2) exp(-rate s) after s seconds."""

    since: float
    fix: Fix
    left: tuple[Triple, Triple, Triple] = (_NOWHERE, _NOWHERE, _NOWHERE)

    def at(self, time: float) -> Point:
        time = min(time, self.fix.lost)
        gone, _, _ = self.fix.after(time)
        s = time - self.since
        decay = exp(-self.fix.rate * s)
        (x, y, z), (u, v, w) = self.fix.place, self.fix.speed
        (a, b, c), (d, e, f), (g, h, i) = self.left
        return Point(
            x + u * gone + (a + s * (b + s * c)) * decay,
            y + v * gone + (d + s * (e + s * f)) * decay,
            z + w * gone + (g + s * (h + s * i)) * decay,
        )

    def on(self, since: float, fix: Fix) -> Leg:
        """The leg that follows: from the place, the speed and the acceleration that this one has by then."""
        gone, part, change = self.fix.after(since)
        ahead, ahead_part, ahead_change = fix.after(since)
        rows = []
        for axis in range(3):
            place, drift, pull = _fading(self.left[axis], since - self.since, self.fix.rate)
            off = place + self.fix.place[axis] + self.fix.speed[axis] * gone
            speed = drift + self.fix.speed[axis] * part
            bend = pull + self.fix.speed[axis] * change
            known = fix.place[axis] + fix.speed[axis] * ahead
            speed -= fix.speed[axis] * ahead_part
            rows.append(_left(off - known, speed, bend - fix.speed[axis] * ahead_change, fix.rate))
        return Leg(since, fix, (rows[0], rows[1], rows[2]))


def _left(off: float, speed: float, bend: float, rate: float) -> Triple:
    """What fades from a place that is `off`, and from a speed and an acceleration."""
    b = speed + rate * off
    return off, b, (bend + 2.0 * rate * b - rate * rate * off) / 2.0


def _fading(left: Triple, s: float, rate: float) -> Triple:
    """Place, speed and acceleration of what fades, after s seconds."""
    a, b, c = left
    decay, value, slope = exp(-rate * s), a + s * (b + s * c), b + 2.0 * s * c
    speed = slope - rate * value
    return value * decay, speed * decay, (2.0 * c - 2.0 * rate * slope + rate * rate * value) * decay


class Trail:
    """A path that grows. `final` is up to when (s of the film) nothing of it changes any more, `learned` how often
    something was learned.

    `gaps` are the stretches in which she is lost, the last of them open to the end of time; before the first leg she is
    lost too.
    """

    def __init__(self) -> None:
        self.legs: list[Leg] = []
        self.final = -inf
        self.learned = 0
        self._since: list[float] = []
        self._gaps: list[tuple[float, float]] = []

    def learn(self, time: float, fix: Fix, jump: bool = False) -> None:
        """Go over to what is known at a `time` that is not before `final`; at once, where it is a `jump`."""
        last = self.legs[-1] if self.legs else None
        if last is None or last.fix.lost < time:
            self._gaps.append((last.fix.lost if last else -inf, time))
            jump = True
        self._add(Leg(time, fix) if jump or last is None else last.on(time, fix))

    def lose(self, time: float) -> None:
        """Nobody is to be seen any more from a time on."""
        last = self.legs[-1] if self.legs else None
        if last is not None and last.fix.lost > time:
            known = last.fix
            fix = Fix(known.time, known.place, known.speed, max(0.0, time - known.time), time + STOPPING)
            self._add(last.on(time, fix))

    def at(self, time: float, known: float = inf) -> Point:
        """Where she is at a time, by what was known at another; before she is seen first, she is there already."""
        if not self.legs or known < self._since[0]:
            return UNKNOWN
        leg = self.legs[self._index(min(time, known))]
        return leg.at(max(time, leg.since))

    def gap(self, time: float) -> tuple[float, float] | None:
        """The stretch, in which she is lost, that a time lies in."""
        return next((gap for gap in reversed(self.gaps()) if gap[0] <= time < gap[1]), None)

    def gaps(self) -> list[tuple[float, float]]:
        """The stretches in which she is lost, in time, as far as they have come."""
        if not self.legs:
            return [(-inf, inf)]
        lost = self.legs[-1].fix.lost
        return [*self._gaps, (lost, inf)] if lost <= self.final else self._gaps

    def _index(self, time: float) -> int:
        return max(0, bisect_right(self._since, time) - 1)

    def _add(self, leg: Leg) -> None:
        if leg.since < self.final:
            raise ValueError(f"a path that is final up to {self.final} s cannot be changed at {leg.since} s")
        if self._since and leg.since == self._since[-1]:
            self.legs.pop()
            self._since.pop()
        self.legs.append(leg)
        self._since.append(leg.since)
        self.final = leg.since
        self.learned += 1
        if leg.since - self._since[0] > 2 * KEPT:
            self._forget(leg.since - KEPT)

    def _forget(self, before: float) -> None:
        first = self._index(before)
        self.legs, self._since = self.legs[first:], self._since[first:]
        self._gaps = self._gaps[-MOST_GAPS:]
