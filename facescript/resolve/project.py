"""What every part of the resolver shares: the world, the diagnostics, the definitions and what is known so far."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostics, Fix, Related, Severity
from facescript.ir.acts import Say
from facescript.ir.play import Face, Film, Target, Viseme
from facescript.ir.values import Mark
from facescript.resolve.memo import Memo
from facescript.resolve.names import Definition, Names
from facescript.resolve.notes import Notes, Question, Told
from facescript.resolve.spoilt import line_of
from facescript.resolve.suggest import meant
from facescript.syntax.tree import VisemeDefinition
from facescript.text import Span
from facescript.world import World

MOST_NODES, EACH = 10_000, 2
"""Statements that a play may have once its actions and its repeats over crowds and tables are unfolded: so many, and
`EACH` for each line that is written. A statement of many lines counts as more."""

LINE = 80
"""Characters of a line of usual length."""

MOST_WORDS = 50_000
"""Words that the names of one play (parameters, cells, `let`s, calls of expressions) may stand for in all."""

MANY = 100
"""Faults of a script beyond which nothing is sought that an unknown name may have meant."""

DEEPEST = 100
"""Blocks, actions, brackets and names that may stand in each other, all told."""


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
    memo: Memo = field(default_factory=Memo)
    notes: Notes = field(default_factory=Notes)
    film: Film = field(default_factory=Film)
    faces: dict[str, Face] = field(default_factory=dict)
    targets: dict[str, Target | None] = field(default_factory=dict)
    sounds: list[VisemeDefinition] = field(default_factory=list)
    visemes: dict[str, Viseme] = field(default_factory=dict)
    visemes_at: dict[str, Span] = field(default_factory=dict)
    scripted: dict[str, bool] = field(default_factory=dict)
    spoilt: dict[str, bool] = field(default_factory=dict)
    spoilt_lines: frozenset[tuple[str, int]] = frozenset()
    done: dict[tuple[object, ...], Any] = field(default_factory=dict)
    lines: dict[str, Say | None] = field(default_factory=dict)
    marks: list[tuple[Mark, Span]] = field(default_factory=list)
    refused: set[str] = field(default_factory=set)
    tracks: dict[str, Any] = field(default_factory=dict)
    pictures: dict[tuple[str, int], str] = field(default_factory=dict)
    most: int = MOST_NODES
    weight: int = 0
    stood_for: int = 0
    depth: int = 0
    deepest: int = 0
    open: list[Definition] = field(default_factory=list)
    circled: set[str] = field(default_factory=set)
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
        diagnostic = diagnose(code, span, fixes=fixes, related=related, **values)
        if self.cells:
            cell = self.cells[0]
            if diagnostic.severity is not Severity.ERROR:
                return
            reason = diagnostic.message.rstrip(".")
            diagnostic = diagnose(
                "FS323", cell.span, text=cell.text, row=cell.row, column=cell.column, file=cell.file, reason=reason
            )
        self.note(Told(span, diagnostic, code != "FS209"))

    def note(self, told: Told) -> None:
        """Tells something, and notes that it was told."""
        self.notes.told.append(told)
        self.tell(told)

    def tell(self, told: Told) -> None:
        """Adds what is told to the diagnostics, unless its line is in no state to be blamed for it."""
        if told.word:
            self.refused.add(told.word)
        span = told.span
        silent = span is not None and (_is_spoilt(self, span) or (told.shy and self._refused_in(span)))
        if told.diagnostic is not None and not silent:
            self.diagnostics.add(told.diagnostic)

    def asked(self, question: Question, span: Span) -> bool:
        """The answer of a question about the state of the work."""
        answer = question(self, span)
        self.notes.seen.append((question, span, answer))
        return answer

    def is_spoilt(self, span: Span) -> bool:
        """Whether any of it stands in a line that could not be read, or in the block of such a line."""
        return self.asked(_is_spoilt, span)

    def world_of(self, name: str) -> World:
        """The world, to be asked for a file of that name."""
        self.memo.file(self, name)
        return self.world

    def is_told(self, span: Span) -> bool:
        """Whether something was told of just this place."""
        return self.asked(_is_told, span)

    def refuse_word(self, span: Span) -> Refused:
        """Refuses a word of the language as a name. Nothing is said of the lines that use it: they cannot be read."""
        self.report("FS209", span, name=span.text)
        self.note(Told(None, None, word=span.text))
        return Refused()

    def _refused_in(self, span: Span) -> bool:
        if not self.refused:
            return False
        line = span.source.line(line_of(span)[1])
        return any(re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", line) for word in self.refused)

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
            clause, fixes = self.meant(name, known, span)
            self.report(code, span, fixes=fixes, name=name, meant=clause)
        return Refused()

    def meant(self, name: str, known: Iterable[str], span: Span) -> tuple[str, tuple[Fix, ...]]:
        """What an author may have meant by a name, as a clause and a fix; not sought any more after many faults."""
        self.notes.guessed = True
        return meant(name, known if len(self.diagnostics.items) < MANY else (), span)

    @contextmanager
    def entering(self, definition: Definition, span: Span) -> Iterator[None]:
        """Works out a definition; one that is reached from itself is refused with the whole circle."""
        self.notes.entered.add(definition.name)
        if definition.name in self.circled or (definition in self.open and self.is_spoilt(span)):
            raise Refused
        if definition in self.open:
            circle = self.open[self.open.index(definition) :]
            self.circled.update(item.name for item in circle)
            chain = " -> ".join(item.name for item in (*circle, definition))
            raise self.refuse("FS215", definition.span, kind=definition.kind, name=definition.name, chain=chain)
        self.open.append(definition)
        try:
            with self.deeper(span):
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

    @contextmanager
    def deeper(self, span: Span) -> Iterator[None]:
        """While what stands inside something is read; a script that goes too deep is refused."""
        self.depth += 1
        if self.depth > DEEPEST:
            raise TooMuch(span, DEEPEST, "levels, one in another")
        if self.depth > self.deepest:
            self.deepest = self.depth
        try:
            yield
        finally:
            self.depth -= 1

    def spend(self, span: Span, length: int = 0) -> None:
        """Counts a statement, one of great `length` as several; a script that unfolds into too many is refused."""
        self.weight += 1 + length // LINE
        if self.weight > self.most:
            raise TooMuch(span, self.most, "statements")

    def stand_for(self, words: int, span: Span) -> None:
        """Counts the words that a name stands for; a script that comes to too many is refused."""
        self.stood_for += 1 + words
        if self.stood_for > MOST_WORDS:
            raise TooMuch(span, MOST_WORDS, "words that names stand for")


class TooMuch(Exception):
    """A script unfolds into too much; `args` are the span of what went too far, the bound, and what is counted."""


def _is_spoilt(project: Project, span: Span) -> bool:
    if not project.spoilt_lines:
        return False
    name, first = line_of(span)
    last = span.source.position(span.end)[0]
    return any((name, line) in project.spoilt_lines for line in range(first, last + 1))


def _is_told(project: Project, span: Span) -> bool:
    return any(item.span == span for item in project.diagnostics)
