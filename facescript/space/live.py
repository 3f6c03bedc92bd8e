"""A person who is seen now, as a target: her trail by a scene's clock, and when a face has her in sight."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field
from math import inf

from facescript.ir.play import MovingTarget
from facescript.ir.values import Point
from facescript.space.sightings import HOLD, Absence
from facescript.space.trail import Trail
from facescript.text import Source, Span

NOWHERE = Span(Source("", ""), 0, 0)
"""No script says of her."""


@dataclass(frozen=True, slots=True, eq=False)
class LiveTarget(MovingTarget):
    """A moving target whose keys come one by one: where it is, its `trail` says, by the film's time and not the scene's
    clock. `pursuits` is what was worked out of following it, kept by those who do."""

    trail: Trail = field(default_factory=Trail, kw_only=True)
    pursuits: dict[Hashable, object] = field(default_factory=dict, kw_only=True)

    __eq__ = object.__eq__
    __hash__ = object.__hash__


def live_target(name: str) -> LiveTarget:
    """A person of whom nothing is known yet."""
    return LiveTarget(name, (0.0, inf), (), NOWHERE)


class Whereabouts:
    """A trail by the clock of a scene that starts at `start` s of the film, as `path.Path` has it. Up to `now` (s of
    the clock) it says where the person was, of later times what was to be expected then."""

    def __init__(self, trail: Trail, start: float, now: float) -> None:
        self.trail, self.start, self.now = trail, start, now

    def at(self, time: float) -> Point:
        return self.trail.at(self.start + time, self.start + self.now)

    def known(self, time: float) -> float:
        """The time up to `time` at which it was last known where she is."""
        gap = self.trail.gap(self.start + time)
        return gap[0] - self.start if gap else time


class LiveSightings:
    """The absences of a person, as `sightings.Sightings` has those of a target; she is absent where she is lost. Out of
    reach she is followed to its end: what comes of her later is not known yet."""

    def __init__(self, path: Whereabouts) -> None:
        self.path = path

    def at(self, time: float) -> Absence | None:
        """The absence that lasts at a time."""
        gap = self.path.trail.gap(self.path.start + time)
        return self._absence(gap) if gap else None

    def last(self, time: float) -> float:
        """When she was last in sight: where she is lost, her trail stays there by itself."""
        return time

    def lets_go(self, since: float) -> tuple[float, Absence] | None:
        """When a gaze that is at her since a time next lets go of her, and the absence that makes it do so."""
        for absence in map(self._absence, self.path.trail.gaps()):
            time = max(absence.start, since) + HOLD
            if time < absence.end:
                return time, absence
        return None

    def had(self, start: float, end: float) -> str:
        """How she is in a stretch of time: "in sight" all the while, "at times", or "lost"."""
        gone = self.at(start)
        if gone and end <= gone.end:
            return "lost"
        away = any(gap.start < end and gap.end > start for gap in map(self._absence, self.path.trail.gaps()))
        return "at times" if away else "in sight"

    def _absence(self, gap: tuple[float, float]) -> Absence:
        return Absence(gap[0] - self.path.start, gap[1] - self.path.start, True)
