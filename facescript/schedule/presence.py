"""Who is there: the persons whom scripted events bring and take away, and who of them is nearest."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import ceil, hypot, inf

from facescript.ir.values import AtTarget
from facescript.space.room import Room

STEP = 0.05
"""Seconds between two looks at who is nearest, while somebody moves."""

LOOKS = 20_000
"""As many persons are looked at in all; where there are more of them, or a longer film, less often."""


@dataclass(frozen=True, slots=True)
class Coming:
    """A person who arrives or leaves at a time."""

    time: float
    person: str
    arrives: bool


@dataclass(slots=True)
class Presence:
    """The crowd `people` over time. `scenes` are the starts of the scenes, from which targets move; `asked` counts how
    often it was looked how far somebody is."""

    room: Room
    comings: Sequence[Coming]
    scenes: Sequence[float] = (0.0,)
    asked: int = 0
    _times: list[float] = field(default_factory=list)
    _crowds: list[tuple[str, ...]] = field(default_factory=list)

    def __post_init__(self) -> None:
        there: tuple[str, ...] = ()
        for coming in self.comings:
            others = tuple(person for person in there if person != coming.person)
            there = (*others, coming.person) if coming.arrives else others
            self._times.append(coming.time)
            self._crowds.append(there)

    def people(self, time: float) -> tuple[str, ...]:
        """Who is there at a time, in the order of arrival."""
        index = bisect_right(self._times, time) - 1
        return self._crowds[index] if index >= 0 else ()

    def size(self, crowd: str, time: float) -> int:
        """How many a crowd has at a time."""
        return len(self.room.members(crowd, self.people(time)) or ())

    def clock(self, time: float) -> float:
        """Seconds since the start of the scene that plays at a time."""
        index = bisect_right(self.scenes, time) - 1
        return time - self.scenes[max(0, index)]

    def nearest(self, until: float) -> Iterator[tuple[float, str]]:
        """When another than before is the nearest of the people to the picture's centre, and who."""
        last = None
        for time in self._moments(until):
            people = self.people(time)
            now = min(people, key=lambda person: self._distance(person, time), default=None)
            if now is not None and now != last:
                yield time, now
            last = now

    def _distance(self, person: str, time: float) -> float:
        self.asked += 1
        aim, clock = AtTarget(person), self.clock(time)
        if self.room.lost(aim, clock):
            return inf
        point = self.room.point("", aim, clock)
        return hypot(point.x, point.y, point.z)

    def _moments(self, until: float) -> Iterator[float]:
        """The times to look at: who comes and goes, and often enough in between while somebody moves."""
        edges = sorted({time for time in (*self._times, *self.scenes) if time < until})
        most = max(map(len, self._crowds), default=0)
        moving = [self._moving(start, end) for start, end in pairwise([*edges, until])]
        step = max(STEP, most * sum(last - first for first, last in moving) / LOOKS)
        for edge, (first, last) in zip(edges, moving, strict=True):
            yield edge
            count = ceil((last - first) / step)
            yield from (first + number * step for number in range(1, count))

    def _moving(self, start: float, end: float) -> tuple[float, float]:
        """The part of [start, end) in which the order of the people may change; empty where nobody moves."""
        origin = start - self.clock(start)
        people = self.people(start)
        targets = [self.room.moving(AtTarget(person)) for person in people]
        spans = [(origin + target.times[0], origin + target.times[-1]) for target in targets if target]
        if len(people) < 2 or not spans:
            return start, start
        first = max(start, min(span[0] for span in spans))
        return first, max(first, min(end, max(span[1] for span in spans)))
