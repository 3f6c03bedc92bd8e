"""Looks, glances and scans to their planned gaze shifts, and to how long each takes to land."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import accumulate

from facescript.ir.acts import Glance, Look, Scan
from facescript.ir.play import Face
from facescript.ir.values import Away
from facescript.schedule.deeds import Deed
from facescript.schedule.defaults import seconds
from facescript.schedule.dwells import dwells
from facescript.schedule.presence import Presence
from facescript.schedule.steps import NEVER, Key
from facescript.space.plan import GazePlan
from facescript.space.planner import GazeRequest, Rest, plan_gaze, plan_on
from facescript.space.scans import scan_stops

GRAIN = 4
"""Decimals of a look's length: times that differ by less are the same, so that rounds come to rest."""


@dataclass(slots=True)
class Gaze:
    """Plans the gaze of a film's faces. Where a scene is solved in stretches, `rests` is the gaze at rest that one
    begins with, `left` what it leaves, and `still` when that is at rest."""

    faces: Mapping[str, Face]
    presence: Presence
    seed: int
    rests: Mapping[str, Rest] | None = None
    left: dict[str, Rest] = field(default_factory=dict)
    still: float = 0.0

    def plan(self, deeds: Iterable[Deed], scenes: Sequence[float]) -> dict[int, tuple[GazePlan, ...]]:
        """The shifts of each deed by its order; a scan's stops one after another. `scenes` are the scenes' starts."""
        requests: dict[str, list[GazeRequest]] = {}
        for deed in deeds:
            if isinstance(deed.verb, (Look, Glance, Scan)) and deed.face is not None:
                scene = scene_at(scenes, deed)
                requests.setdefault(deed.face, []).extend(self.requests(deed, scene, scenes[scene]))
        plans: dict[int, tuple[GazePlan, ...]] = {}
        for name, asked in requests.items():
            if self.rests is None:
                planned = plan_gaze(self.presence.room, self.faces[name], asked, scenes)
            else:
                room, rest = self.presence.room, self.rests.get(name)
                planned, self.left[name], still = plan_on(room, self.faces[name], asked, rest)
                self.still = max(self.still, still)
            for order, stop in sorted(planned):
                assert isinstance(order, int), "requests of a round are known by the orders of its deeds"
                plans[order] = (*plans.get(order, ()), *planned[order, stop])
        return plans

    def requests(self, deed: Deed, scene: int, start: float) -> list[GazeRequest]:
        """What a deed of a scene that starts then asks of eyes and head; their keys are its order and their numbers."""
        verb, people, persons = deed.verb, self.presence.people(deed.start), deed.root.persons
        if isinstance(verb, Scan):
            return self._stops(deed, verb, scene, start)
        assert isinstance(verb, (Look, Glance))
        over = None if verb.timing.over is None else seconds(verb.timing.over)
        glance = isinstance(verb, Glance)
        place = deed.step.place() if isinstance(verb.aim, Away) else ()
        whole = (deed.start, deed.release, over, scene, glance, persons, people, place)
        return [GazeRequest((deed.order, 0), verb.aim, verb.manner, *whole)]

    def _stops(self, deed: Deed, scan: Scan, scene: int, start: float) -> list[GazeRequest]:
        """A request for each stop that begins before the scan lets go; they let go together, at its end."""
        assert deed.face is not None
        people, place = self.presence.people(deed.start), deed.step.place()
        room, clock = self.presence.room.of(start), deed.start - start
        aims = scan_stops(room, self.faces[deed.face], scan, clock, self.seed, people, place)
        starts = accumulate(dwells(scan, len(aims), self.seed, place), initial=deed.start)
        return [
            GazeRequest((deed.order, number), aim, scan.manner, start, deed.release, None, scene, False)
            for number, (aim, start) in enumerate(zip(aims, starts, strict=False))
            if start < deed.release
        ]


def scene_at(scenes: Sequence[float], deed: Deed) -> int:
    """The number of the scene that a deed belongs to: its own, or for a reaction the one that plays."""
    if not deed.root.reaction:
        return deed.root.scene
    return max(0, bisect_right(scenes, deed.start) - 1)


def landings(deeds: Iterable[Deed], plans: Mapping[int, tuple[GazePlan, ...]]) -> dict[Key, float]:
    """Seconds from the start of each look until the eyes are there, by its step."""
    return {
        deed.step.key(): round(max(0.0, plans[deed.order][0].landed - deed.start), GRAIN)
        for deed in deeds
        if isinstance(deed.verb, Look) and deed.order in plans
    }


def gone(plans: tuple[GazePlan, ...], release: float) -> float:
    """When nothing is left of a shift that lets go: eyes and head are back."""
    if release == NEVER:
        return NEVER
    back = [max(plan.landed, plan.head_done if plan.uses_head else 0.0) for plan in plans]
    return max([release, *back])
