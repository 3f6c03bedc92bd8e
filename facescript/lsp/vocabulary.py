"""An analysis to the names that its document may use, and what is known of each: definitions and labels."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from itertools import pairwise

from facescript.diagnostics.model import Diagnostics
from facescript.ir.values import Driver
from facescript.ir.wording import words
from facescript.lsp.desk import Analysis
from facescript.performance.channels import SIDES
from facescript.resolve.definitions import library_names
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.mixes import expression_drivers
from facescript.resolve.names import Definition
from facescript.resolve.project import Project, Refused, TooMuch
from facescript.resolve.resolver import define
from facescript.resolve.scope import GLOBAL
from facescript.resolve.texts import pieces_of, read_text
from facescript.resolve.units import UNITS, written
from facescript.resolve.uses import library
from facescript.syntax import tree

KEPT = 8
_MADE: list[tuple[Analysis, Project]] = []
"""Projects of the last analyses: an editor asks of one again and again."""


def project_of(analysis: Analysis) -> Project:
    """The names that a document defines, uses and finds in the library; what is wrong with them is told elsewhere."""
    for kept, project in _MADE:
        if kept is analysis:
            return project
    project = Project(analysis.world, Diagnostics(), library_names(library(analysis.world)))
    define(project, analysis.compiled.script)
    _MADE.insert(0, (analysis, project))
    del _MADE[KEPT:]
    return project


# ------------------------------------------------------------------------------------------------ definitions


def kind_of_face(definition: Definition) -> str:
    """`woman` of `face ada = woman`; "" where it is not written."""
    node = definition.node
    first = node.phrases[0].words if isinstance(node, tree.Declaration) and node.phrases else ()
    return first[0].text if first and isinstance(first[0], tree.Name) else ""


def crowd_size(definition: Definition) -> int:
    """How many places a target has: 0 where it is no crowd."""
    node = definition.node
    first = node.phrases[0].words if isinstance(node, tree.Declaration) and node.phrases else ()
    return len(first) - 1 if first and isinstance(first[0], tree.Name) and first[0].text == "of" else 0


def parameters_of(definition: Definition) -> tuple[tree.Parameter, ...]:
    node = definition.node
    return node.parameters if isinstance(node, tree.ActionDefinition | tree.ExpressionDefinition) else ()


def recipe(project: Project, definition: Definition, side: str = "") -> str | None:
    """What an expression drives in the end, as an author would write it; None where it cannot be worked out."""
    project.stood_for = 0
    with suppress(Refused, TooMuch):
        return " + ".join(_driven(expression_drivers(project, definition, side, definition.span)))
    return None


def _driven(drivers: Iterable[Driver]) -> Iterator[str]:
    """Drivers with their amounts; two sides that are driven alike are one."""
    amounts: dict[str, float] = {}
    for driver in drivers:
        value = driver.value if isinstance(driver.value, float | int) else 0.0
        amounts[driver.name] = amounts.get(driver.name, 0.0) + value
    for name, amount in amounts.items():
        base = next((name.replace(f".{side}", "", 1) for side in SIDES if f".{side}" in name), name)
        both = PRIMITIVES[base].names if base in PRIMITIVES else (name,)
        alike = len(both) == 2 and all(amounts.get(each) == amount for each in both)
        if not alike or name == both[0]:
            yield f"{base if alike else name} {written(PRIMITIVES[name].kind, amount)}"


def is_quantity(definition: Definition, kind: str) -> bool:
    """Whether a `let` stands for a quantity of a kind, as far as its first word says."""
    node = definition.node
    word = node.value.words[0] if isinstance(node, tree.LetDefinition) and node.value.words else None
    return isinstance(word, tree.Quantity) and word.unit in UNITS and UNITS[word.unit].kind == kind


# ------------------------------------------------------------------------------------------------ labels


def around(analysis: Analysis, place: int) -> tuple[tree.Statement, ...]:
    """The statements whose labels can be seen from a place: of the scene, the action or the reaction around it."""
    items = analysis.compiled.script.items
    inside = [item for item in items if item.span.start <= place]
    if inside and isinstance(inside[-1], tree.Scene | tree.ActionDefinition | tree.When):
        return inside[-1].body
    return tuple(item for item in items if isinstance(item, tree.Statement))


def labels(body: Iterable[tree.Statement], place: int) -> Iterator[tuple[str, tree.Act]]:
    """The names given with `as` and their statements; those of a repeat are seen inside it only."""
    for statement in body:
        if isinstance(statement, tree.Act):
            if name := label_of(statement):
                yield name.text, statement
            for on in statement.ons:
                yield from labels(on.body, place)
        elif not isinstance(statement, tree.Repeat) or statement.span.start <= place <= statement.span.end:
            yield from labels(statement.body, place)


def label_of(act: tree.Act) -> tree.Name | None:
    """The name that `as` gives a statement."""
    words = [word for phrase in act.phrases for word in phrase.words][1:]
    for word, name in pairwise(words):
        if isinstance(word, tree.Name) and word.text == "as" and isinstance(name, tree.Name):
            return name
    return None


def spoken_words(project: Project, act: tree.Act) -> list[str]:
    """The words of a line as they stand in it, each once; none where its text is elsewhere or cannot be read."""
    first = act.phrases[0].words
    strings = [word for word in first[1:] if isinstance(word, tree.String)]
    if not is_say(act) or not strings:
        return []
    with suppress(Refused):
        text = read_text(project, pieces_of((*strings, *act.more)), GLOBAL, act.span).plain
        return list(dict.fromkeys(text[start:end] for _, start, end in words(text) if '"' not in text[start:end]))
    return []


def is_say(act: tree.Act) -> bool:
    first = act.phrases[0].words[0]
    return isinstance(first, tree.Name) and first.text == "say"
