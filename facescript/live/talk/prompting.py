"""What was told to a run, as its log has it, to the reactions that it starts."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property

from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Do, Node, Say, Sequence
from facescript.ir.play import EventPattern, Reaction
from facescript.live.model import Happening
from facescript.resolve.told import HUSHED, TOLD, Prompter
from facescript.schedule.labels import nodes
from facescript.text import Source, Span

AT_ONCE = 1000
"""Of so many statements that do not speak none is like another; later ones take the place of what is long over."""

NOWHERE = Span(Source("told", ""), 0, 0)


class Prompting:
    """Tells a run what it was told. All that a face is told to say is as one reaction, which the next starts afresh: a
    line that sounds breaks off at the end of its word and is not said again. What does not speak stands alone."""

    def __init__(self, prompter: Callable[[], Prompter], faces: tuple[str, ...]) -> None:
        self._made = prompter
        self._numbers = {face: -1 - index for index, face in enumerate(faces)}
        self._count = 0

    @cached_property
    def prompter(self) -> Prompter:
        """Who knows the script's names; made when something is told first."""
        return self._made()

    def __call__(self, event: Happening) -> Iterator[tuple[int, Reaction]]:
        """The reactions that an event starts, with the numbers of what they take the place of."""
        if event.kind == HUSHED and event.text in self._numbers:
            yield self._numbers[event.text], _nothing(event.text)
        elif event.kind == TOLD:
            reaction = self.prompter.reaction(event.text, Diagnostics())
            if reaction is not None:
                yield from self._told(reaction)

    def _told(self, reaction: Reaction) -> Iterator[tuple[int, Reaction]]:
        faces = list(dict.fromkeys(face for face, _ in says(reaction.body)))
        for face in faces[1:]:
            yield self._numbers[face], _nothing(face)
        if not faces:
            self._count = (self._count + 1) % AT_ONCE
        yield self._numbers[faces[0]] if faces else -1 - len(self._numbers) - self._count, reaction


def says(body: Node) -> list[tuple[str, Say]]:
    """The lines in a block, in the order written, each with its face."""
    found = [node for node, _ in nodes(body) if isinstance(node, Do)]
    return [(node.face, node.verb) for node in found if isinstance(node.verb, Say) and node.face is not None]


def _nothing(face: str) -> Reaction:
    return Reaction(EventPattern(HUSHED, face), Sequence((), NOWHERE, clock=True), "resume", NOWHERE)
