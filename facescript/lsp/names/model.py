"""What stands for a name: a mention in a text, and what it may mean that is seen in a part of a script alone."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from facescript.resolve.words import WORDS
from facescript.syntax.tree import Act, Name, String
from facescript.text import Span

Space = Literal["name", "kind", "scene", "sound", "argument", "column", "spoken", "word", "file", "text"]
"""Where a mention is looked up: the one space of definitions and labels, kinds of faces, scenes, sounds, the parameters
of `owner`, the columns of a table (of `spoken` ones the cells are texts), the words of a line, the project's files (of
which a `text` is spoken)."""

LocalKind = Literal["parameter", "row", "person", "label"]

Reach = frozenset[str]
"""The kinds of local names that can be meant at a place; `text` where a cell of a table may be a text."""

GLOBAL: Reach = frozenset()
VALUE: Reach = frozenset({"parameter", "row"})
AIM: Reach = VALUE | {"person"}
TIME: Reach = VALUE | {"label"}
SPOKEN: Reach = VALUE | {"text"}
EVERY: Reach = AIM | TIME | SPOKEN


@dataclass(slots=True, eq=False)
class Local:
    """A name that is seen in a part of one script. `owner` is the definition that a parameter belongs to, `act` the
    statement that a label names, `table` the file that a row is of."""

    kind: LocalKind
    name: str
    span: Span
    owner: str = ""
    act: Act | None = None
    table: String | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Mention:
    """A name in a text. `local` is what it means where that is local; `defines` is the kind of what it defines.

    Of a `word`, `act` is the line and `nth` which of several is meant.
    """

    name: str
    span: Span
    space: Space = "name"
    local: Local | None = None
    defines: str = ""
    owner: str = ""
    act: Act | None = None
    nth: int = 1


@dataclass(frozen=True, slots=True)
class Sight:
    """What can be seen from a place in a script; `found` gathers the mentions."""

    found: list[Mention]
    bindings: dict[str, Local] = field(default_factory=dict)
    labels: dict[str, Local] = field(default_factory=dict)

    def outside(self) -> Sight:
        """As seen from no block: definitions alone."""
        return Sight(self.found)

    def within(self, bindings: dict[str, Local], labels: dict[str, Local]) -> Sight:
        """As seen from a block in this one, with names of its own."""
        return Sight(self.found, {**self.bindings, **bindings}, {**self.labels, **labels})

    def local(self, name: str, reach: Reach, *, label_first: bool = False) -> Local | None:
        """The local name that is meant, by the order in which `resolve` looks."""
        tables = (self.labels, self.bindings) if label_first else (self.bindings, self.labels)
        for table in tables:
            found = table.get(name)
            if found is not None and found.kind in reach:
                return found
        return None

    def mention(self, name: str, span: Span, reach: Reach, *, label_first: bool = False) -> Local | None:
        """Notes a name; words of the language are none, but for those that a sum may mean. The local that it means."""
        local = self.local(name, reach, label_first=label_first)
        if local is not None or name not in WORDS or reach is VALUE:
            self.found.append(Mention(name, span, local=local))
        return local

    def define(self, name: Name, kind: str, space: Space = "name") -> None:
        """Notes a definition of the project's."""
        self.found.append(Mention(name.text, name.span, space, defines=kind))

    def bind(self, local: Local) -> None:
        """Notes the definition of a local name."""
        self.found.append(Mention(local.name, local.span, local=local, defines=local.kind, owner=local.owner))


def first_part(span: Span) -> Span:
    """The span of what stands before the first point of a dotted name."""
    point = span.text.find(".")
    return span if point < 0 else Span(span.source, span.start, span.start + point)
