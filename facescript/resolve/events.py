"""`when` to reactions, `event` to scripted events."""

from __future__ import annotations

from typing import Literal

from facescript.ir.acts import Sequence
from facescript.ir.play import Event, EventPattern, Reaction
from facescript.resolve.blocks import statements
from facescript.resolve.labels import check_free, gather
from facescript.resolve.place import Place
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader, over
from facescript.resolve.scope import GLOBAL, Person, Scope
from facescript.resolve.sums import quantity
from facescript.resolve.units import TIME, article
from facescript.resolve.words import ENDINGS
from facescript.syntax import tree
from facescript.text import Span

TEXTUAL = ("heard", "touched", "key", "signal")
PERSONAL = ("arrives", "leaves", "nearest")
WHEN = (
    '`when heard "no":`, `touched "..."`, `key "..."`, `signal "..."`, `person arrives`, `leaves` or `nearest as NAME`'
)
EVENT = '`event heard "no" at 3s` or `event TARGET arrives at 2s`'


def reaction(project: Project, node: tree.When, cast: tuple[str, ...], number: int) -> Reaction:
    """A reaction; its labels are `when.NUMBER.name`. Raises `Refused`."""
    return reacting(project, _pattern(project, node), node.body, node.span, cast, f"when.{number}.")


def reacting(
    project: Project,
    event: EventPattern,
    block: tuple[tree.Statement, ...],
    span: Span,
    cast: tuple[str, ...],
    prefix: str,
) -> Reaction:
    """What an event starts: a block and the word it may end in; its labels begin with `prefix`. Raises `Refused`."""
    bindings = {event.binds: Person(event.binds)} if event.binds else {}
    body, ending = _ending(block)
    scope = Scope(dict(bindings), gather(project, body, prefix))
    place = Place(scope, cast[0] if len(cast) == 1 else None, cast)
    items = statements(project, body, place)
    return Reaction(event, Sequence(items, span, clock=True), ending, span)


def _ending(
    body: tuple[tree.Statement, ...],
) -> tuple[tuple[tree.Statement, ...], Literal["resume", "restart", "stop"]]:
    """The block without the word it ends in, and that word."""
    last = body[-1] if body else None
    if isinstance(last, tree.Act) and len(last.phrases) == 1 and len(last.phrases[0].words) == 1:
        word = last.phrases[0].words[0]
        if isinstance(word, tree.Name) and word.text in ENDINGS:
            return body[:-1], {"resume": "resume", "restart": "restart", "stop": "stop"}[word.text]  # type: ignore[return-value]
    return body, "resume"


def _pattern(project: Project, node: tree.When) -> EventPattern:
    reader = Reader(node.event.words, GLOBAL, node.event.span)
    for kind in TEXTUAL:
        if reader.word(kind):
            word = reader.next()
            if not isinstance(word, tree.String) or reader.peek() is not None:
                raise _miswritten(project, reader, WHEN)
            return EventPattern(kind, word.value)
    if reader.word("person"):
        for kind in PERSONAL:
            if reader.word(kind):
                return EventPattern(kind, binds=_bound(project, reader))
    raise _miswritten(project, reader, WHEN)


def _bound(project: Project, reader: Reader) -> str | None:
    if reader.peek() is None:
        return None
    if not reader.word("as"):
        raise _miswritten(project, reader, WHEN)
    word = reader.next()
    if not isinstance(word, tree.Name) or reader.peek() is not None:
        raise _miswritten(project, reader, WHEN)
    check_free(project, word)
    return word.text


def event(project: Project, node: tree.Setting) -> Event:
    """A scripted event. Raises `Refused`."""
    words = tuple(word for phrase in node.phrases for word in phrase.words)
    cut = next((index for index, word in enumerate(words) if isinstance(word, tree.Name) and word.text == "at"), -1)
    if cut < 0 or cut + 1 == len(words):
        raise project.refuse("FS312", node.span, text=node.span.text, advice=f"it is written {EVENT}")
    reader = Reader(words[:cut], GLOBAL, node.span)
    kind, text, person = _happening(project, reader)
    rest = words[cut + 1 :]
    return Event(kind, quantity(project, rest, GLOBAL, TIME, over(rest)), node.span, text, person)


def _happening(project: Project, reader: Reader) -> tuple[str, str, str | None]:
    for kind in TEXTUAL:
        if reader.word(kind):
            word = reader.next()
            if not isinstance(word, tree.String) or reader.peek() is not None:
                raise _miswritten(project, reader, EVENT)
            return kind, word.value, None
    word = reader.next()
    if not isinstance(word, tree.Name):
        raise _miswritten(project, reader, EVENT)
    for kind in ("arrives", "leaves"):
        if reader.word(kind) and reader.peek() is None:
            return kind, "", _visitor(project, word)
    raise _miswritten(project, reader, EVENT)


def _visitor(project: Project, word: tree.Name) -> str:
    definition = project.names.find(word.text)
    if definition is None:
        raise project.unknown("FS202", word.text, project.names.known("target"), word.span)
    if definition.kind != "target":
        kind = article(definition.kind)
        raise project.refuse("FS214", word.span, name=word.text, kind=kind, wanted="a target")
    return word.text


def _miswritten(project: Project, reader: Reader, form: str) -> Refused:
    span = reader.span
    return project.refuse("FS312", span, text=span.text, advice=f"it is written {form}")


def check_reached(project: Project, reactions: list[tuple[tree.When, Reaction]], events: list[Event]) -> None:
    """Tells of reactions to what no scripted event is like: a build never plays them."""
    scripted = {event.kind for event in events}
    if scripted & {"arrives", "leaves"}:
        scripted.add("nearest")
    for node, found in reactions:
        if found.event.kind not in scripted:
            project.report("FS808", node.span.to(node.event.span))
