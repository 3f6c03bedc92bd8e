"""`repeat`: passes that are counted stay one node; passes over a crowd or a table are unfolded."""

from __future__ import annotations

from facescript.ir.acts import Node, Repeat, Sequence
from facescript.ir.play import Crowd
from facescript.resolve.actions import Statements
from facescript.resolve.aims import read_crowd
from facescript.resolve.labels import check_free, gather
from facescript.resolve.place import Place
from facescript.resolve.project import Project
from facescript.resolve.reader import Reader
from facescript.resolve.scope import GLOBAL, Binding, Closure, Labels, Scope
from facescript.resolve.sums import number, read_quantity
from facescript.resolve.tables import rows
from facescript.resolve.units import COUNT, TIME
from facescript.syntax import tree
from facescript.text import Span

MOST_PASSES = 100_000

HOW = '`repeat 3 times`, `repeat for 20s`, `repeat forever`, `repeat NAME in CROWD` or `repeat NAME in "trials.csv"`'


def repeat(project: Project, statement: tree.Repeat, place: Place, statements: Statements) -> Node:
    """The node of a repeat: `Repeat` for counted, timed and endless ones, a sequence of passes for the others."""
    words = statement.how.words
    if len(words) >= 3 and isinstance(words[1], tree.Name) and words[1].text == "in":
        return _over(project, statement, place, statements)
    times, lasting = _length(project, statement, place)
    labels = _labels(project, statement, place)
    items = statements(project, statement.body, place.within(Scope(place.scope.bindings, labels)))
    body = Sequence(items, statement.span, clock=True)
    return Repeat(body, times, lasting, statement.span)


def _length(project: Project, statement: tree.Repeat, place: Place) -> tuple[int | None, float | None]:
    """How many passes, or how many seconds; neither for `forever`. Raises `Refused`."""
    how = statement.how
    reader = Reader(how.words, place.scope, how.span)
    if reader.word("forever"):
        return _only(project, reader, (None, None))
    if reader.word("for"):
        return None, number(project, reader.rest(), place.scope, TIME, how.span, least=0.001)
    amount = read_quantity(project, reader, COUNT, draws=False)
    if not reader.word("times"):
        raise project.refuse("FS312", reader.here(), text=reader.here().text, advice=f"it is written {HOW}")
    if not isinstance(amount, float) or amount != int(amount) or amount > MOST_PASSES:
        raise project.refuse("FS331", how.span, most=MOST_PASSES)
    return _only(project, reader, (int(amount), None))


def _only(project: Project, reader: Reader, length: tuple[int | None, float | None]) -> tuple[int | None, float | None]:
    if reader.peek() is not None:
        raise project.refuse("FS312", reader.here(), text=reader.here().text, advice=f"it is written {HOW}")
    return length


def _labels(project: Project, statement: tree.Repeat, place: Place) -> Labels:
    outer = place.scope.labels
    prefix = f"{_prefix(outer)}*." if outer is not None else "*."
    return gather(project, statement.body, prefix, outer)


def _prefix(outer: Labels) -> str:
    """What stands before a pass's number: `repeat2.` for the second repeat of one scope, nothing for the first."""
    number = outer.numbered("repeat")
    return outer.prefix if number == 1 else f"{outer.prefix}repeat{number}."


# ------------------------------------------------------------------------------------------------ unfolded passes


def _over(project: Project, statement: tree.Repeat, place: Place, statements: Statements) -> Node:
    name = statement.how.words[0]
    if not isinstance(name, tree.Name):
        raise project.refuse("FS312", name.span, text=name.span.text, advice=f"it is written {HOW}")
    check_free(project, name)
    bindings = _bindings(project, statement, place)
    outer = place.scope.labels
    prefix = _prefix(outer) if outer is not None else ""
    passes = []
    for turn, binding in enumerate(bindings, 1):
        labels = gather(project, statement.body, f"{prefix}{turn}.", outer)
        scope = Scope({**place.scope.bindings, name.text: binding}, labels)
        items = statements(project, statement.body, place.within(scope))
        passes.append(Sequence(items, statement.span, clock=True))
    return Sequence(tuple(passes), statement.span)


def _bindings(project: Project, statement: tree.Repeat, place: Place) -> list[Binding]:
    words = statement.how.words[2:]
    if isinstance(words[0], tree.String) and len(words) == 1:
        return list(rows(project, words[0]))
    reader = Reader(words, place.scope, statement.how.span)
    crowd = read_crowd(project, reader)
    if reader.peek() is not None:
        raise project.refuse("FS312", reader.here(), text=reader.here().text, advice=f"it is written {HOW}")
    target = project.targets.get(crowd)
    if not isinstance(target, Crowd):
        raise project.refuse("FS807", words[0].span)
    return [_member(crowd, number, words[0].span) for number in range(1, len(target.members) + 1)]


def _member(crowd: str, number: int, span: Span) -> Closure:
    word = tree.Dotted((crowd, number), (False, False), span)
    return Closure((word,), GLOBAL)
