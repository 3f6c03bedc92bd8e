"""What a name means inside an action, an expression or a pass of a repeat: parameters, table cells, persons, labels."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from facescript.resolve.cells import cell_words
from facescript.resolve.names import Definition
from facescript.resolve.project import Cell, Project, Refused
from facescript.syntax.tree import Dotted, LetDefinition, Name, Word
from facescript.text import Span


@dataclass(frozen=True, slots=True)
class Closure:
    """Words and the scope they were written in: an argument, read as what its place asks for."""

    words: tuple[Word, ...]
    scope: Scope


@dataclass(frozen=True, slots=True)
class Row:
    """A row of a table, bound to a repeat's name: its number from 1, and the cells by column."""

    file: str
    number: int
    cells: dict[str, str]


@dataclass(frozen=True, slots=True)
class Person:
    """Whom an event brings."""

    name: str


@dataclass(frozen=True, slots=True)
class Unknown:
    """A parameter without an argument, while a definition that nobody calls is checked; or one that is refused."""


Binding = Closure | Row | Person | Unknown


@dataclass(slots=True)
class Labels:
    """The labels of one scope: `prefix` stands in front of their full names, `names` says where each is written."""

    prefix: str
    names: dict[str, Span] = field(default_factory=dict)
    parent: Labels | None = None
    counts: dict[str, int] = field(default_factory=dict)

    def find(self, name: str) -> str | None:
        """The full name of a label that can be seen from here."""
        if name in self.names:
            return self.prefix + name
        return self.parent.find(name) if self.parent else None

    def seen(self) -> list[str]:
        return [*self.names, *(self.parent.seen() if self.parent else [])]

    def numbered(self, name: str) -> int:
        """1 for the first call with this name, 2 for the second, and so on."""
        self.counts[name] = self.counts.get(name, 0) + 1
        return self.counts[name]


@dataclass(slots=True)
class Scope:
    bindings: dict[str, Binding] = field(default_factory=dict)
    labels: Labels | None = None

    def label(self, name: str) -> str | None:
        return self.labels.find(name) if self.labels else None


@dataclass(frozen=True, slots=True)
class Expansion:
    """What a name stands for: words in their own scope, by way of a `let` or of a table's cell where there is one."""

    words: tuple[Word, ...]
    scope: Scope
    definition: Definition | None = None
    cell: Cell | None = None


GLOBAL = Scope()


def expand(project: Project, word: Name | Dotted, scope: Scope) -> Expansion | None:
    """What a parameter, a cell or a `let` stands for; None for any other name.

    Raises `Refused` for a parameter that is not known, and for a column that the table has not.
    """
    first = word.text if isinstance(word, Name) else str(word.parts[0])
    binding = scope.bindings.get(first)
    if binding is None:
        return _let(project, word, first, scope)
    if isinstance(binding, Unknown):
        raise Refused
    if isinstance(binding, Row):
        return _cell(project, word, binding)
    if isinstance(binding, Closure):
        return _dotted(word, binding.words, binding.scope, None)
    return None


def _let(project: Project, word: Name | Dotted, first: str, scope: Scope) -> Expansion | None:
    if scope.label(first) is not None:
        return None
    definition = project.names.written.get(first)
    if definition is None or not isinstance(definition.node, LetDefinition):
        return None
    project.names.used.add(first)
    return _dotted(word, definition.node.value.words, GLOBAL, definition)


def _dotted(
    word: Name | Dotted, words: tuple[Word, ...], scope: Scope, definition: Definition | None
) -> Expansion | None:
    """`who.mouth` where `who` is one name: that name's mouth."""
    if isinstance(word, Name):
        return Expansion(words, scope, definition)
    if len(words) != 1 or not isinstance(words[0], Name | Dotted):
        return None
    base = words[0]
    parts = (base.text,) if isinstance(base, Name) else base.parts
    quoted = (False,) if isinstance(base, Name) else base.quoted
    joined = Dotted((*parts, *word.parts[1:]), (*quoted, *word.quoted[1:]), word.span)
    return Expansion((joined,), scope, definition)


def _cell(project: Project, word: Name | Dotted, row: Row) -> Expansion:
    column = str(word.parts[1]) if isinstance(word, Dotted) else ""
    if column not in row.cells or (isinstance(word, Dotted) and len(word.parts) > 2):
        known = ", ".join(f"`{name}`" for name in row.cells)
        name = word.text if isinstance(word, Name) else ".".join(str(part) for part in word.parts)
        raise project.refuse("FS704", word.span, name=name, file=row.file, known=known)
    text = row.cells[column]
    cell = Cell(row.file, row.number, column, text, word.span)
    return Expansion(cell_words(row.file, text), GLOBAL, None, cell)


@contextmanager
def inside(project: Project, expansion: Expansion, span: Span) -> Iterator[None]:
    """While what a name stands for is read: circles are found, and faults in a cell are told where it is used."""
    project.stand_for(len(expansion.words), span)
    if expansion.cell is not None:
        with project.blaming(expansion.cell):
            yield
    elif expansion.definition is not None:
        with project.entering(expansion.definition, span):
            yield
    else:
        with project.deeper(span):
            yield


def person(word: Word, scope: Scope) -> Person | None:
    """The person that a name of a reaction is."""
    binding = scope.bindings.get(word.text) if isinstance(word, Name) else None
    return binding if isinstance(binding, Person) else None
