"""Sightings to persons: targets of a run whose paths grow, smooth and foreseen, so that faces follow those they see."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection
from math import inf, nextafter

from facescript.live.model import Sighting
from facescript.live.persons.estimate import Estimate
from facescript.space.live import LiveTarget, live_target
from facescript.space.trail import Fix

RUNS_ON = 0.2
"""A person who is not seen again is taken to go on for so long, s, then she stops; longer where she is seen seldom."""

CALM_RATE, QUICK_RATE = 8.0, 24.0
"""How fast a path goes over to what is known of one who stands or goes evenly, and of one who does something new,
1/s."""

MOST_RUN = 1.0
"""But for no longer than that, s."""

PATIENCE, ROUNDS = 0.5, 4.0
"""Who is not seen for so long (s), and for so many times as long as it usually takes, is lost."""

NOTICED = 0.45
"""Who was found is not lost again any sooner, s: gaze does not flicker."""

NEAREST, FARTHEST = 5.0, 1e5
"""A place nearer to the screen than this, behind it, or further off, is none that anybody is seen at, cm."""

SOON = 0.1
"""A sighting is of no later time than so long after the last frame, s."""

MOST = 64
"""As many persons are known at once."""


class Persons:
    """All who are seen in a run, by their names. `version` changes when one is new, lost or found: plans of gaze that
    were made with another are to be made again. All times are seconds of the run."""

    def __init__(self, delay: float = 0.0) -> None:
        """`delay` is how old sightings are when they are told of, s, over what their times say."""
        self.version = 0
        self._delay = delay
        self._shown = 0.0
        self._targets: dict[str, LiveTarget] = {}
        self._estimates: dict[str, Estimate] = {}
        self._losses: dict[str, float] = {}
        self._counts: Counter[str] = Counter()

    @property
    def targets(self) -> tuple[LiveTarget, ...]:
        """Those a room has beside the script's targets; one whom the script names too takes the place of that."""
        return tuple(self._targets.values())

    def target(self, person: str) -> LiveTarget:
        """The target that a person is; one of whom nothing is known yet is lost so far."""
        known = self._targets.get(person)
        if known is None:
            known = self._targets[person] = live_target(person)
            self.version += 1
        return known

    def see(self, sighting: Sighting) -> None:
        """Learn where somebody was; it counts from the frame on that comes after the last one shown."""
        if not _seen(sighting):
            self._counts["sightings nowhere"] += 1
        elif sighting.person not in self._targets and len(self._targets) >= MOST:
            self._counts["sightings of too many"] += 1
        else:
            self._learn(sighting.person, min(sighting.time, self._shown + SOON) - self._delay, sighting)

    def _learn(self, person: str, time: float, sighting: Sighting) -> None:
        place = (sighting.place.x, sighting.place.y, sighting.place.z)
        estimate = self._estimates.get(person)
        if estimate is None:
            estimate = self._estimates[person] = Estimate(time, place, counts=self._counts)
        elif not estimate.take(time, place):
            return
        now = nextafter(self._shown, inf)
        found = person not in self._losses
        self.target(person).trail.learn(now, self._fix(estimate, now), estimate.leapt)
        self._losses[person] = self.target(person).trail.legs[-1].fix.lost
        self.version += found

    @staticmethod
    def _fix(estimate: Estimate, now: float) -> Fix:
        """What is known now: how long she goes on so, and when she is lost."""
        rate = CALM_RATE + estimate.stirred * (QUICK_RATE - CALM_RATE)
        if estimate.between is None:
            return Fix(estimate.time, estimate.place, estimate.speed, RUNS_ON, inf, rate)
        old = now - estimate.time
        runs = min(MOST_RUN, max(RUNS_ON, old + 1.5 * estimate.between))
        lost = max(estimate.time + max(PATIENCE, ROUNDS * estimate.between), now + NOTICED)
        return Fix(estimate.time, estimate.place, estimate.speed, runs, lost, rate)

    def leave(self, person: str) -> None:
        """Somebody is not there any more: she is lost, where she is not yet."""
        known = self._targets.get(person)
        if known is not None and person in self._losses:
            known.trail.lose(nextafter(self._shown, inf))
            self._losses[person] = known.trail.legs[-1].fix.lost
            self._estimates.pop(person, None)

    def pass_to(self, time: float) -> None:
        """The time of a frame that is to be shown: nothing up to it changes any more, and who is lost by then is."""
        self._shown = max(self._shown, time)
        for target in self._targets.values():
            target.trail.final = max(target.trail.final, self._shown)
        lost = [person for person, loss in self._losses.items() if loss <= self._shown]
        for person in lost:
            del self._losses[person]
        self.version += bool(lost)

    def forget(self, but: Collection[str]) -> list[str]:
        """Forget those who are lost, but for the ones named: those who are there, or are looked at. Gives whom."""
        gone = [name for name in self._targets if name not in self._losses and name not in but]
        for person in gone:
            del self._targets[person]
            self._estimates.pop(person, None)
        return gone

    def counts(self) -> dict[str, int]:
        """What was not believed, and why."""
        return dict(self._counts)


def _seen(sighting: Sighting) -> bool:
    """Whether a place is one at which somebody can be seen; not so a place that is no number."""
    place = sighting.place
    return NEAREST <= place.z <= FARTHEST and abs(place.x) <= FARTHEST and abs(place.y) <= FARTHEST
