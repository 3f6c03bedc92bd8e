"""What every part of the resolver shares: the world, the diagnostics, the definitions and what is known so far."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostics, Fix, Related, Severity
from facescript.ir.play import Face, Film, Target
from facescript.ir.values import Driver, Mark
from facescript.resolve.names import Definition, Names
from facescript.resolve.suggest import meant
from facescript.text import Span
from facescript.world import World

MOST_NODES = 50_000
"""Statements that a play may have once its actions and its repeats over crowds and tables are unfolded."""

MOST_CALLS = 5_000
"""Calls of expressions with parameters that are worked out for one play."""


class Refused(Exception):
    """A fault has been reported; what was being read has no value."""


@dataclass(frozen=True, slots=True)
class Cell:
    """The cell of a table that is being read, for messages: file, row from 1 (after the header), column."""

    file: str
    row: int
    column: str
    text: str
    span: Span


@dataclass(slots=True)
class Project:
    world: World
    diagnostics: Diagnostics
    names: Names
    film: Film = field(default_factory=Film)
    faces: dict[str, Face] = field(default_factory=dict)
    targets: dict[str, Target | None] = field(default_factory=dict)
    persons_arrive: bool = False
    spoilt: frozenset[str] = frozenset()
    spoilt_lines: frozenset[tuple[str, int]] = frozenset()
    drivers: dict[tuple[str, str], tuple[Driver, ...]] = field(default_factory=dict)
    lines: dict[str, str | None] = field(default_factory=dict)
    marks: list[tuple[Mark, Span]] = field(default_factory=list)
    weight: int = 0
    calls: int = 0
    open: list[Definition] = field(default_factory=list)
    circled: set[Definition] = field(default_factory=set)
    cells: list[Cell] = field(default_factory=list)

    def report(
        self,
        code: str,
        span: Span | None,
        *,
        fixes: tuple[Fix, ...] = (),
        related: tuple[Related, ...] = (),
        **values: object,
    ) -> None:
        """Adds a diagnostic; a fault in a table's cell is told at the statement that reads it.

        Nothing more is said of a line that could not be read as it stands.
        """
        if span is not None and self.spoilt_lines and _line(span) in self.spoilt_lines:
            return
        diagnostic = diagnose(code, span, fixes=fixes, related=related, **values)
        if self.cells:
            cell = self.cells[0]
            if diagnostic.severity is not Severity.ERROR:
                return
            reason = diagnostic.message.rstrip(".")
            diagnostic = diagnose(
                "FS323", cell.span, text=cell.text, row=cell.row, column=cell.column, file=cell.file, reason=reason
            )
        self.diagnostics.add(diagnostic)

    def refuse(
        self,
        code: str,
        span: Span | None,
        *,
        fixes: tuple[Fix, ...] = (),
        related: tuple[Related, ...] = (),
        **values: object,
    ) -> Refused:
        """Adds a diagnostic; the exception to raise, which gives up what is being read."""
        self.report(code, span, fixes=fixes, related=related, **values)
        return Refused()

    def unknown(self, code: str, name: str, known: list[str], span: Span) -> Refused:
        """Refuses an unknown name with the nearest known one; silent where a spoilt line may have defined it."""
        if name not in self.spoilt:
            clause, fixes = meant(name, known, span)
            self.report(code, span, fixes=fixes, name=name, meant=clause)
        return Refused()

    @contextmanager
    def entering(self, definition: Definition, span: Span) -> Iterator[None]:
        """Works out a definition; one that is reached from itself is refused with the whole circle."""
        if definition in self.circled:
            raise Refused
        if definition in self.open:
            circle = self.open[self.open.index(definition) :]
            self.circled.update(circle)
            chain = " -> ".join(item.name for item in (*circle, definition))
            raise self.refuse("FS215", definition.span, kind=definition.kind, name=definition.name, chain=chain)
        self.open.append(definition)
        try:
            yield
        finally:
            self.open.pop()

    @contextmanager
    def blaming(self, cell: Cell | None) -> Iterator[None]:
        """While faults are those of a table's cell, if there is one."""
        if cell is None:
            yield
            return
        self.cells.append(cell)
        try:
            yield
        finally:
            self.cells.pop()

    def spend(self, amount: int, span: Span) -> None:
        """Counts statements; a script that unfolds into too many is refused."""
        self.weight += amount
        if self.weight > MOST_NODES:
            raise TooMuch(span, MOST_NODES, "statements")

    def called(self, span: Span) -> None:
        """Counts calls of expressions with arguments; a script that comes to too many is refused."""
        self.calls += 1
        if self.calls > MOST_CALLS:
            raise TooMuch(span, MOST_CALLS, "calls of expressions")


def spoilt_lines(diagnostics: Diagnostics) -> frozenset[tuple[str, int]]:
    """The lines (source's name, number) that hold an error so far: of the parser, before anything is resolved."""
    errors = (item for item in diagnostics if item.severity is Severity.ERROR)
    return frozenset(_line(item.span) for item in errors if item.span is not None)


def _line(span: Span) -> tuple[str, int]:
    return span.source.name, span.source.position(span.start)[0]


class TooMuch(Exception):
    """A script unfolds into too much; `args` are the span of what went too far, the bound, and what is counted."""
