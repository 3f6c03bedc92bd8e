"""What one round of the solution learns for the next: how long looks take, and who takes whose voice."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from facescript.schedule.steps import Key


@dataclass(frozen=True, slots=True)
class Hold:
    """A reaction has a face's voice from `start` to `end`, when all in it has settled.

    Lines of a lower rank that sound at `start` break off, and are begun again at `end`, `gap` seconds later.
    """

    face: str
    rank: int
    start: float
    end: float
    gap: float


@dataclass(frozen=True, slots=True)
class Control:
    """A reaction that ends in `stop` or `restart`, and when it does."""

    time: float
    kind: Literal["stop", "restart"]


@dataclass(slots=True)
class Facts:
    """`looks` are the seconds until the eyes are there, by step; `delays` the earliest starts of lines that wait for
    the end of a word. `scenes` (their starts) and `until` (the end of all that is done) matter to who is nearest."""

    looks: dict[Key, float] = field(default_factory=dict)
    delays: dict[Key, float] = field(default_factory=dict)
    holds: tuple[Hold, ...] = ()
    scenes: tuple[float, ...] = (0.0,)
    until: float = 0.0
