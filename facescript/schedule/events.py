"""Scripted events to the reactions they start: who comes and goes, what is heard, who is nearest now."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

from facescript.ir.play import Event, EventPattern, Play, Reaction
from facescript.ir.wording import words
from facescript.schedule.defaults import Concrete
from facescript.schedule.faults import Faults
from facescript.schedule.presence import Coming, Presence
from facescript.schedule.steps import Maker, Root


@dataclass(frozen=True, slots=True)
class Happening:
    """An event at its time, seconds from the film's start."""

    kind: str
    time: float
    text: str = ""
    person: str | None = None


@dataclass(frozen=True, slots=True)
class Trigger:
    """A reaction that an event starts; `number` is the reaction's place among the script's."""

    time: float
    number: int
    reaction: Reaction
    person: str | None


class Events:
    """The scripted events of a play, in the order of their times; `last` is a second after the last of them."""

    def __init__(self, play: Play, concrete: Concrete, faults: Faults) -> None:
        self.play = play
        happenings = [happening(event, index, concrete) for index, event in enumerate(play.events)]
        self.scripted = sorted(happenings, key=lambda event: event.time)
        self.last = self.scripted[-1].time + 1.0 if self.scripted else 0.0
        self._report(faults, happenings)

    def comings(self) -> tuple[Coming, ...]:
        """Who arrives and leaves."""
        return tuple(
            Coming(event.time, event.person, event.kind == "arrives")
            for event in self.scripted
            if event.person is not None and event.kind in ("arrives", "leaves")
        )

    def triggers(self, presence: Presence, until: float, most: int) -> list[Trigger]:
        """The reactions that start before `until`, in the order they start; no more than `most` are looked for."""
        happenings = [event for event in self.scripted if event.time < until]
        if any(reaction.event.kind == "nearest" for reaction in self.play.reactions):
            happenings += [Happening("nearest", time, person=person) for time, person in presence.nearest(until)]
        happenings.sort(key=lambda event: event.time)
        started = (
            Trigger(event.time, number, reaction, event.person)
            for event in happenings
            for number, reaction in enumerate(self.play.reactions)
            if heeds(reaction.event, event)
        )
        return list(islice(started, most))

    def _report(self, faults: Faults, happenings: list[Happening]) -> None:
        long = self.play.film.long
        for event, happening in zip(self.play.events, happenings, strict=True):
            if long is not None and happening.time >= long:
                faults.event_late(event.span, happening.time, long)
            elif event.person is None and not any(heeds(one.event, happening) for one in self.play.reactions):
                faults.add("FS418", event.span)


def happening(event: Event, index: int, concrete: Concrete) -> Happening:
    time = concrete.amount(event.time, lambda: ("event", event.kind, event.text, event.person or ""), f"{index}")
    return Happening(event.kind, time, event.text, event.person)


def heeds(pattern: EventPattern, event: Happening) -> bool:
    """Whether a reaction waits for an event: of its kind, and its words without case and punctuation."""
    return pattern.kind == event.kind and _bare(pattern.text) == _bare(event.text)


@lru_cache(maxsize=4096)
def _bare(text: str) -> tuple[str, ...] | str:
    """The words of a text; a text without words, such as the name of a key, as it is."""
    return tuple(bare for bare, _, _ in words(text)) or text


def roots(triggers: list[Trigger], maker: Maker, long: float) -> Iterator[Root]:
    """A tree for each trigger, the later ones of higher rank. The same event again cuts its reaction short."""
    counts: Counter[int] = Counter()
    cuts = _cuts(triggers, long)
    for rank, trigger in enumerate(triggers, 1):
        counts[trigger.number] += 1
        cut = cuts[rank - 1]
        yield planted(trigger, rank, counts[trigger.number], maker, cut, cut < long)


def planted(trigger: Trigger, rank: int, count: int, maker: Maker, limit: float, afresh: bool) -> Root:
    """The tree of a reaction that was started `count` times so far; it is cut at `limit`, for its event where that
    starts it `afresh`."""
    event = trigger.reaction.event
    place = ("when", event.kind, event.text, trigger.number, count)
    persons = ((event.binds, trigger.person),) if event.binds and trigger.person else ()
    root = Root(rank, place, trigger.time, maker, True, persons)
    root.afresh = afresh
    root.plant(trigger.reaction.body, limit)
    return root


def _cuts(triggers: list[Trigger], long: float) -> list[float]:
    """When each trigger's reaction is started afresh; `long` where it never is."""
    following: dict[int, float] = {}
    cuts = []
    for trigger in reversed(triggers):
        cuts.append(following.get(trigger.number, long))
        following[trigger.number] = trigger.time
    return cuts[::-1]
