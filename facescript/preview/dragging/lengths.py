"""A statement to the edit that makes it last longer or shorter: another number of its `for`, `over` or `each`."""

from __future__ import annotations

from facescript.ir.acts import Add, Drop, Gesture, Glance, Look, Perform, Scan, SetBackground, SetLife, Show, Verb, View
from facescript.preview.dragging.allowed import Said
from facescript.preview.dragging.amounts import Change, Stuck, number, time
from facescript.schedule.score import FOREVER, TimedAct

SHORTEST = 0.01
"""Seconds that anything lasts."""


def modifier_of(verb: Verb) -> str:
    """The modifier that says how long an act lasts; "" for what has no length of its own."""
    if isinstance(verb, (Look, Glance, Show, Add, Gesture, Perform)):
        return "for"
    if isinstance(verb, (Drop, SetBackground, SetLife, View)):
        return "over"
    return "each" if isinstance(verb, Scan) else ""


def is_open(act: TimedAct) -> bool:
    """Whether an act lasts until something takes its place."""
    return isinstance(act.verb, (Look, Show, Add)) and act.verb.timing.lasting is None


def end_of(act: TimedAct) -> float:
    """When an act is over: when it lets go, or has changed what it changes."""
    if isinstance(act.verb, (Look, Glance, Show, Add, Perform)) and act.released < FOREVER:
        return act.released
    return act.settled


def stops(act: TimedAct) -> int:
    """How often the number that says how long an act lasts counts: the last movement of a scan is the way back."""
    return max(1, len(act.plan) - 1) if isinstance(act.verb, Scan) else 1


def lasting(said: Said, act: TimedAct, seconds: float) -> Change:
    """What makes an act last so long. Raises `Stuck`."""
    name = modifier_of(act.verb)
    if not name:
        raise Stuck("how long it lasts is the voice's; `rate` in its line changes that.")
    if seconds < SHORTEST:
        raise Stuck("nothing would be left of it.")
    words = said.modifier(name)
    if words is not None:
        found = number(words, said.script, "how long it lasts")
        more = (seconds - (end_of(act) - act.start)) / stops(act)
        return found.changed(found.value + more if found.first is not None else seconds / stops(act))
    if said.standing is None:
        raise Stuck("it ends with the words that it stands over: write a `for` into its bracket.")
    new = time(seconds / stops(act))
    place = said.behind()
    return Change(place, place, f", {new} each" if name == "each" else f" {name} {new}")
