"""What a play has names for, and what they are called in its script."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass, field
from posixpath import dirname, relpath

from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Life
from facescript.ir.values import Driver
from facescript.resolve.definitions import library_names
from facescript.resolve.lives import preset
from facescript.resolve.mixes import expression_drivers
from facescript.resolve.project import Project, Refused
from facescript.resolve.uses import library
from facescript.resolve.words import WORDS
from facescript.text import Source, Span
from facescript.world import World

NOWHERE = Span(Source("", ""), 0, 0)


@dataclass(frozen=True, slots=True)
class Row:
    """One line of a script: how deep it stands, its text, and the place of what it says in the play."""

    depth: int
    text: str
    span: Span


@dataclass(slots=True)
class Context:
    """`script` is the path of the script in its project; `taken` are the names that stand for something already."""

    world: World
    script: str
    taken: set[str]
    project: Project = field(init=False)
    definitions: list[Row] = field(default_factory=list)
    renamed: dict[str, tuple[str, Span]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.project = Project(self.world, Diagnostics(), library_names(library(self.world)))

    def path(self, name: str) -> str:
        """A file of the project as the script names it."""
        return relpath(name or ".", dirname(self.script) or ".")

    def fresh(self, name: str, others: Container[str] = ()) -> str:
        """`name`, or with a number where that is taken."""
        found, number = name, 1
        while found in self.taken or found in WORDS or found in others:
            number += 1
            found = f"{name}_{number}"
        return found

    def library_life(self, name: str) -> Life | None:
        """A life of the library; None where it has none of that name."""
        try:
            return preset(self.project, name, NOWHERE)
        except Refused:
            return None

    def library_drivers(self, name: str, side: str) -> tuple[Driver, ...] | None:
        """What an expression of the library drives at 100 %; None where it has none of that name or side."""
        definition = self.project.names.library.get(name)
        if definition is None or definition.kind != "expression":
            return None
        try:
            return expression_drivers(self.project, definition, side, NOWHERE)
        except Refused:
            return None
