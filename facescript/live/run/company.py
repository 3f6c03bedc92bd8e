"""Who is there in a run: events and sightings to targets of its room, and to who is nearest."""

from __future__ import annotations

from math import ceil, floor, hypot, inf

from facescript.ir.play import Crowd
from facescript.ir.values import AtTarget
from facescript.live.model import Happening, Sighting
from facescript.live.persons.ahead import next_shift
from facescript.live.persons.nearest import Nearest
from facescript.live.persons.persons import Persons
from facescript.schedule.onwards import Onwards
from facescript.schedule.score import Score
from facescript.space.live import LiveTarget
from facescript.space.room import PEOPLE

STEP = 0.05
"""Seconds between two looks at who is nearest."""


class Company:
    """Those who are seen, and those who have arrived and not left."""

    def __init__(self, onwards: Onwards) -> None:
        self._onwards, self._persons = onwards, Persons()
        self._met = 0
        self._there: dict[str, None] = {}
        self._nearest = Nearest()
        self._asked = any(reaction.event.kind == "nearest" for reaction in onwards.play.reactions)
        self._looked = 0.0
        self._strange = 0

    def see(self, sighting: Sighting) -> None:
        if self.takes(sighting.person):
            self._persons.see(sighting)

    def doubts(self) -> dict[str, int]:
        """The sightings that were not believed, and why."""
        strange = {"named as a crowd is": self._strange} if self._strange else {}
        return self._persons.counts() | strange

    def takes(self, person: str | None) -> bool:
        """Whether a name can be a person's: no crowd's is."""
        crowd = person == PEOPLE or (person and isinstance(self._onwards.room.targets.get(person), Crowd))
        self._strange += bool(crowd)
        return not crowd

    def hear(self, event: Happening) -> None:
        """Somebody arrives or leaves."""
        person = event.person
        if person is not None and event.kind == "arrives":
            self._there[person] = None
            if person not in self._onwards.room.targets:
                self._persons.target(person)
        elif person is not None and event.kind == "leaves":
            self._there.pop(person, None)
            self._persons.leave(person)

    def pass_to(self, time: float) -> bool:
        """The time of the frame that is asked for; whether somebody is new, lost or found, so that all is to be planned
        anew."""
        self._persons.pass_to(time)
        return self._persons.version != self._met

    def meet(self) -> None:
        """Have all who were seen in the room."""
        self._met = self._persons.version
        self._onwards.meet(self._persons.targets)

    def next_shift(self, score: Score, time: float) -> float:
        """When the next shift of gaze begins, after a time, that is to be planned once more by then."""
        return next_shift(score, time)

    def forget(self, score: Score) -> None:
        """Forget those who are lost, are not there any more, and are not looked at."""
        looked = {plan.aim.name for act in score.acts for plan in act.plan if isinstance(plan.aim, AtTarget)}
        self._onwards.part(self._persons.forget({*self._there, *looked, *self._onwards.looked_at}))

    def nearest(self, score: Score, time: float) -> Happening | None:
        """Another than before who is nearest to the picture's centre by a time."""
        found = None
        first, last = ceil(self._looked / STEP), floor(time / STEP)
        self._looked = max(self._looked, (last + 1) * STEP)
        for moment in range(first, last + 1) if self._asked else ():
            far = {person: self._far(score, person, moment * STEP) for person in self._there}
            if self._nearest.look(moment * STEP, far):
                found = Happening("nearest", time, person=self._nearest.person)
        return found

    def _far(self, score: Score, person: str, time: float) -> float:
        """How far off somebody is, cm; one who is lost is infinitely far."""
        start = max((scene.start for scene in score.scenes if scene.start <= time), default=0.0)
        room, aim = self._onwards.room, AtTarget(person)
        target = room.targets.get(person)
        if target is None or (isinstance(target, LiveTarget) and target.trail.gap(time)):
            return inf
        point = room.of(start).point("", aim, time - start)
        return hypot(point.x, point.y, point.z)
