"""The solved parts of a film to its score: what each gives, moved to where the part starts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from facescript.ir.acts import SetBackground, SetLife, Verb, View
from facescript.ir.play import Face, Play, Scene, Target
from facescript.schedule.defaults import Concrete, seconds
from facescript.schedule.part import Part, act_at, block_at, line_at
from facescript.schedule.score import FOREVER, Marker, Score, TimedAct, TimedScene


@dataclass(frozen=True, slots=True)
class Cast:
    """Some acts of a film, its faces and its targets."""

    acts: tuple[TimedAct, ...]
    faces: tuple[Face, ...]
    targets: tuple[Target, ...]


@dataclass(frozen=True, slots=True)
class Placed:
    """A part, its start, and the number of the scene that it begins with or, where it does not begin it, goes on."""

    part: Part
    start: float
    scene: int
    begins: bool = True


@dataclass(frozen=True, slots=True)
class Timed:
    """A play whose times are solved."""

    play: Play
    parts: tuple[Placed, ...]
    duration: float

    def astray(self) -> Cast:
        """The acts whose gaze shifts stay short of their target, or should be faster than eyes or head are."""
        acts = [
            act_at(one.part.written.acts[order], one.start, 0, 0) for one in self.parts for order in one.part.astray
        ]
        return Cast(tuple(sorted(acts, key=lambda act: act.start)), self.play.faces, self.play.targets)

    def score(self) -> Score:
        openings = [(one, opening) for one in self.parts if one.begins for opening in one.part.scenes]
        scenes = [(one.scene + opening.scene, one.start + opening.start) for one, opening in openings]
        settings = tuple(self._settings(scenes))
        lines = [line_at(line, one.start) for one in self.parts for line in one.part.written.lines]
        markers = [Marker(at.name, one.start + at.time) for one in self.parts for at in one.part.written.markers]
        acts = (*settings, *self._acts(len(settings)))
        return Score(
            self.play.film,
            self.play.faces,
            self.play.targets,
            tuple(self._scenes(scenes)),
            tuple(sorted(acts, key=lambda act: (act.start, act.order))),
            tuple(sorted(lines, key=lambda line: line.start)),
            tuple(sorted(markers, key=lambda marker: marker.time)),
            self.duration,
            any(line.spoken.estimated for line in lines),
            self.play.visemes,
            tuple(block_at(block, one.start) for one in self.parts for block in one.part.written.blocks),
        )

    def _acts(self, before: int) -> Iterator[TimedAct]:
        """The acts of all parts, in the order written; `before` acts are set before the first."""
        for one in self.parts:
            yield from (act_at(act, one.start, one.scene, before) for act in one.part.written.acts)
            before += len(one.part.written.acts)

    def _settings(self, scenes: Sequence[tuple[int, float]]) -> Iterator[TimedAct]:
        """What holds from each scene's first moment, because it is written before the scenes."""
        order, concrete = 0, Concrete(self.play.film.seed)
        for number, (which, start) in enumerate(scenes):
            scene = self.play.scenes[which]
            for verb, face in self._set(scene, concrete):
                settled = start + seconds(verb.over)
                yield TimedAct(order, verb, face, number, start, settled, FOREVER, FOREVER, scene.span)
                order += 1

    def _set(self, scene: Scene, concrete: Concrete) -> list[tuple[SetBackground | View | SetLife, str | None]]:
        found: list[tuple[Verb | None, str | None]] = [
            (scene.background or self.play.background, None),
            (scene.view or self.play.view, None),
        ]
        found += [(SetLife(life), face) for face, life in self.play.lives if face in scene.faces]
        made = [(concrete.verb(verb, lambda: ("before", scene.name)), face) for verb, face in found if verb]
        return [(verb, face) for verb, face in made if isinstance(verb, (SetBackground, View, SetLife))]

    def _scenes(self, scenes: Sequence[tuple[int, float]]) -> Iterator[TimedScene]:
        starts = (*(start for _, start in scenes), self.duration)
        for (number, _), (start, end) in zip(scenes, pairwise(starts), strict=True):
            scene = self.play.scenes[number]
            yield TimedScene(scene.name, scene.faces, start, end, scene.title)
