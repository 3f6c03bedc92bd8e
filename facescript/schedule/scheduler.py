"""A play to its score: rounds of solving times and planning gaze, until a round learns nothing new."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from facescript.diagnostics.model import Diagnostics
from facescript.diagnostics.wording import tell
from facescript.ir.acts import Glance, Look, Scan, Sequence
from facescript.ir.play import Face, Play
from facescript.schedule.conflicts import left_out, lines_together, nothing_dropped, shows_together
from facescript.schedule.conflicts_apex import apexes_missed
from facescript.schedule.conflicts_gaze import looks_lost
from facescript.schedule.conflicts_voices import voices_together
from facescript.schedule.deeds import Deed
from facescript.schedule.defaults import Concrete
from facescript.schedule.drops import Key as Term
from facescript.schedule.drops import take_off
from facescript.schedule.events import Events
from facescript.schedule.facts import Facts
from facescript.schedule.faults import Faults
from facescript.schedule.haste import hurried
from facescript.schedule.labels import Labels, nodes
from facescript.schedule.lengths import PERSONS, Lengths
from facescript.schedule.looks import Gaze, landings, scene_at
from facescript.schedule.presence import Presence
from facescript.schedule.round import Round
from facescript.schedule.rules import Times
from facescript.schedule.score import Score
from facescript.schedule.sounds import sounds_unknown
from facescript.schedule.steps import NEVER, Key, Maker, TooMany
from facescript.schedule.voices import Voices
from facescript.schedule.writing import Writing
from facescript.space.plan import GazePlan
from facescript.space.planner import TooMuchGaze
from facescript.space.room import Room
from facescript.speech.model import VoiceBox

MOST = 20_000
"""Statements that a script may come to as it is played: an hour and a half with four a second."""

WORK, EACH = 75_000, 30
"""What all rounds together may cost, in statements solved (some ten microseconds): so much, and more for each
statement that a play has. Scripts come to rest after two to five rounds."""

LOOK, REACTION = 5, 5
"""What the plan of a look and the start of a reaction cost, in statements."""

LONGEST = 4 * 3600.0
"""Seconds of a film."""

MOVES = 8
"""So many movements of eyes and head may be worked out in all, for each statement that may be solved."""

STATEMENT = 20
"""To work out so many movements costs as much as a statement."""

RESTLESS = 12
"""After so many rounds without rest it is the script that has none; after fewer it is too long."""


def schedule(play: Play, voice: VoiceBox, diagnostics: Diagnostics) -> Score | None:
    """The score of a play, or None where its times cannot be solved (then `diagnostics` says why).

    Lines are spoken by `voice`; where that only estimates, the score is `estimated`, and conflicts that rest on it
    are warnings.
    """
    return _Scheduler(play, Voices(voice)).run(diagnostics)


@dataclass(slots=True)
class _Scheduler:
    play: Play
    voices: Voices
    concrete: Concrete = field(init=False)
    room: Room = field(init=False)
    faces: dict[str, Face] = field(init=False)
    labels: Labels = field(default_factory=Labels)
    faults: Faults = field(default_factory=Faults)
    idle: list[Deed] = field(default_factory=list)
    drops: dict[int, tuple[Term, ...]] = field(default_factory=dict)
    plans: dict[int, tuple[GazePlan, ...]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.concrete = Concrete(self.play.film.seed)
        self.faces = {face.name: face for face in self.play.faces}
        self.room = Room(self.play.film, self.play.faces, self.play.targets)

    def run(self, diagnostics: Diagnostics) -> Score | None:
        try:
            solved = self._rounds()
        except TooMany as fault:
            self.faults.add("FS412", fault.step.node.span, most=MOST)
            solved = None
        for span, failure in self.voices.failures:
            self.faults.voice(span, failure)
        for span, doubt in self.voices.doubts:
            self.faults.add(doubt.code, span, reason=doubt.reason)
        score = None
        if solved is not None and not self.faults.failed:
            self._check(solved)
            score = self._written(solved)
        self.faults.hand_over(diagnostics)
        return None if self.faults.failed else score

    def _written(self, solved: Round) -> Score:
        score = Writing(self.play, solved, self.concrete, self.plans, self.drops).score()
        if score.duration > LONGEST:
            self.faults.add("FS423", self.play.scenes[-1].span, lasts=tell(score.duration), longest=tell(LONGEST))
        return score

    def _rounds(self) -> Round | None:
        """Solve until nothing new is learned; None where an error stands in the way."""
        facts, work, rounds, last = Facts(), 0.0, 0, 0.0
        solved, most = None, WORK + EACH * sum(1 for block in self._blocks() for _ in nodes(block))
        self.room.left = MOVES * most
        while work + last <= most:
            solved, rounds = self._round(facts), rounds + 1
            last = MOST - solved.maker.left + REACTION * len(solved.reactions) + 1
            last += solved.times.lengths.presence.asked // PERSONS
            if self.faults.failed or self.voices.failures:
                return None
            learned = self._heard(solved, facts)
            if learned == facts:
                left = self.room.left
                try:
                    learned = replace(facts, looks=self._seen(solved))
                except TooMuchGaze:
                    break
                last += LOOK * sum(map(len, self.plans.values())) + (left - self.room.left) // STATEMENT
            if learned == facts:
                return solved
            facts, work = learned, work + last
        self._too_much(solved, rounds)
        return None

    def _blocks(self) -> list[Sequence]:
        return [*(scene.body for scene in self.play.scenes), *(reaction.body for reaction in self.play.reactions)]

    def _too_much(self, solved: Round | None, rounds: int) -> None:
        """Tell why the rounds were ended: times that find no rest, or too many of them."""
        first = self.play.scenes[0].span
        if solved is None or rounds >= RESTLESS:
            self.faults.add("FS419", first)
            return
        looks = sum(isinstance(deed.verb, (Look, Glance, Scan)) for deed in solved.done)
        counts = {"statements": len(solved.done), "looks": looks, "reactions": len(solved.reactions)}
        self.faults.add("FS422", first, **counts)

    def _round(self, facts: Facts) -> Round:
        self.faults = Faults()
        events = Events(self.play, self.concrete, self.faults)
        presence = Presence(self.room, events.comings(), facts.scenes)
        times = Times(Lengths(self.concrete, presence, facts), self.voices, self.labels, self.faults)
        long = NEVER if self.play.film.long is None else self.play.film.long
        solved = Round(self.play, times, Maker(self.play.film.seed, MOST), long)
        until = min(long, max(facts.until, events.last))
        solved.run(events.triggers(presence, until, MOST + 1))
        return solved

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
        self.plans = Gaze(self.faces, solved.times.lengths.presence, self.play.film.seed).plan(solved.done, starts)
        return landings(solved.done, self.plans)

    def _check(self, solved: Round) -> None:
        """Report what cannot be at one time, and what is left out."""
        sounds = list(solved.sounds())
        lines_together(sounds, self.faults)
        voices_together(sounds, self.faults)
        shows_together(solved.done, self.faults)
        looks_lost(solved.done, self.plans, self.faults)
        hurried(solved.done, self.faults)
        sounds_unknown(sounds, self.voices, self.play.visemes, self.faults)
        apexes_missed(solved.done, self.drops, self.faults)
        left_out(solved.late, solved.times.cut, solved.long, self.faults)
        nothing_dropped(self.idle, self.drops, solved.done, self.faults)
        for number, start in solved.unplayed[:1]:
            self.faults.unplayed(self.play.scenes[number], start, solved.long)
