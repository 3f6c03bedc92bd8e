"""What was solved of the play before, for as long as it is what solving the play of now would come to.

A scene and a statement are known by their objects: one that is the same object says the same (`recompile.py`). Objects
are held as long as they are known; spans are never read here: they move with the text.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field, replace

from facescript.ir.acts import Sequence
from facescript.ir.play import Play, Scene
from facescript.schedule.labels import nodes
from facescript.schedule.part import Part
from facescript.schedule.stretches import LONG, Trait, moving, trait
from facescript.schedule.voices import spoken_by
from facescript.space.room import Room
from facescript.speech.model import VoiceBox
from facescript.text import Source, Span

NOWHERE = Span(Source("", ""), 0, 0)
"""Stands for the place of a face: that of one that nobody has written is the whole script."""

Key = Hashable
"""What a part is known by: the objects that it was solved of, by their `id`, and all else that it depends on."""


@dataclass(slots=True)
class Kept:
    """The parts of the play before, and of the play of now as far as it has come, each with the objects it is of."""

    movers: frozenset[str] = frozenset()
    _stage: tuple[object, ...] = ()
    _voice: VoiceBox | None = None
    _room: Room | None = None
    _before: dict[Key, tuple[object, Part]] = field(default_factory=dict)
    _now: dict[Key, tuple[object, Part]] = field(default_factory=dict)
    _sizes: dict[int, tuple[Sequence, int]] = field(default_factory=dict)
    _traits: dict[int, Trait] = field(default_factory=dict)

    def turn_to(self, play: Play, voice: VoiceBox) -> Room:
        """Begin with a play, and give its room. What was solved is forgotten if all scenes play on another stage."""
        faces = tuple(replace(face, span=NOWHERE) for face in play.faces)
        stage = (play.film, faces, play.targets, play.visemes)
        if self._room is None or voice is not self._voice or stage != self._stage:
            self._room, self._now = Room(play.film, play.faces, play.targets), {}
            self.movers, self._traits = moving(play.targets), {}
        self._stage, self._voice = stage, voice
        self._before, self._now = self._now, {}
        known = self._traits
        long = (scene.body.items for scene in play.scenes if len(scene.body.items) >= LONG)
        self._traits = {id(item): known.get(id(item)) or trait(item, self.movers) for items in long for item in items}
        return self._room

    def traits(self, scene: Scene) -> list[Trait]:
        """The traits of the statements of a scene; of none where it is short."""
        return [self._traits[id(item)] for item in scene.body.items] if len(scene.body.items) >= LONG else []

    def statements(self, play: Play) -> int:
        """How many statements a play has as it is written."""
        short = [scene.body for scene in play.scenes if len(scene.body.items) < LONG]
        blocks = (*short, *(reaction.body for reaction in play.reactions))
        found = (self._sizes.get(id(block)) or (block, sum(1 for _ in nodes(block))) for block in blocks)
        self._sizes = {id(block): (block, size) for block, size in found}
        long = sum(one.size for one in self._traits.values()) + len(play.scenes) - len(short)
        return sum(size for _, size in self._sizes.values()) + long

    def part(self, key: Key, long: float, rough: bool) -> Part | None:
        """What was solved of the same, if it would be solved so again: in `long` seconds at most, and from a start that
        is `rough` or not."""
        found = self._before.get(key) or self._now.get(key)
        part = found[1] if found else None
        if part is None or part.begun[1] != rough or not _as_long(part, long) or not self._still_so(part):
            return None
        return part

    def keep(self, key: Key, of: object, part: Part) -> None:
        """Keep a part for the next play; `of` are the objects that the key names."""
        if not part.passing:
            self._now[key] = of, part

    def _still_so(self, part: Part) -> bool:
        """Whether the lines that hang on files are as they were."""
        voice = self._voice
        return voice is not None and all(spoken_by(voice, line) == spoken for line, spoken in part.outside)


def _as_long(part: Part, long: float) -> bool:
    """Whether nothing in a part comes to where it would be cut, now or then."""
    return part.begun[0] == long or (not part.failed and part.reach < min(part.begun[0], long))
