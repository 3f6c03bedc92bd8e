"""A play to the rows of a script that compiles to it, and to that script's text."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from facescript.ir.acts import (
    Add,
    At,
    Choose,
    Do,
    Gesture,
    Node,
    Repeat,
    Say,
    Sequence,
    SetBackground,
    Show,
    Together,
    View,
)
from facescript.ir.play import MAIN, EventPattern, Play, Reaction, Scene
from facescript.text import Span
from facescript.world import World
from facescript.writing import people
from facescript.writing.context import NOWHERE, Context, Row
from facescript.writing.kinds import kind
from facescript.writing.labels import Labels
from facescript.writing.nodes import Nodes
from facescript.writing.quotes import quoted
from facescript.writing.sums import Sums

INDENT = "    "


@dataclass(frozen=True, slots=True)
class Written:
    """A script: its rows, a line each, an empty one between paragraphs; and the statements that bear another name in
    it than in the play, with their places: full name in the play to full name in the script."""

    rows: tuple[Row, ...]
    renamed: Mapping[str, tuple[str, Span]]

    @property
    def text(self) -> str:
        return "".join(f"{INDENT * row.depth}{row.text}\n" if row.text else "\n" for row in self.rows)


def write(play: Play, world: World, script: str) -> Written:
    """The script of a play; `script` is its path in the project of `world`, from which its files are named."""
    return _Writer(play, world, script).written()


class _Writer:
    def __init__(self, play: Play, world: World, script: str) -> None:
        self.play = play
        names = {face.name for face in play.faces} | {target.name for target in play.targets}
        taken = names | {name for name, _ in play.lives} | {face.kind for face in play.faces}
        self.context = Context(world, script, taken)
        self.sums = Sums(self.context)
        self.nodes = Nodes(self.context, play, self.sums)

    def written(self) -> Written:
        for body in (*(scene.body for scene in self.play.scenes), *(each.body for each in self.play.reactions)):
            for node in body.items:
                self._note(node)
        expressions = [Row(0, text, NOWHERE) for text in self.sums.define()]
        scenes = [rows for paragraph in self._scenes() for rows in (paragraph,)]
        reactions = [self._reaction(reaction, number) for number, reaction in enumerate(self.play.reactions, 1)]
        paragraphs = [
            self._film(),
            *(
                kind(each)
                for each in {face.kind: face.drawn for face in self.play.faces if face.drawn}.values()
                if each
            ),
            self._people(),
            expressions,
            *self.nodes.actions,
            *scenes,
            *reactions,
            [people.event(event) for event in self.play.events],
        ]
        rows: list[Row] = []
        for paragraph in filter(None, paragraphs):
            rows += [Row(0, "", NOWHERE)] * bool(rows) + paragraph
        return Written(tuple(rows), self.context.renamed)

    # -------------------------------------------------------------------------------------------- definitions

    def _film(self) -> list[Row]:
        text = people.film(self.play.film)
        return [Row(0, text, NOWHERE)] if text else []

    def _people(self) -> list[Row]:
        rows = []
        for name, life in self.play.lives:
            base, knobs = self.nodes.verbs.life(life)
            rows.append(Row(0, f"life {name} = {', '.join((base, *knobs))}", NOWHERE))
        for face in self.play.faces:
            rows += people.face(self.context, self.nodes.verbs, face)
        for target in self.play.targets:
            rows += people.target(target)
        rows += [Row(0, people.viseme(each), NOWHERE) for each in self.play.visemes]
        return rows

    def _note(self, node: Node) -> None:
        """Sees the expressions of a statement and of all that is in it."""
        if isinstance(node, Do):
            if isinstance(node.verb, Show | Add | Gesture):
                self.sums.note(node.verb.mix)
            inner = tuple(cue.body for cue in node.verb.cues) if isinstance(node.verb, Say) else ()
        else:
            inner = (node.body,) if isinstance(node, Repeat | At) else ()
        for block in (*inner, *((node,) if isinstance(node, Sequence | Together | Choose) else ())):
            for item in block.items:
                self._note(item)

    # -------------------------------------------------------------------------------------------- scenes

    def _scenes(self) -> Iterator[list[Row]]:
        play = self.play
        if len(play.scenes) == 1 and self._is_main(play.scenes[0]):
            yield self._body(play.scenes[0].body, "", play.scenes[0].faces, 0)
            return
        settings: tuple[SetBackground | View | None, ...] = (play.background, play.view)
        yield [
            Row(0, self.nodes.verbs.verb(setting, Labels(self.context, "")), NOWHERE)
            for setting in settings
            if setting is not None
        ]
        for scene in play.scenes:
            yield self._scene(scene)

    def _is_main(self, scene: Scene) -> bool:
        """Whether a scene is that of a script without scenes."""
        named = any(label.startswith(f"{MAIN}.") for label in _labels(scene.body))
        whole = scene.name == MAIN and scene.faces == tuple(face.name for face in self.play.faces)
        bare = scene.background is None and scene.view is None and not scene.title
        return whole and bare and not named and self.play.background is None and self.play.view is None

    def _scene(self, scene: Scene) -> list[Row]:
        title = f" {quoted(scene.title)}" if scene.title else ""
        every = scene.faces == tuple(face.name for face in self.play.faces)
        cast = "" if every else f" with {', '.join(scene.faces)}"
        body = self._body(scene.body, f"{scene.name}.", scene.faces, 1)
        return [Row(0, f"scene {scene.name}{title}{cast}:", scene.span), *body]

    def _body(
        self, body: Sequence, prefix: str, cast: tuple[str, ...], depth: int, binds: str | None = None
    ) -> list[Row]:
        self.nodes.several = len(cast) > 1
        labels = Labels(self.context, prefix, persons={binds} if binds else set()).gather(body)
        return self.nodes.body(body, labels, depth)

    def _reaction(self, reaction: Reaction, number: int) -> list[Row]:
        cast = tuple(face.name for face in self.play.faces)
        body = self._body(reaction.body, f"when.{number}.", cast, 1, reaction.event.binds)
        ending = [Row(1, reaction.ending, reaction.span)] if reaction.ending != "resume" or not body else []
        return [Row(0, f"when {_pattern(reaction.event)}:", reaction.span), *body, *ending]


def _pattern(event: EventPattern) -> str:
    if event.kind in people.TEXTUAL:
        return f'{event.kind} "{event.text}"'
    return f"person {event.kind}{f' as {event.binds}' if event.binds else ''}"


def _labels(node: Node) -> Iterator[str]:
    """The names of a statement and of all that is in it, but for what hangs on words."""
    if node.label:
        yield node.label
    if isinstance(node, Repeat | At):
        yield from _labels(node.body)
    elif isinstance(node, Sequence | Together | Choose):
        for item in node.items:
            yield from _labels(item)
