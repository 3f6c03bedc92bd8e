"""A play that goes on to its score: its events come one by one, it is solved as far as a horizon, and forgets."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace

from facescript.ir.acts import Do, Glance, Look, Say, Scan
from facescript.ir.play import Play, Reaction
from facescript.ir.values import AtTarget
from facescript.schedule.deeds import Deed, Sounding
from facescript.schedule.defaults import Concrete
from facescript.schedule.drops import Key as Term
from facescript.schedule.drops import take_off
from facescript.schedule.events import Happening, Trigger, heeds, planted
from facescript.schedule.facts import Facts
from facescript.schedule.faults import Faults
from facescript.schedule.film import Placed, Timed
from facescript.schedule.forgetting import Forgetting, begin_of, reactions_over
from facescript.schedule.labels import Labels, nodes
from facescript.schedule.lengths import Lengths
from facescript.schedule.looks import Gaze, landings, scene_at
from facescript.schedule.means import Means
from facescript.schedule.part import Cost, Opening, Part, Written
from facescript.schedule.presence import Coming, Presence
from facescript.schedule.round import Begin, Round
from facescript.schedule.rules import Times
from facescript.schedule.score import Score, TimedAct, TimedLine
from facescript.schedule.steps import NEVER, Key, Maker, Past, Root
from facescript.schedule.voices import Voices
from facescript.schedule.worn import Worn, still_worn, worn
from facescript.schedule.writing import Writing
from facescript.space.live import LiveTarget
from facescript.space.plan import GazePlan
from facescript.space.planner import GazeRequest, Planning, plan_gaze
from facescript.space.room import Room
from facescript.speech.model import VoiceBox
from facescript.text import Span

STATEMENTS = 20_000
"""Statements that one solution may come to."""

ROUNDS = 60
"""So many rounds of solving at most: what is known after them is taken as it is, for the face goes on."""

BEYOND = 4.0
"""Seconds that a score is told to last beyond its horizon: life foresees nothing that is further away."""

TAIL = 6.0
"""Seconds that a line is still told of when it is over: mouth and life come to rest."""

PACED = 4096
"""Verbs of which it is kept how fast heads and eyes can do them."""


Told = Callable[[Happening], Iterable[tuple[int, Reaction]]]
"""What an event starts that the play does not know of: reactions, each with the number of those whose place it takes;
below 0, for the play's are counted from there."""


def nothing(event: Happening) -> tuple[tuple[int, Reaction], ...]:
    return ()


def lines_of(play: Play) -> Iterator[tuple[Say, Span]]:
    """All lines that a play may come to, and where they stand."""
    for block in (*(scene.body for scene in play.scenes), *(one.body for one in play.reactions)):
        for node, _ in nodes(block):
            if isinstance(node, Do) and isinstance(node.verb, Say):
                yield node.verb, node.span


@dataclass(slots=True)
class Heeded:
    """A reaction that an event has started, the `count`-th time for this reaction; at `limit` its event came again."""

    trigger: Trigger
    rank: int
    count: int
    limit: float = NEVER


@dataclass(frozen=True, slots=True)
class Outlook:
    """What a solution comes to: the round, the deeds that count (of statements that are over, too), the gaze shifts and
    the terms that drops let go by the orders of the deeds, the lines as they sound, and what each is told as."""

    round: Round
    deeds: list[tuple[Deed, Worn | None]]
    plans: dict[int, tuple[GazePlan, ...]]
    drops: dict[int, tuple[Term, ...]]
    acts: list[TimedAct] = field(default_factory=list)
    lines: list[tuple[Sounding, TimedLine]] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Forgotten:
    """What a score tells of no more: acts of the scene that plays (its name, and how often it was played before) and
    lines."""

    scene: tuple[str, int]
    acts: tuple[TimedAct, ...]
    lines: tuple[TimedLine, ...]


class Onwards:
    """A play whose `event` lines and length do not count: it lasts for ever, and is told what happens.

    What was solved of the time before an event is solved so again after it, for nothing in the law of time asks for
    what comes later; the events alone decide. So what is over can be forgotten, and nothing grows.
    """

    def __init__(self, play: Play, voice: VoiceBox, told: Told = nothing) -> None:
        self.play = replace(play, film=replace(play.film, long=None), events=())
        self.room = Room(self.play.film, play.faces, play.targets)
        self.room.live, self._own = True, play.targets
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
        self._worn: list[Worn] = []
        self._lines: list[TimedLine] = []
        self._gazes: dict[str, Planning] = {}
        self._outlook: Outlook | None = None
        self._facts = Facts()

    def meet(self, persons: Iterable[LiveTarget]) -> None:
        """Have persons in the room; one whom the script names too takes the place of that target."""
        self.room.targets.update((person.name, person) for person in persons)
        self.play = replace(self.play, targets=tuple(self.room.targets.values()))

    def part(self, persons: Iterable[str]) -> None:
        """Have persons in the room no more."""
        for person in persons:
            self.room.targets.pop(person, None)
            self.room.targets.update((own.name, own) for own in self._own if own.name == person)
        self.play = replace(self.play, targets=tuple(self.room.targets.values()))

    @property
    def looked_at(self) -> set[str]:
        """The targets that gaze may go back to."""
        aims = (aim for planning in self._gazes.values() for aim in planning.aims.values())
        return {aim.name for aim in aims if isinstance(aim, AtTarget)}

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
        self._worn = [one.at(event.time) if one.reaction == number else one for one in self._worn]
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
        facts = self._facts
        for _ in range(ROUNDS):
            solved = self._round(facts, horizon)
            learned = replace(facts, delays=solved.delays(), holds=solved.holds())
            if learned == facts:
                outlook = self._seen(solved)
                learned = replace(facts, looks=landings(solved.done, outlook.plans) | self._past.looks)
                if learned == facts:
                    self._facts = facts
                    return outlook
            facts = learned
        return self._seen(solved)

    def _round(self, facts: Facts, horizon: float) -> Round:
        self.faults = Faults()
        presence = Presence(self.room, self._comings, facts.scenes)
        lengths = Lengths(self._means.concrete, presence, facts, self._means.paced)
        times = Times(lengths, self.voices, self._labels, self.faults, horizon=horizon)
        maker = Maker(self.play.film.seed, STATEMENTS, self._past)
        orders = max((one.deed.order + 1 for one in self._worn), default=0)
        solved = Round(self.play, times, maker, NEVER, begin=self._begin, orders=orders)
        solved.run([one.trigger for one in self._heeded], self._roots(maker))
        return solved

    def _roots(self, maker: Maker) -> Iterator[Root]:
        for one in self._heeded:
            yield planted(one.trigger, one.rank, one.count, maker, one.limit, one.limit < NEVER)

    def _seen(self, solved: Round) -> Outlook:
        starts = solved.starts()
        deeds: list[tuple[Deed, Worn | None]] = [(replace(one.deed), one) for one in self._worn]
        deeds += ((deed, None) for deed in solved.done if deed.start >= self._begin.start)
        drops, _ = take_off((deed, scene_at(starts, deed)) for deed, _ in deeds)
        return Outlook(solved, deeds, self._gaze(solved, deeds), drops)

    # ------------------------------------------------------------------------------------------------ gaze

    def _gaze(self, solved: Round, deeds: list[tuple[Deed, Worn | None]]) -> dict[int, tuple[GazePlan, ...]]:
        """The shifts of each deed by its order; those that have begun stay as they are."""
        starts = solved.starts()
        orders = {_key(deed, known): deed.order for deed, known in deeds}
        plans: dict[int, tuple[GazePlan, ...]] = {}
        for name, requests in self._requests(solved, deeds).items():
            now = [request for request in requests if request.scene == 0]
            found = self._planning(name).fork().plan(now)
            later = [request for request in requests if request.scene > 0]
            found |= plan_gaze(self.room, self._means.faces[name], later, starts)
            for key in sorted(found):
                place = key[0]
                if isinstance(place, tuple) and place in orders:
                    order = orders[place]
                    plans[order] = (*plans.get(order, ()), *found[key])
        return plans

    def _planning(self, name: str) -> Planning:
        if name not in self._gazes:
            self._gazes[name] = Planning(self.room, self._means.faces[name], self._begin.start)
        return self._gazes[name]

    def _requests(self, solved: Round, deeds: list[tuple[Deed, Worn | None]]) -> Mapping[str, list[GazeRequest]]:
        """What deeds ask of each face's eyes and head; they are known by the places of their steps."""
        starts = solved.starts()
        gaze = Gaze(self._means.faces, solved.times.lengths.presence, self.play.film.seed)
        found: dict[str, list[GazeRequest]] = {}
        for deed, known in deeds:
            if isinstance(deed.verb, (Look, Glance, Scan)) and deed.face is not None:
                scene = scene_at(starts, deed)
                asked = gaze.requests(deed, scene, starts[scene])
                key = _key(deed, known)
                found.setdefault(deed.face, []).extend(replace(one, key=(key, one.key[1])) for one in asked)
        return found

    # ------------------------------------------------------------------------------------------------ what it gives

    def _score(self, outlook: Outlook, lasts: float) -> Score:
        solved = outlook.round
        starts = solved.starts()
        writing = Writing(solved, (), self.play.film.seed, outlook.plans, outlook.drops)
        for deed, known in outlook.deeds:
            plan, drops = outlook.plans.get(deed.order, ()), outlook.drops.get(deed.order, ())
            outlook.acts.append(known.written(deed, plan, drops) if known else writing.act(deed, starts))
        outlook.lines.extend((sound, writing.line(sound)) for sound in solved.sounds())
        lines = (*self._lines, *(line for _, line in outlook.lines))
        written = Written(tuple(outlook.acts), lines, (), (), lasts)
        openings = tuple(Opening(played.scene, played.root.start) for played in solved.scenes)
        part = Part(openings, written, solved.end, False, False, (), (), (NEVER, False), Cost())
        score = Timed(self.play, (Placed(part, 0.0, 0),), lasts).score()
        first, played = solved.first, solved.begin.played
        scenes = (
            replace(scene, again=played + number - first[opening.scene])
            for number, (scene, opening) in enumerate(zip(score.scenes, openings, strict=True))
        )
        return replace(score, scenes=tuple(scenes))

    # ------------------------------------------------------------------------------------------------ forgetting

    def forget(self, time: float) -> Forgotten:
        """What is over by a time is not solved again. All events before that time have been heeded."""
        outlook = self._outlook
        assert outlook is not None, "there is nothing to forget before the first solution"
        solved = outlook.round
        begin = begin_of(solved, time)
        forgetting = Forgetting(time)
        for played in solved.scenes[begin.played - self._begin.played :]:
            forgetting.tree(played.root)
        for root in solved.reactions:
            forgetting.tree(root)
        numbers = {one.rank: one.trigger.number for one in self._heeded}
        over = reactions_over(solved, numbers, forgetting)
        lines = self._forget_lines(outlook, forgetting)
        acts = self._forget_deeds(outlook, begin, forgetting, over)
        self._forget_past(solved, forgetting, over, time)
        self._begin = begin
        if any(one.trigger.number < 0 and one.rank in over for one in self._heeded):
            self._forget_told()
        self._heeded = [one for one in self._heeded if one.rank not in over]
        if len(self._means.paced) > PACED:
            self._means.paced.clear()
        scene = self.play.scenes[begin.scene]
        said = tuple(line for line in lines if line.start >= begin.start)
        return Forgotten((scene.name, begin.played - dict(begin.first)[begin.scene]), acts, said)

    def _forget_told(self) -> None:
        """What is known of statements by their identity is forgotten where some of them are no more."""
        own = {replace(line, cues=()) for line, _ in lines_of(self.play)}
        self.voices.forget(own)
        self._means.concrete = Concrete(self.play.film.seed)
        self._means.paced.clear()
        self._labels = Labels()

    def _forget_lines(self, outlook: Outlook, forgetting: Forgetting) -> tuple[TimedLine, ...]:
        """Lines that are not solved again are told of a little longer, and the last of each face as long as it is."""
        for sound, line in outlook.lines:
            step = id(sound.step)
            if step not in forgetting.live or sound.start < forgetting.said.get(step, 0.0):
                self._lines.append(line)
        last = {line.face: id(line) for line in sorted(self._lines, key=lambda line: line.end)}
        since = forgetting.time - TAIL
        gone = [line for line in self._lines if line.end <= since and id(line) != last[line.face]]
        self._lines = [line for line in self._lines if line not in gone]
        return tuple(gone)

    def _forget_deeds(
        self, outlook: Outlook, begin: Begin, forgetting: Forgetting, over: set[int]
    ) -> tuple[TimedAct, ...]:
        numbers = {one.rank: one.trigger.number for one in self._heeded}
        if begin.played != self._begin.played:
            self._gazes.clear()
        items: list[Worn] = []
        orders: set[int] = set()
        for (deed, known), act in zip(outlook.deeds, outlook.acts, strict=True):
            if deed.start < begin.start:
                continue
            if known is not None:
                items.append(replace(known, deed=deed, act=act))
            elif id(deed.step) not in forgetting.live or deed.root.rank in over:
                items.append(worn(deed, act, deed.step.key(), numbers.get(deed.root.rank)))
            else:
                orders.add(deed.order)
        self._pass_gaze(outlook, begin, forgetting.time)
        owners = {key[0] for gaze in self._gazes.values() for key in gaze.owners}
        self._worn = list(still_worn(items, orders, owners, forgetting.time))  # type: ignore[arg-type]
        kept = {one.deed.order for one in self._worn}
        return tuple(one.act for one in items if one.deed.order not in kept)

    def _pass_gaze(self, outlook: Outlook, begin: Begin, time: float) -> None:
        """What was planned of gaze before the time stays."""
        index = begin.played - self._begin.played
        before, self._begin = self._begin, begin
        for name, requests in self._requests(outlook.round, outlook.deeds).items():
            own = [replace(request, scene=0) for request in requests if request.scene == index]
            self._planning(name).pass_to(time, own)
        self._begin = before

    def _forget_past(self, solved: Round, forgetting: Forgetting, over: set[int], time: float) -> None:
        past = forgetting.past
        looks = landings(solved.done, self._outlook.plans) | self._past.looks  # type: ignore[union-attr]
        past.looks = {key: looks[key] for key in past.starts if key in looks}
        past.voiced = {
            (hold.rank, hold.face): (hold.start, hold.delay)
            for hold in solved.holds().all
            if hold.start < time and hold.rank not in over
        }
        self._past = past
        self._forget_comings(min((start for start in past.starts.values()), default=time))

    def _forget_comings(self, time: float) -> None:
        """Who came and left again is forgotten; who is there is known in the order of arrival."""
        there = Presence(self.room, self._comings).people(time)
        later = [coming for coming in self._comings if coming.time > time]
        last = {coming.person: coming for coming in self._comings if coming.time <= time and coming.arrives}
        self._comings = [*(last[person] for person in there), *later]


def _key(deed: Deed, known: Worn | None) -> Key:
    """Where a deed stands, the same in every solution."""
    return known.key if known is not None else deed.step.key()
