"""What one round of the solution learns for the next: how long looks take, and who takes whose voice."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import accumulate, islice
from typing import Literal

from facescript.schedule.steps import Key


@dataclass(frozen=True, slots=True)
class Hold:
    """A reaction has a face's voice from `start` to `end`, when all in it has settled.

    Lines of a lower rank that sound at `start` break off, and are begun again at `end`, `gap` seconds later. For
    `delay` seconds the reaction waited for the end of a word; where it waits longer, its end is expected as much later.
    """

    face: str
    rank: int
    start: float
    end: float
    gap: float
    delay: float = 0.0


@dataclass(frozen=True, slots=True)
class Control:
    """A reaction that ends in `stop` or `restart`, and when it does."""

    time: float
    kind: Literal["stop", "restart"]


class Holds:
    """The holds of each face in the order they start."""

    def __init__(self, holds: tuple[Hold, ...] = ()) -> None:
        self.all = holds
        self._rows: dict[str, list[Hold]] = {}
        for hold in holds:
            self._rows.setdefault(hold.face, []).append(hold)
        self._ends = {face: list(accumulate((hold.end for hold in row), max)) for face, row in self._rows.items()}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Holds) and self.all == other.all

    def after(self, face: str, time: float, rank: int) -> Iterator[Hold]:
        """The holds of a face from the first that is not over at a time, by reactions of a higher rank."""
        row = self._rows.get(face, [])
        first = bisect_right(self._ends.get(face, []), time)
        return (hold for hold in islice(row, first, None) if hold.rank > rank)


@dataclass(slots=True)
class Facts:
    """`looks` are the seconds until the eyes are there, by step; `delays` the earliest starts of lines that wait for
    the end of a word. `scenes` (their starts) and `until` (the end of all that is done) matter to who is nearest."""

    looks: dict[Key, float] = field(default_factory=dict)
    delays: dict[Key, float] = field(default_factory=dict)
    holds: Holds = field(default_factory=Holds)
    scenes: tuple[float, ...] = (0.0,)
    until: float = 0.0
