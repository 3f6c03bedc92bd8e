"""Scenes that hang together to a part of the film: rounds of solving times and planning gaze, until a round learns
nothing new."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from facescript.ir.acts import Glance, Look, Scan
from facescript.ir.play import Play
from facescript.schedule.calm import calm
from facescript.schedule.conflicts import left_out, lines_together, nothing_dropped, shows_together
from facescript.schedule.conflicts_apex import apexes_missed
from facescript.schedule.conflicts_gaze import looks_lost
from facescript.schedule.conflicts_voices import voices_together
from facescript.schedule.deeds import Deed, Sounding
from facescript.schedule.drops import Key as Term
from facescript.schedule.drops import take_off
from facescript.schedule.events import Events
from facescript.schedule.facts import Facts
from facescript.schedule.faults import EARLY, Faults
from facescript.schedule.haste import hurried
from facescript.schedule.labels import Labels
from facescript.schedule.lengths import PERSONS, Lengths
from facescript.schedule.looks import Gaze, landings, scene_at
from facescript.schedule.means import MOST, Budget, Means
from facescript.schedule.part import NOTHING, Calm, Cost, Opening, Part
from facescript.schedule.presence import Presence
from facescript.schedule.round import Round
from facescript.schedule.rules import Times
from facescript.schedule.sounds import sounds_unknown
from facescript.schedule.steps import Key, Maker, TooMany
from facescript.schedule.stretches import Stretch
from facescript.schedule.voices import Voices
from facescript.schedule.writing import Writing
from facescript.space.plan import GazePlan
from facescript.space.planner import Rest, TooMuchGaze

LOOK, REACTION = 5, 5
"""What the plan of a look and the start of a reaction cost, in statements."""

STATEMENT = 20
"""To work out so many movements costs as much as a statement."""

RESTLESS = 12
"""After so many rounds without rest it is the script that has none; after fewer it is too long."""


@dataclass(slots=True)
class Solving:
    """Solves the scenes and reactions of `play`, which last `long` seconds at most; `rough` is whether their start
    rests on an estimate. It is `spent` when the budget is. Of a scene they may be a `stretch`, which begins with the
    gaze of `rests`."""

    play: Play
    means: Means
    budget: Budget
    long: float
    rough: bool
    stretch: Stretch | None = None
    rests: Mapping[str, Rest] | None = None
    voices: Voices = field(init=False)
    work: float = 0.0
    solved: Round | None = None
    spent: bool = False
    faults: Faults = field(default_factory=Faults)
    idle: list[Deed] = field(default_factory=list)
    drops: dict[int, tuple[Term, ...]] = field(default_factory=dict)
    gaze: Gaze | None = None
    plans: dict[int, tuple[GazePlan, ...]] = field(default_factory=dict)
    labels: Labels = field(default_factory=Labels)

    def __post_init__(self) -> None:
        self.voices = Voices(self.means.voice, self.means.spoken)
        self.means.room.left = self.budget.moves

    def part(self) -> Part:
        failed = not self._at_rest()
        early = any(fault.code in EARLY for fault in self.faults.found.values())
        for span, failure in self.voices.failures:
            self.faults.voice(span, failure)
        for span, line, doubt in self.voices.doubts:
            self.faults.add(doubt.code, span, once=(line, doubt), reason=doubt.reason)
        return self._failed() if failed or self.solved is None else self._whole(self.solved, early)

    def _failed(self) -> Part:
        """What is known of scenes whose times cannot be solved."""
        end, rough = 0.0, self.rough
        scenes: tuple[Opening, ...] = ()
        if self.solved is not None:
            end, rough, scenes = self.solved.end, self.solved.rough, self._openings(self.solved)
        solving = tuple(self.faults.found.values())
        passing = self.spent or bool(self.voices.failures)
        return Part(
            scenes,
            NOTHING,
            end,
            rough,
            True,
            solving,
            (),
            (self.long, self.rough),
            self._cost(),
            passing=passing,
            spent=self.spent,
        )

    def _whole(self, solved: Round, early: bool) -> Part:
        sounds, checks = list(solved.sounds()), Faults()
        self._check(solved, sounds, checks)
        written = Writing(solved, sounds, self.play.film.seed, self.plans, self.drops).written()
        return Part(
            self._openings(solved),
            written,
            solved.end,
            solved.rough,
            False,
            tuple(self.faults.found.values()),
            tuple(checks.found.values()),
            (self.long, self.rough),
            self._cost(),
            tuple(self.voices.outside),
            tuple(act.order for act in written.acts if any(map(stray, act.plan))),
            calm=calm(solved, written, self.gaze) if self.stretch and self.gaze and not early else Calm(),
        )

    def _openings(self, solved: Round) -> tuple[Opening, ...]:
        return tuple(Opening(played.scene, played.root.start) for played in solved.scenes)

    def _cost(self) -> Cost:
        statements = self.budget.statements - self.solved.maker.left if self.solved else 0
        return Cost(statements, self.work, self.budget.moves - self.means.room.left)

    def _at_rest(self) -> bool:
        """Solve until nothing new is learned; False where an error stands in the way."""
        facts, rounds, last = Facts(), 0, 0.0
        room, solved = self.means.room, None
        try:
            while self.work + last <= self.budget.work:
                self.work += last
                solved, rounds = self._round(facts), rounds + 1
                last = self._took(solved)
                if self.faults.failed or self.voices.failures:
                    return False
                learned = self._heard(solved, facts)
                if learned == facts:
                    left = room.left
                    learned = replace(facts, looks=self._seen(solved))
                    last += LOOK * sum(map(len, self.plans.values())) + (left - room.left) // STATEMENT
                if learned == facts:
                    self.work += last
                    return True
                facts = learned
        except TooMany as fault:
            self.faults.add("FS412", fault.step.node.span, most=MOST)
            self.spent = True
            return False
        except TooMuchGaze:
            pass
        self._too_much(solved, rounds)
        return False

    def _took(self, solved: Round) -> float:
        """What a round's statements and reactions cost."""
        statements = self.budget.statements - solved.maker.left + REACTION * len(solved.reactions) + 1
        return statements + solved.times.lengths.presence.asked // PERSONS

    def _too_much(self, solved: Round | None, rounds: int) -> None:
        """Tell why the rounds were ended: times that find no rest, or too many of them."""
        self.spent = True
        first = self.play.scenes[0].span
        if solved is None or rounds >= RESTLESS:
            self.faults.add("FS419", first)
            return
        looks = sum(isinstance(deed.verb, (Look, Glance, Scan)) for deed in solved.done)
        counts = {"statements": len(solved.done), "looks": looks, "reactions": len(solved.reactions)}
        self.faults.add("FS422", first, **counts)

    def _round(self, facts: Facts) -> Round:
        self.faults = Faults()
        events = Events(self.play, self.means.concrete, self.faults)
        presence = Presence(self.means.room, events.comings(), facts.scenes)
        lengths = Lengths(self.means.concrete, presence, facts, self.means.paced)
        times = Times(lengths, self.voices, self.labels, self.faults)
        maker = Maker(self.play.film.seed, self.budget.statements)
        self.solved = Round(self.play, times, maker, self.long, self.rough)
        if self.stretch is not None:
            self.solved.after_line = self.stretch.after_line
            if self.stretch.names is not None:
                maker.call(self.play.scenes[0].body, self.stretch.names)
        until = min(self.long, max(facts.until, events.last))
        self.solved.run(events.triggers(presence, until, MOST + 1))
        return self.solved

    def _heard(self, solved: Round, facts: Facts) -> Facts:
        """Who speaks when. Gaze is planned only once that is known."""
        learned = replace(facts, delays=solved.delays(), holds=solved.holds())
        if any(reaction.event.kind == "nearest" for reaction in self.play.reactions):
            learned.scenes, learned.until = solved.starts(), solved.natural_end()
        return learned

    def _seen(self, solved: Round) -> dict[Key, float]:
        """How long the looks take, by the plan of all gaze."""
        starts = solved.starts()
        self.drops, self.idle = take_off((deed, scene_at(starts, deed)) for deed in solved.done)
        self.gaze = Gaze(self.means.faces, solved.times.lengths.presence, self.play.film.seed, self.rests)
        self.plans = self.gaze.plan(solved.done, starts)
        return landings(solved.done, self.plans)

    def _check(self, solved: Round, sounds: Sequence[Sounding], faults: Faults) -> None:
        """Report what cannot be at one time, and what is left out."""
        lines_together(sounds, faults)
        voices_together(sounds, faults)
        shows_together(solved.done, faults)
        looks_lost(solved.done, self.plans, faults)
        hurried(solved.done, faults)
        sounds_unknown(sounds, self.voices, self.play.visemes, faults)
        apexes_missed(solved.done, self.drops, faults)
        left_out(solved.late, solved.times.cut, solved.long, faults)
        nothing_dropped(self.idle, self.drops, solved.done, faults)
        for number, start in solved.unplayed[:1]:
            faults.unplayed(self.play.scenes[number], start, solved.long)


def stray(plan: GazePlan) -> bool:
    """Whether there is something to tell of a gaze shift: it stays short, or should be faster than it can be."""
    return plan.lost or plan.unreachable > 0.0 or plan.needs > 0.0
