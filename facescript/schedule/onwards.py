"""A play that goes on to its score: its events come one by one, and it is solved as far as a horizon."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace

from facescript.ir.play import Play, Reaction
from facescript.schedule.drops import take_off
from facescript.schedule.events import Happening, Trigger, heeds, planted
from facescript.schedule.facts import Facts
from facescript.schedule.faults import Faults
from facescript.schedule.film import Placed, Timed
from facescript.schedule.labels import Labels
from facescript.schedule.lengths import Lengths
from facescript.schedule.looks import Gaze, landings, scene_at
from facescript.schedule.means import Means
from facescript.schedule.part import Cost, Opening, Part
from facescript.schedule.presence import Coming, Presence
from facescript.schedule.round import Begin, Round
from facescript.schedule.rules import Times
from facescript.schedule.score import Score
from facescript.schedule.steps import NEVER, Maker, Past, Root
from facescript.schedule.voices import Voices
from facescript.schedule.writing import Writing
from facescript.space.plan import GazePlan
from facescript.space.room import Room
from facescript.speech.model import VoiceBox

STATEMENTS = 200_000
"""Statements that one solution may come to."""

ROUNDS = 12
"""So many rounds of solving at most: what is known after them is taken as it is, for the face goes on."""

BEYOND = 10.0
"""Seconds that a score is told to last beyond its horizon: life foresees nothing that is further away."""


Told = Callable[[Happening], Iterable[tuple[int, Reaction]]]
"""What an event starts that the play does not know of: reactions, each with the number of those whose place it takes;
below 0, for the play's are counted from there."""


def nothing(event: Happening) -> tuple[tuple[int, Reaction], ...]:
    return ()


@dataclass(slots=True)
class Heeded:
    """A reaction that an event has started, the `count`-th time for this reaction; at `limit` its event came again."""

    trigger: Trigger
    rank: int
    count: int
    limit: float = NEVER


@dataclass(frozen=True, slots=True)
class Outlook:
    """What a solution comes to: the round, the gaze shifts by the orders of the deeds, the terms that drops let go."""

    round: Round
    plans: dict[int, tuple[GazePlan, ...]]
    drops: dict[int, tuple[tuple[int, int], ...]]


class Onwards:
    """A play whose `event` lines and length do not count: it lasts for ever, and is told what happens.

    What was solved of the time before an event is solved so again after it, for nothing in the law of time asks for
    what comes later; the events alone decide.
    """

    def __init__(self, play: Play, voice: VoiceBox, told: Told = nothing) -> None:
        self.play = replace(play, film=replace(play.film, long=None), events=())
        self.room = Room(self.play.film, play.faces, play.targets)
        self._means = Means(self.play, voice, self.room)
        self.voices = Voices(voice, self._means.spoken)
        self.faults = Faults()
        self._labels = Labels()
        self._told = told
        self._begin, self._past = Begin(), Past()
        self._heeded: list[Heeded] = []
        self._comings: list[Coming] = []
        self._counts: Counter[int] = Counter()
        self._ranks = 0

    def heed(self, event: Happening) -> bool:
        """An event, at a time that is not before that of the last one; whether any reaction waits for it."""
        if event.person is not None and event.kind in ("arrives", "leaves"):
            self._comings.append(Coming(event.time, event.person, event.kind == "arrives"))
        waiting = ((number, one) for number, one in enumerate(self.play.reactions) if heeds(one.event, event))
        found = [*waiting, *self._told(event)]
        for number, reaction in found:
            self._start(number, reaction, event)
        return bool(found)

    def _start(self, number: int, reaction: Reaction, event: Happening) -> None:
        for before in self._heeded:
            if before.trigger.number == number and before.limit == NEVER:
                before.limit = event.time
        self._counts[number] += 1
        self._ranks += 1
        trigger = Trigger(event.time, number, reaction, event.person)
        self._heeded.append(Heeded(trigger, self._ranks, self._counts[number]))

    # ------------------------------------------------------------------------------------------------ solving

    def solve(self, horizon: float) -> Score:
        """The score up to a horizon, seconds of the run. Raises `TooMany`."""
        self._outlook = self._at_rest(horizon)
        return self._score(self._outlook, horizon + BEYOND)

    def _at_rest(self, horizon: float) -> Outlook:
        facts = Facts()
        outlook = None
        for _ in range(ROUNDS):
            solved = self._round(facts, horizon)
            learned = replace(facts, delays=solved.delays(), holds=solved.holds())
            if learned == facts:
                outlook = self._seen(solved)
                learned = replace(facts, looks=landings(solved.done, outlook.plans))
            if learned == facts and outlook is not None:
                return outlook
            facts = learned
        return self._seen(solved)

    def _round(self, facts: Facts, horizon: float) -> Round:
        self.faults = Faults()
        presence = Presence(self.room, self._comings, facts.scenes)
        lengths = Lengths(self._means.concrete, presence, facts, self._means.paced)
        times = Times(lengths, self.voices, self._labels, self.faults, horizon=horizon)
        maker = Maker(self.play.film.seed, STATEMENTS, self._past)
        solved = Round(self.play, times, maker, NEVER, begin=self._begin)
        solved.run([one.trigger for one in self._heeded], self._roots(maker))
        return solved

    def _roots(self, maker: Maker) -> Iterator[Root]:
        for one in self._heeded:
            yield planted(one.trigger, one.rank, one.count, maker, one.limit, one.limit < NEVER)

    def _seen(self, solved: Round) -> Outlook:
        starts = solved.starts()
        drops, _ = take_off((deed, scene_at(starts, deed)) for deed in solved.done)
        gaze = Gaze(self._means.faces, solved.times.lengths.presence, self.play.film.seed)
        return Outlook(solved, gaze.plan(solved.done, starts), drops)

    # ------------------------------------------------------------------------------------------------ what it gives

    def _score(self, outlook: Outlook, lasts: float) -> Score:
        solved = outlook.round
        sounds = list(solved.sounds())
        written = Writing(solved, sounds, self.play.film.seed, outlook.plans, outlook.drops).written()
        openings = tuple(Opening(played.scene, played.root.start) for played in solved.scenes)
        part = Part(openings, written, solved.end, False, False, (), (), (NEVER, False), Cost())
        score = Timed(self.play, (Placed(part, 0.0, 0),), lasts).score()
        first, played = solved.first, solved.begin.played
        scenes = (
            replace(scene, again=played + number - first[opening.scene])
            for number, (scene, opening) in enumerate(zip(score.scenes, openings, strict=True))
        )
        return replace(score, scenes=tuple(scenes))
