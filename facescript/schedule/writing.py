"""A solved round to what it gives to the score: acts, lines, markers and blocks, in seconds from the round's start."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from facescript.ir.acts import (
    Add,
    AddLink,
    Glance,
    Look,
    Perform,
    Scan,
    SetBackground,
    SetLife,
    SetPicture,
    Show,
    View,
    in_pass,
)
from facescript.ir.acts import Sequence as Block
from facescript.ir.random import chance
from facescript.schedule.deeds import Deed, Sounding, walk
from facescript.schedule.defaults import seconds
from facescript.schedule.looks import gone, scene_at
from facescript.schedule.part import Written
from facescript.schedule.round import Round
from facescript.schedule.score import FOREVER, Marker, TimedAct, TimedBlock, TimedLine
from facescript.schedule.steps import DONE, NEVER, SETTLED, START, Step
from facescript.space.plan import GazePlan

SEEDS = 2**53
"""So many seeds of acts there are: a draw has as many bits."""

LEFT_ON = (SetBackground, View, SetLife, SetPicture, AddLink)
"""Verbs whose acts hold until something takes their place."""

HOLD = 1.0
"""Seconds that life goes on after a `stop`, in a film that does not say how long it is."""


@dataclass(slots=True)
class Writing:
    """What is written from: the last round, its lines, its gaze and its drops."""

    round: Round
    sounds: Sequence[Sounding]
    seed: int
    plans: Mapping[int, tuple[GazePlan, ...]]
    drops: Mapping[int, tuple[tuple[int, int], ...]]

    def written(self) -> Written:
        starts = self.round.starts()
        acts = tuple(self.act(deed, starts) for deed in self.round.done)
        lines = tuple(self.line(sound) for sound in self.sounds)
        return Written(acts, lines, tuple(self._markers()), tuple(self._blocks()), self._lasts(acts, lines))

    def act(self, deed: Deed, scenes: Sequence[float]) -> TimedAct:
        """The act of a deed. `scenes` are the scenes' starts."""
        plan = self.plans.get(deed.order, ())
        return TimedAct(
            deed.order,
            deed.verb,
            deed.face,
            scene_at(scenes, deed),
            deed.start,
            deed.settled,
            deed.release,
            _end(deed, plan),
            deed.step.node.span,
            deed.label,
            plan,
            self.drops.get(deed.order, ()),
            deed.root.persons,
            deed.step.rough(START),
            self._seed(deed),
        )

    def _seed(self, deed: Deed) -> int:
        """Where an expression lives by itself, the seed it lives by."""
        if not isinstance(deed.verb, (Show, Add)) or deed.verb.timing.manner != "spontaneous":
            return 0
        return int(chance(self.seed, deed.face, *deed.step.place(), "apex") * SEEDS)

    def line(self, sound: Sounding) -> TimedLine:
        """A line as far as it sounds."""
        node, said = sound.step.node, sound.line
        spoken = self.round.times.voices.speak(said, node.span)
        label = in_pass(node.label, sound.step.passes) if node.label else None
        cut = sound.end if sound.cut else None
        return TimedLine(sound.face, sound.start, spoken, said.voice.volume, node.span, label, cut, said.text)

    def _blocks(self) -> Iterator[TimedBlock]:
        for step, _ in self._steps():
            node, start = step.node, step.time(START)
            if isinstance(node, Block) and node.clock and step.parent is not None and start < min(step.limit, NEVER):
                edge = SETTLED if step.time(SETTLED) < NEVER else DONE  # nobody asked when the last one settles
                rough = step.rough(START) or step.rough(edge)
                yield TimedBlock(node.span, start, min(step.time(edge), step.limit), rough)

    def _steps(self) -> Iterator[tuple[Step, tuple[str, ...]]]:
        return walk([*(played.root for played in self.round.scenes), *self.round.reactions])

    def _markers(self) -> Iterator[Marker]:
        """Every statement with a name, where it starts: a line that was broken off, where it is begun again."""
        for step, _ in self._steps():
            time = step.sayings[-1][0] if step.sayings else step.time(START)
            if step.node.label and time < min(step.limit, NEVER):
                yield Marker(in_pass(step.node.label, step.passes), time)

    def _lasts(self, acts: Sequence[TimedAct], lines: Sequence[TimedLine]) -> float:
        """Until all has been done and let go, or where the film is cut. After a `stop` life goes on."""
        long = self.round.long
        if self.round.stopped and long < NEVER:
            return long
        ends = [time for act in acts for time in (act.settled, act.end) if time < FOREVER]
        natural = max([self.round.natural_end(), *ends, *(line.end for line in lines)])
        return min(long, natural + (HOLD if self.round.stopped else 0.0))


def _end(deed: Deed, plan: tuple[GazePlan, ...]) -> float:
    """When nothing is left of an act."""
    if isinstance(deed.verb, (Show, Add, Perform)):
        return deed.release + seconds(deed.verb.timing.back)
    if isinstance(deed.verb, (Look, Glance, Scan)):
        return gone(plan, deed.release)
    return FOREVER if isinstance(deed.verb, LEFT_ON) else deed.settled
