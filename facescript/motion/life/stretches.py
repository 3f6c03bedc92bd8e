"""Turns stretches of time that may overlap into ones that do not, and finds them by a time."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator
from math import inf

Stretch = tuple[float, float]
"""Start and end, seconds from the film's start."""


class Stretches:
    """Stretches of time in order, none of which overlap: those that do are made one."""

    def __init__(self, stretches: Iterable[Stretch]) -> None:
        self._all: list[Stretch] = []
        for start, end in sorted(stretches):
            if self._all and start <= self._all[-1][1]:
                self._all[-1] = self._all[-1][0], max(end, self._all[-1][1])
            else:
                self._all.append((start, end))
        self._starts = [start for start, _ in self._all]
        self._ends = [end for _, end in self._all]

    def __iter__(self) -> Iterator[Stretch]:
        return iter(self._all)

    def within(self, start: float, end: float) -> list[Stretch]:
        """Those that have a part between `start` and `end`."""
        return self._all[bisect_right(self._ends, start) : bisect_left(self._starts, end)]

    def next(self, time: float) -> Stretch:
        """The first that ends after `time`; one that never comes where there is none."""
        index = bisect_right(self._ends, time)
        return self._all[index] if index < len(self._all) else (inf, inf)

    def last_end(self, time: float) -> float:
        """When the last that has ended by `time` did; long ago where none has."""
        index = bisect_right(self._ends, time)
        return self._ends[index - 1] if index else -inf

    def between(self, start: float, end: float) -> Iterator[Stretch]:
        """What they leave free between `start` and `end`."""
        free = start
        for begun, ended in self.within(start, end):
            if begun > free:
                yield free, begun
            free = max(free, ended)
        if free < end:
            yield free, end


NEVER = Stretches(())
"""No stretch at all."""
