"""What is looked at once a whole script is read: definitions nobody calls, names nobody uses."""

from __future__ import annotations

import re
from contextlib import suppress
from functools import partial

from facescript.resolve.actions import Statements
from facescript.resolve.arguments import unbound
from facescript.resolve.arithmetic import bounds
from facescript.resolve.background import check_ground, is_ground
from facescript.resolve.labels import gather
from facescript.resolve.lives import preset
from facescript.resolve.mixes import check_expression, is_shown, mix
from facescript.resolve.names import Definition
from facescript.resolve.place import Place
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader
from facescript.resolve.scope import GLOBAL, Scope, expand
from facescript.resolve.sums import left_over, ranged
from facescript.syntax import tree

PLAIN = (tree.Colour, tree.String)


def check_definitions(project: Project, statements: Statements, cast: tuple[str, ...]) -> None:
    """Reads every definition of the author's that nothing has read, so that its faults are told too."""
    for definition in list(project.names.written.values()):
        used = definition.name in project.names.used
        work = partial(_check, project, definition, statements, cast, used)
        project.memo.part(project, "check", definition.node, (cast, used), work)
        if not used:
            project.names.used.discard(definition.name)


def _check(project: Project, definition: Definition, statements: Statements, cast: tuple[str, ...], used: bool) -> None:
    with suppress(Refused):
        _read(project, definition, statements, cast, used)


def _read(project: Project, definition: Definition, statements: Statements, cast: tuple[str, ...], used: bool) -> None:
    node = definition.node
    if isinstance(node, tree.LetDefinition):
        with project.entering(definition, definition.span):
            _value(project, node.value)
    elif isinstance(node, tree.ExpressionDefinition):
        for parameter in node.parameters:
            if parameter.default is not None:
                _value(project, parameter.default)
        check_expression(project, definition, unbound(node.parameters))
    elif isinstance(node, tree.ActionDefinition) and not used:
        _action(project, definition, node, statements, cast)
    elif isinstance(node, tree.Declaration) and node.kind == "life":
        preset(project, definition.name, definition.span)


def _action(
    project: Project,
    definition: Definition,
    node: tree.ActionDefinition,
    statements: Statements,
    cast: tuple[str, ...],
) -> None:
    """Reads an action's block as if the first face did it, with nothing known of arguments that have no default."""
    scope = unbound(node.parameters)
    inner = Scope(scope.bindings, gather(project, node.body, f"{definition.name}."))
    with project.entering(definition, definition.span):
        statements(project, node.body, Place(inner, cast[0] if cast else None, cast))


def _value(project: Project, phrase: tree.Phrase) -> None:
    """A `let`'s value or a default: a quantity, a sum, colours, a text, or a name of something looked at."""
    words = phrase.words
    if len(words) == 1 and isinstance(words[0], PLAIN):
        return
    if is_ground(project, words, GLOBAL):
        check_ground(project, words, GLOBAL, phrase.span)
    elif _is_mix(project, words):
        mix(project, words, GLOBAL, phrase.span)
    elif not _is_named(project, words):
        reader = Reader(words, GLOBAL, phrase.span)
        value = ranged(project, reader)
        left_over(project, reader)
        bounds(value.amount)


def _is_mix(project: Project, words: tuple[tree.Word, ...]) -> bool:
    """Whether words begin as a sum of expressions does."""
    word = words[0] if words else None
    if isinstance(word, tree.Bracket):
        return _is_mix(project, word.inner.words)
    if isinstance(word, tree.Call):
        return True
    if not isinstance(word, tree.Name | tree.Dotted):
        return False
    expansion = expand(project, word, GLOBAL)
    if expansion is not None and expansion.definition is not None:
        definition = expansion.definition
        if definition in project.open:
            return False
        project.open.append(definition)
        try:
            with project.deeper(word.span):
                return _is_mix(project, expansion.words)
        finally:
            project.open.pop()
    return is_shown(project, word)


def _is_named(project: Project, words: tuple[tree.Word, ...]) -> bool:
    """Whether a value is one name of something that is looked at or taken as it is."""
    if len(words) != 1 or not isinstance(words[0], tree.Name | tree.Dotted):
        return False
    first = words[0].text if isinstance(words[0], tree.Name) else str(words[0].parts[0])
    if first in ("camera", "people", "neutral"):
        return True
    definition = project.names.find(first)
    return definition is not None and definition.kind in ("face", "target", "life")


def check_unused(project: Project, script: tree.Script) -> None:
    """Tells of the script's own names that nothing uses. After an error only of those that stand nowhere else in its
    text, for the line that failed may have used them; of none where a line could not be read at all."""
    if project.spoilt_lines:
        return
    failed = project.diagnostics.failed
    for definition in project.names.written.values():
        if not definition.own or definition.name in project.names.used or definition.name in project.spoilt:
            continue
        if definition.kind == "face" and len(project.faces) == 1:
            continue
        if failed and len(re.findall(rf"(?<![\w-]){re.escape(definition.name)}(?![\w-])", script.source.text)) > 1:
            continue
        project.report("FS211", definition.span, kind=definition.kind, name=definition.name)
