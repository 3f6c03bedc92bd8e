"""A moving target to when a face has it in sight: the stretches in which it is lost or out of reach.

Gaze stays where a target was last, lets go of it, and finds it again once it is back (`language.md`, "Gaze").
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, inf

from facescript.space.path import Path
from facescript.space.reach import Direction, within

HOLD = 0.5
"""How long gaze stays where a target was last, s (a design choice: people go on for about so long)."""

LATENCY = 0.2
"""How long after a target is back the eyes leave for it, s (bar S7)."""

NOTICED = 0.4
"""A target that is back for a shorter time is not found again, s: gaze does not flicker."""

INSIDE = 3.0
"""A target that left reach is back when it is so far within, deg."""

STRIDE, MOST = 0.05, 1024
"""How far apart the moments are at which it is seen whether a target is within reach, s; so many at most between two
keys."""

EDGE = 0.0005
"""How exactly it is known when a target leaves and comes back, s."""

STEEP = 1.5
"""A place in front of the picture that is no further up or down than so many times its depth is within reach: 56 deg
and less."""


@dataclass(frozen=True, slots=True)
class Absence:
    """A target is not to be had from `start` to `end` (scene's clock, s); `lost` if nobody knows where it is."""

    start: float
    end: float
    lost: bool


class Sightings:
    """The absences of a target from one face's sight. `direction` is where it is by the scene's clock, `height` that
    of the face's eyes in cm."""

    def __init__(self, path: Path, direction: Callable[[float], Direction], height: float) -> None:
        self.path, self.direction, self.height = path, direction, height
        self._found: list[Absence] = []
        self._open: tuple[float, bool] | None = None
        self._scan()
        self.absences = tuple(self._found)
        self._starts = [absence.start for absence in self._found]

    def at(self, time: float) -> Absence | None:
        """The absence that lasts at a time."""
        index = bisect_right(self._starts, time) - 1
        return self.absences[index] if index >= 0 and time < self.absences[index].end else None

    def last(self, time: float) -> float:
        """When the target was last in sight: the time itself while it is."""
        absence = self.at(time) if self.absences else None
        return absence.start if absence else time

    def lets_go(self, since: float) -> tuple[float, Absence] | None:
        """When a gaze that is at the target since a time next lets go of it, and the absence that makes it do so."""
        for absence in self.absences[max(0, bisect_right(self._starts, since) - 1) :]:
            time = max(absence.start, since) + HOLD
            if time < absence.end:
                return time, absence
        return None

    def had(self, start: float, end: float) -> str:
        """How the target is in a stretch of time: "in sight" all the while, "at times", out of "reach", or "lost"."""
        gone = self.at(start)
        if gone and end <= gone.end:
            return "lost" if gone.lost else "reach"
        away = any(absence.start < end and absence.end > start for absence in self.absences)
        return "at times" if away else "in sight"

    # ------------------------------------------------------------------------------------------------ scanning

    def _scan(self) -> None:
        times, lost = self.path.times, self.path.lost
        if lost and lost[0][1] == times[0]:
            self._leave(lost[0][0], lost=True)
        self._note(times[0], times[0] if self._open else -inf)
        stretches = set(lost)
        for index, (start, end) in enumerate(pairwise(times)):
            if (start, end) in stretches:
                self._leave(start, lost=True)
                self._note(end, end)
            elif self._open or not self._near(index):
                self._look(start, end)
        if lost and lost[-1][0] == times[-1]:
            self._leave(times[-1], lost=True)
        if self._open:
            self._found.append(Absence(self._open[0], inf, self._open[1]))

    def _near(self, index: int) -> bool:
        """Whether the target is plainly within reach all the way from a key to the next."""
        one, other = self.path.places[index : index + 2]
        return STEEP * min(one.z, other.z) > max(abs(one.y - self.height), abs(other.y - self.height))

    def _look(self, start: float, end: float) -> None:
        """See when the target leaves and comes back between two keys."""
        count = min(MOST, ceil((end - start) / STRIDE))
        before = start
        for part in range(1, count + 1):
            time = start + (end - start) * part / count
            away = self._open is not None
            if self._away(time) != away:
                self._note(time, self._edge(before, time))
            before = time

    def _edge(self, before: float, time: float) -> float:
        away = self._open is not None
        while time - before > EDGE:
            middle = (before + time) / 2
            before, time = (middle, time) if self._away(middle) == away else (before, middle)
        return time

    def _away(self, time: float) -> bool:
        """Whether the target is out of reach, by a stricter measure once it has been."""
        direction = self.direction(time)
        return within(direction, INSIDE if self._open and not self._open[1] else 0.0) != direction

    def _note(self, time: float, edge: float) -> None:
        """Note whether the target is in sight at a time; if that is new, it is so since `edge`."""
        if self._away(time) == (self._open is not None):
            return
        if self._open is None:
            self._leave(edge, lost=False)
        else:
            self._found.append(Absence(self._open[0], edge, self._open[1]))
            self._open = None

    def _leave(self, time: float, lost: bool) -> None:
        """The target is away from a time on; as it was before, where it was back for too short a time to be found."""
        if self._open:
            return
        if self._found and time - self._found[-1].end < NOTICED:
            before = self._found.pop()
            self._open = before.start, before.lost
        else:
            self._open = time, lost
