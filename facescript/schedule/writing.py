"""A solved round to the score: acts, lines, scenes and markers at their absolute times."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from facescript.ir.acts import (
    Add,
    AddLink,
    Glance,
    Look,
    Scan,
    SetBackground,
    SetLife,
    SetPicture,
    Show,
    Verb,
    View,
    in_pass,
)
from facescript.ir.acts import Sequence as Block
from facescript.ir.play import Play, Scene
from facescript.ir.random import chance
from facescript.schedule.deeds import Deed, walk
from facescript.schedule.defaults import Concrete, seconds
from facescript.schedule.looks import gone, scene_at
from facescript.schedule.round import Round
from facescript.schedule.score import FOREVER, Marker, Score, TimedAct, TimedBlock, TimedLine, TimedScene
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
    """What a score is written from: the last round, its gaze and its drops."""

    play: Play
    round: Round
    concrete: Concrete
    plans: Mapping[int, tuple[GazePlan, ...]]
    drops: Mapping[int, tuple[tuple[int, int], ...]]

    def score(self) -> Score:
        settings = list(self._settings())
        acts = [self._act(deed, len(settings)) for deed in self.round.done]
        lines = self._lines()
        duration = self._duration(acts, lines)
        return Score(
            self.play.film,
            self.play.faces,
            self.play.targets,
            tuple(self._scenes(duration)),
            tuple(sorted((*settings, *acts), key=lambda act: (act.start, act.order))),
            lines,
            tuple(self._markers()),
            duration,
            any(line.spoken.estimated for line in lines),
            self.play.visemes,
            tuple(self._blocks()),
        )

    # -------------------------------------------------------------------------------------------- acts

    def _act(self, deed: Deed, before: int) -> TimedAct:
        """The act of a deed; `before` acts are set before the first."""
        plan = self.plans.get(deed.order, ())
        return TimedAct(
            before + deed.order,
            deed.verb,
            deed.face,
            scene_at(self.round.starts(), deed),
            deed.start,
            deed.settled,
            deed.release,
            _end(deed, plan),
            deed.step.node.span,
            deed.label,
            plan,
            tuple((before + order, term) for order, term in self.drops.get(deed.order, ())),
            deed.root.persons,
            deed.step.rough(START),
            self._seed(deed),
        )

    def _seed(self, deed: Deed) -> int:
        """Where an expression lives by itself, the seed it lives by."""
        if not isinstance(deed.verb, (Show, Add)) or deed.verb.timing.manner != "spontaneous":
            return 0
        return int(chance(self.concrete.seed, deed.face, *deed.step.place(), "apex") * SEEDS)

    def _settings(self) -> Iterator[TimedAct]:
        """What holds from each scene's first moment, because it is written before the scenes."""
        order = 0
        for number, played in enumerate(self.round.scenes):
            scene, start = self.play.scenes[played.scene], played.root.start
            for verb, face in self._set(scene):
                settled = start + seconds(verb.over)
                yield TimedAct(order, verb, face, number, start, settled, FOREVER, FOREVER, scene.span)
                order += 1

    def _set(self, scene: Scene) -> list[tuple[SetBackground | View | SetLife, str | None]]:
        found: list[tuple[Verb | None, str | None]] = [
            (scene.background or self.play.background, None),
            (scene.view or self.play.view, None),
        ]
        found += [(SetLife(life), face) for face, life in self.play.lives if face in scene.faces]
        made = [(self.concrete.verb(verb, lambda: ("before", scene.name)), face) for verb, face in found if verb]
        return [(verb, face) for verb, face in made if isinstance(verb, (SetBackground, View, SetLife))]

    # -------------------------------------------------------------------------------------------- the rest

    def _lines(self) -> tuple[TimedLine, ...]:
        lines = []
        for sound in self.round.sounds():
            node = sound.step.node
            spoken = self.round.times.voices.speak(sound.line, node.span)
            label = in_pass(node.label, sound.step.passes) if node.label else None
            cut = sound.end if sound.cut else None
            said = sound.line
            lines.append(
                TimedLine(sound.face, sound.start, spoken, said.voice.volume, node.span, label, cut, said.text)
            )
        return tuple(sorted(lines, key=lambda line: line.start))

    def _scenes(self, duration: float) -> Iterator[TimedScene]:
        starts = (*self.round.starts()[1:], duration)
        for played, end in zip(self.round.scenes, starts, strict=True):
            scene = self.play.scenes[played.scene]
            yield TimedScene(scene.name, scene.faces, played.root.start, end, scene.title)

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
        found = []
        for step, _ in self._steps():
            time = step.sayings[-1][0] if step.sayings else step.time(START)
            if step.node.label and time < min(step.limit, NEVER):
                found.append(Marker(in_pass(step.node.label, step.passes), time))
        yield from sorted(found, key=lambda marker: marker.time)

    def _duration(self, acts: Sequence[TimedAct], lines: Sequence[TimedLine]) -> float:
        """Until all has been done and let go, or where the film is cut. After a `stop` life goes on."""
        long = self.round.long
        if self.round.stopped and long < NEVER:
            return long
        ends = [time for act in acts for time in (act.settled, act.end) if time < FOREVER]
        natural = max([self.round.natural_end(), *ends, *(line.end for line in lines)])
        return min(long, natural + (HOLD if self.round.stopped else 0.0))


def _end(deed: Deed, plan: tuple[GazePlan, ...]) -> float:
    """When nothing is left of an act."""
    if isinstance(deed.verb, (Show, Add)):
        return deed.release + seconds(deed.verb.timing.back)
    if isinstance(deed.verb, (Look, Glance, Scan)):
        return gone(plan, deed.release)
    return FOREVER if isinstance(deed.verb, LEFT_ON) else deed.settled
