"""How far persons are, time after time, to who is nearest: another only where she is plainly nearer."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf

NEARER = 0.1
"""Another is the nearest who is nearer by this part of the distance."""

LONG = 0.3
"""And has been so for so long, s."""


class Nearest:
    """Who is nearest: None while nobody is there."""

    def __init__(self) -> None:
        self.person: str | None = None
        self._other: str | None = None
        self._since = 0.0

    def look(self, time: float, far: Mapping[str, float]) -> bool:
        """Look at how far (cm) all who are there are at a time (s), not before the last; whether another is nearest
        now. One who is lost counts as infinitely far."""
        other = min(far, key=lambda person: far[person], default=None)
        if other is None or self.person is None or self.person not in far:
            return self._turn(other)
        here = far[self.person]
        if other == self.person or not far[other] < (1.0 - NEARER) * here:
            self._other = None
            return False
        if other != self._other:
            self._other, self._since = other, time
        if here < inf and time < self._since + LONG:
            return False
        return self._turn(other)

    def _turn(self, person: str | None) -> bool:
        """Somebody, or nobody, is nearest now."""
        turned = person is not None and person != self.person
        self.person, self._other = person, None
        return turned
