"""The names of a script: what defines each, which are the library's, which were used."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from facescript.syntax import tree
from facescript.text import Span

Node = tree.ExpressionDefinition | tree.ActionDefinition | tree.LetDefinition | tree.Declaration


@dataclass(slots=True, eq=False)
class Definition:
    """A name of the one shared space. `kind` is face, target, expression, action, life or let; `own` is whether it
    stands in the script itself, not in a file it uses or in the library."""

    kind: str
    name: str
    node: Node
    span: Span
    library: bool = False
    own: bool = True


@dataclass(slots=True)
class Names:
    """Definitions by name, the library's stand behind the author's; and the names that something uses."""

    written: dict[str, Definition] = field(default_factory=dict)
    library: dict[str, Definition] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)

    def find(self, name: str) -> Definition | None:
        """The definition of a name, noted as used."""
        found = self.written.get(name) or self.library.get(name)
        if found is not None:
            self.used.add(name)
        return found

    def all(self, *kinds: str) -> Iterator[Definition]:
        """Definitions of these kinds, the author's first; covered ones of the library are left out."""
        written = self.written.items()
        for _, definition in written:
            if definition.kind in kinds:
                yield definition
        covered = dict(written)
        for definition in self.library.values():
            if definition.kind in kinds and definition.name not in covered:
                yield definition

    def known(self, *kinds: str) -> list[str]:
        return [definition.name for definition in self.all(*kinds)]
