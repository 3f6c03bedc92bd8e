"""Whether something differs from the background, picture by picture, to when somebody begins and ceases to be there."""

from __future__ import annotations

from dataclasses import dataclass

BEGINS, ENDS = 0.5, 3.0
"""Somebody is there who was for so long, and is not who was not for so long, s."""

PRESENT, ABSENT = "presence", "absence"
"""The signals of a script that waits for them: `when signal "presence":`."""


@dataclass(slots=True)
class Presence:
    """Whether anybody is there. One who comes and goes within `BEGINS` was not."""

    there: bool = False
    _since: float | None = None

    def step(self, somebody: bool, time: float) -> str | None:
        """The signal that a picture of a time (s) gives."""
        if somebody == self.there:
            self._since = None
            return None
        if self._since is None:
            self._since = time
        if time - self._since < (BEGINS if somebody else ENDS):
            return None
        self.there, self._since = somebody, None
        return PRESENT if somebody else ABSENT
