"""Calls of actions: unfolded where they stand, arguments bound, labels of their own."""

from __future__ import annotations

from collections.abc import Callable

from facescript.ir.acts import Node, Sequence
from facescript.resolve.arguments import Given, bind
from facescript.resolve.labels import gather
from facescript.resolve.lines import Line, Words
from facescript.resolve.names import Definition
from facescript.resolve.place import Place
from facescript.resolve.project import Project
from facescript.resolve.reader import over
from facescript.resolve.scope import Scope
from facescript.resolve.words import MODIFIERS, VALUE, Modifier
from facescript.syntax import tree
from facescript.text import Span

Statements = Callable[[Project, tuple[tree.Statement, ...], Place], tuple[Node, ...]]


def call(
    project: Project,
    definition: Definition,
    phrases: tuple[tree.Phrase, ...],
    span: Span,
    place: Place,
    statements: Statements,
) -> Node:
    """The block that a call of an action is. Raises `Refused`; an action that reaches itself is refused."""
    node = definition.node
    assert isinstance(node, tree.ActionDefinition)
    line = Line(project, definition.name, phrases, rows_of(node), place.scope)
    given = _given(node, line)
    bound = bind(project, node.parameters, given, place.scope, span, definition.name)
    label = line.name("as")
    full = place.scope.label(label.text) if label is not None else None
    outer = place.scope.labels
    prefix = f"{outer.prefix}{definition.name}.{outer.numbered(definition.name)}." if outer is not None else ""
    with project.entering(definition, span):
        scope = Scope(bound.bindings, gather(project, node.body, prefix))
        inner = Place(scope, place.face, place.cast, place.site or span)
        items = statements(project, node.body, inner)
    if full is not None:
        project.lines[full] = None
    return Sequence(items, span, clock=True, label=full)


def rows_of(node: tree.ActionDefinition) -> dict[str, Modifier]:
    """What may stand behind a call: a label, and every parameter by its name."""
    rows = {
        parameter.name.text: Modifier(parameter.name.text, (parameter.name.text, VALUE), "value", "")
        for parameter in node.parameters
    }
    return {**rows, "as": MODIFIERS["as"]}


def _given(node: tree.ActionDefinition, line: Line) -> list[Given]:
    """The first argument behind the action's name, the others by their names."""
    given: list[Given] = []
    if len(line.head) > 1:
        words: Words = line.head[1:]
        given.append((None, words, over(words)))
    for parameter in node.parameters:
        name = parameter.name.text
        if name in line.parts:
            given.append((tree.Name(name, line.spans[name]), line.parts[name], line.spans[name]))
    return given
