"""What was told to a run, as its log has it, to the reactions that it starts."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Do, Node, Say, Sequence
from facescript.ir.play import EventPattern, Reaction
from facescript.live.model import Happening
from facescript.resolve.told import KIND, Prompter
from facescript.schedule.labels import nodes
from facescript.text import Source, Span

HUSHED = "hushed"
"""The kind of event that ends what was told a face to say; its text is the face's name."""

AT_ONCE = 1000
"""Of so many statements that do not speak none is like another; later ones take the place of what is long over."""

NOWHERE = Span(Source("told", ""), 0, 0)


class Prompting:
    """Tells a run what it was told. All that a face says so is as one reaction, which a next one starts afresh: the line
    that sounds breaks off at the end of its word and is not said again. What does not speak stands for itself."""

    def __init__(self, prompter: Prompter, faces: tuple[str, ...]) -> None:
        self._prompter = prompter
        self._numbers = {face: -1 - index for index, face in enumerate(faces)}
        self._count = 0

    def __call__(self, event: Happening) -> Iterator[tuple[int, Reaction]]:
        """The reactions that an event starts, with the numbers of what they take the place of."""
        if event.kind == HUSHED and event.text in self._numbers:
            yield self._numbers[event.text], _nothing(event.text)
        elif event.kind == KIND:
            reaction = self._prompter.reaction(event.text, Diagnostics())
            if reaction is not None:
                yield from self._told(reaction)

    def _told(self, reaction: Reaction) -> Iterator[tuple[int, Reaction]]:
        first, *others = [face for face, _ in says(reaction.body)] or [None]
        for face in dict.fromkeys(others):
            if face is not None and face != first:
                yield self._numbers[face], _nothing(face)
        if first is not None:
            yield self._numbers[first], reaction
        else:
            self._count = (self._count + 1) % AT_ONCE
            yield -1 - len(self._numbers) - self._count, reaction


def says(body: Node) -> list[tuple[str, Say]]:
    """The lines in a block, in the order written, each with its face."""
    found = [node for node, _ in nodes(body) if isinstance(node, Do)]
    return [(node.face, node.verb) for node in found if isinstance(node.verb, Say) and node.face is not None]


def _nothing(face: str) -> Reaction:
    return Reaction(EventPattern(HUSHED, face), Sequence((), NOWHERE, clock=True), "resume", NOWHERE)
