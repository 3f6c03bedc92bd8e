"""Deeds whose statements are over to what is left of them: what is still shown, looked at, or on its way out."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from copy import copy
from dataclasses import dataclass, replace

from facescript.ir.acts import (
    Add,
    Drop,
    Gesture,
    Glance,
    Look,
    Perform,
    Scan,
    SetBackground,
    SetLife,
    SetPicture,
    Show,
    View,
)
from facescript.schedule.deeds import Deed
from facescript.schedule.defaults import seconds
from facescript.schedule.looks import gone
from facescript.schedule.score import FOREVER, TimedAct
from facescript.schedule.steps import NEVER, Key
from facescript.space.main_sequence import VERGENCE_TIME
from facescript.space.plan import GazePlan

QUIETED = 1.0
"""Seconds after a change in which something of what was before may be left: a life comes to rest."""

LAST = (SetLife, SetBackground, View, SetPicture)
"""Verbs of which the last one counts."""


@dataclass(frozen=True, slots=True)
class Worn:
    """A deed and its act, the key of its step, and of which of the play's reactions it is (None: of a scene)."""

    deed: Deed
    act: TimedAct
    key: Key
    reaction: int | None

    def at(self, time: float) -> Worn:
        """It again, let go of at a time where it is an add of a reaction that is started afresh then."""
        if not isinstance(self.deed.verb, Add) or self.deed.release < NEVER:
            return self
        return replace(self, deed=replace(self.deed, release=time))

    def written(self, deed: Deed, plan: tuple[GazePlan, ...], drops: tuple[tuple[int, int], ...]) -> TimedAct:
        """Its act by what has become of the deed."""
        end = self.act.end
        if isinstance(deed.verb, (Add, Perform)):
            end = deed.release + seconds(deed.verb.timing.back)
        elif plan:
            end = gone(plan, deed.release)
        return replace(self.act, scene=0, plan=plan, drops=drops, released=deed.release, end=end)


def worn(deed: Deed, act: TimedAct, key: Key, reaction: int | None) -> Worn:
    """A deed without the tree that it comes from."""
    root = copy(deed.root)
    root.scene = 0
    step = copy(deed.step)
    step.root, step.parent, step.before, step.clock, step.children = root, None, None, None, []
    root.top = step
    return Worn(replace(deed, step=step), act, key, reaction)


def still_worn(items: Iterable[Worn], live: Collection[int], owners: Collection[Key], time: float) -> Iterator[Worn]:
    """Those that matter from a time on. `live` are the orders of other deeds, `owners` the keys of looks that have eyes
    or head."""
    items = list(items)
    owners = {*owners, *_latest(items, "eye_onset", "head only"), *_latest(items, "head_onset", "eyes only")}
    kept = _uncovered([one for one in items if _lasts(one, owners, time)], time)
    falls = {term: one.act.settled for one in kept for term in one.act.drops}
    kept = [one for one in kept if not _dropped(one, falls, time)]
    orders = {*live, *(one.deed.order for one in kept)}
    for one in kept:
        if not isinstance(one.deed.verb, Drop) or one.act.settled > time or _refers(one, orders):
            yield one


def _latest(items: Iterable[Worn], onset: str, without: str) -> Iterator[Key]:
    """The look of each face that has sent its eyes, or its head, somewhere last."""
    found: dict[str | None, tuple[float, Key]] = {}
    for one in items:
        for plan in one.act.plan:
            known = found.get(one.deed.face)
            if plan.parts != without and (known is None or getattr(plan, onset) >= known[0]):
                found[one.deed.face] = getattr(plan, onset), one.key
    return (key for _, key in found.values())


def _refers(one: Worn, orders: Collection[int]) -> bool:
    return any(order in orders for order, _ in one.act.drops)


def _lasts(one: Worn, owners: Collection[Key], time: float) -> bool:
    """Whether anything of it is left at a time, by itself."""
    verb, act = one.deed.verb, one.act
    if isinstance(verb, (Show, Add, Perform, Gesture)):
        return act.end > time
    if isinstance(verb, (Look, Glance, Scan)):
        return one.key in owners or (act.end < FOREVER and act.end > time) or _moving(act, time)
    return isinstance(verb, (Drop, *LAST))


def _moving(act: TimedAct, time: float) -> bool:
    """Whether eyes or head still go where it sends them, or have just been sent elsewhere."""
    return any(max(plan.landed, plan.head_done, plan.eye_onset + VERGENCE_TIME) > time for plan in act.plan)


def _dropped(one: Worn, falls: dict[tuple[int, int], float], time: float) -> bool:
    """Whether all its terms were dropped, and are gone."""
    if not isinstance(one.deed.verb, Add) or not one.deed.verb.mix.terms:
        return False
    terms = range(len(one.deed.verb.mix.terms))
    return all(falls.get((one.deed.order, index), NEVER) < time for index in terms)


def _uncovered(items: list[Worn], time: float) -> list[Worn]:
    """Without what a later one has taken the place of for good."""
    items = sorted(items, key=lambda one: (one.act.start, one.act.order))
    found: list[Worn] = []
    covered: set[tuple[object, str | None]] = set()
    for one in reversed(items):
        base = isinstance(one.deed.verb, (Show, Perform))
        kind = (Show if base else type(one.deed.verb), one.deed.face)
        if kind in covered and isinstance(one.deed.verb, (Show, Perform, *LAST)):
            continue
        if isinstance(one.deed.verb, (Show, *LAST)) and _holds(one, time):
            covered.add(kind)
        found.append(one)
    return found[::-1]


def _holds(one: Worn, time: float) -> bool:
    """Whether what it covers is gone for good."""
    return one.act.released == FOREVER and one.act.settled + QUIETED < time
