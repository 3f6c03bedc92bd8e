"""What the parts of a script ask of names and files: what is answered otherwise than in the state before."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from facescript.ir.play import Face
from facescript.resolve.names import Definition
from facescript.resolve.notes import ALL, Ask
from facescript.resolve.project import Project
from facescript.resolve.watched import Watched
from facescript.text import Source, Span

FILES = "files"

NOWHERE = Span(Source("", ""), 0, 0)

Answer = tuple[object, object]
"""Of what sort something is, which is all that matters to those who look through a whole table; and what it is."""


class Same:
    """A node: it is another one where it was read anew, though it may say the same."""

    __slots__ = ("node",)

    def __init__(self, node: object) -> None:
        self.node = node

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and self.node is other.node

    __hash__ = None  # type: ignore[assignment]


class Answers:
    """The tables of one state of a script after the other."""

    def __init__(self) -> None:
        self._before: dict[str, dict[str, Answer]] = {}
        self._now: dict[str, dict[str, Answer]] = {}
        self._stamps: dict[str, Answer] = {}
        self._changed: set[Ask] = set()

    def begin(self, project: Project) -> None:
        """Another state. From now on the project's tables are watched."""
        self._before, self._now, self._changed = self._now, {}, set()
        project.names.written = self.table(project, "written", project.names.written)
        project.spoilt = self.table(project, "spoilt", project.spoilt)
        project.scripted = self.table(project, "scripted", project.scripted)
        project.faces = self.table(project, "faces", project.faces)
        project.targets = self.table(project, "targets", project.targets)
        self._compare(FILES, {name: ("", project.world.stamp(name)) for name in self._before.get(FILES, ())})
        self._stamps, self._now[FILES] = self._now[FILES], {}

    def table(self, project: Project, name: str, content: dict[str, Any]) -> dict[str, Any]:
        """A table that notes in the project's notes what is asked of it."""
        return Watched(project, name, content)

    def file(self, project: Project, name: str) -> None:
        """Notes that a file is asked for."""
        project.notes.asked.add((FILES, name))
        project.notes.filed = True
        self._now[FILES][name] = self._stamps.get(name) or ("", project.world.stamp(name))

    def files(self, asked: set[Ask]) -> None:
        """Files that are asked for as before."""
        self._now[FILES].update((name, self._stamps[name]) for table, name in asked if table == FILES)

    def settle(self, table: dict[str, Any]) -> None:
        """A table is complete."""
        assert isinstance(table, Watched)
        self._compare(table.name, {name: _answer(value) for name, value in dict.items(table)})

    def hold(self, asked: set[Ask]) -> bool:
        """Whether all is answered as it was."""
        return self._changed.isdisjoint(asked)

    def _compare(self, table: str, now: dict[str, Answer]) -> None:
        before = self._before.get(table, {})
        self._changed.update((table, name) for name, answer in now.items() if before.get(name) != answer)
        self._changed.update((table, name) for name in before.keys() - now.keys())
        if [(name, sort) for name, (sort, _) in before.items()] != [(name, sort) for name, (sort, _) in now.items()]:
            self._changed.add((table, ALL))
        self._now[table] = now


def _answer(value: object) -> Answer:
    if isinstance(value, Definition):
        return value.kind, Same(value.node)
    if isinstance(value, Face):  # where it is defined is nothing to those who ask for it
        return value.kind, replace(value, span=NOWHERE)
    return ("", None) if isinstance(value, Span) else (type(value), value)
