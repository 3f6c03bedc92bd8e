"""How long each verb takes until the next statement may start (the table of what settles when)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from facescript.ir.acts import (
    Add,
    AddLink,
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
    Verb,
    View,
    Wait,
)
from facescript.ir.values import AtTarget
from facescript.schedule.defaults import Concrete, seconds
from facescript.schedule.dwells import dwells
from facescript.schedule.facts import Facts, Hold
from facescript.schedule.haste import unhurried
from facescript.schedule.presence import Presence
from facescript.schedule.steps import NEVER, START, Step
from facescript.schedule.voices import word_end
from facescript.speech.model import Spoken

LANDING = 0.1
"""Seconds until the eyes are there, before the first plan of a look is made."""

PERSONS, TERMS = 3, 8
"""To look how far so many persons are, and to time so many terms of a sum, costs as much as a statement."""

PAUSE = 0.25
"""Seconds between a line and a line that directly follows it."""


@dataclass(slots=True)
class Lengths:
    """Lengths of verbs at the times they start. `paced` are concrete verbs with what `unhurried` makes of them."""

    concrete: Concrete
    presence: Presence
    facts: Facts
    paced: dict[int, tuple[Verb, Verb]]

    def settle(self, step: Step, verb: Verb) -> float:
        """Seconds from a step's start until it has settled; its verb is made concrete on the way. Not for lines."""
        start = step.time(START)
        step.verb = verb = self._made(step, verb, start)
        step.root.maker.take(step, self._weight(verb, start))
        if isinstance(verb, (Look, Glance, Show, Add, Gesture, Perform)) and verb.timing.lasting is not None:
            return seconds(verb.timing.lasting)
        if isinstance(verb, Look):
            return self.facts.looks.get(step.key(), LANDING)
        if isinstance(verb, (Show, Add, Drop)):
            return seconds(verb.timing.over)
        if isinstance(verb, Scan):
            return sum(dwells(verb, self.presence.size(verb.crowd, start), self.concrete.seed, step.place()))
        if isinstance(verb, (SetBackground, View, SetLife)):
            return seconds(verb.over)
        if isinstance(verb, (SetPicture, AddLink)):
            return 0.0
        assert isinstance(verb, Wait)
        return seconds(verb.duration)

    def _made(self, step: Step, verb: Verb, start: float) -> Verb:
        """The verb with plain numbers that heads and eyes can follow; worked out once where it is always the same."""
        made = self.concrete.verb(verb, step.place)
        whole = ended(verb, made, start, step.until)
        if whole is not made:
            return unhurried(whole)
        known = self.paced.get(id(made))
        if known is None:
            known = self.paced[id(made)] = made, unhurried(made)
        return known[1]

    def _weight(self, verb: Verb, start: float) -> int:
        """As how many more statements a verb counts: a stop of a scan is one, and so are a few of a crowd of which the
        nearest is sought, and several terms of a sum."""
        if isinstance(verb, Scan):
            return self.presence.size(verb.crowd, start)
        if isinstance(verb, (Look, Glance)) and isinstance(verb.aim, AtTarget) and verb.aim.member == "nearest":
            return self.presence.size(verb.aim.name, start) // PERSONS
        return len(verb.mix.terms) // TERMS if isinstance(verb, (Show, Add)) else 0


def ended(verb: Verb, made: Verb, start: float, until: float) -> Verb:
    """A concrete verb in an inline cue that ends at `until`: so does a glance or a gesture. `verb` is as written."""
    if until == NEVER or not isinstance(verb, (Glance, Gesture)) or not isinstance(made, (Glance, Gesture)):
        return made
    length = max(0.0, until - start)
    if verb.timing.lasting is not None:
        length = min(length, seconds(made.timing.lasting))
    return replace(made, timing=replace(made.timing, lasting=length))


def sayings(
    start: float, spoken: Spoken, limit: float, holds: Iterable[Hold]
) -> tuple[tuple[float, float | None], ...]:
    """The starts and cuts of a line that is due at `start`, while later reactions take its face's voice.

    A line that sounds when a reaction begins to speak breaks off at the end of its word; it is begun again when that
    reaction has settled, and so is a line that is due in between. A line whose last word is over is not broken off.
    `holds` are those of the face, in the order they start; from `limit` on nothing starts.
    """
    broken = []
    voiced = spoken.words[-1].end if spoken.words else spoken.duration
    for hold in holds:
        if hold.end <= start:
            continue
        if start + voiced <= hold.start or start >= limit:
            break
        end = hold.end
        if start < hold.start:
            cut = start + word_end(spoken, hold.start - start)
            broken.append((start, cut))
            end += cut - hold.start - hold.delay
        start = end + hold.gap
    return (*broken, (start, None))
