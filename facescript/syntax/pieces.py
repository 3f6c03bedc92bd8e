"""A source that is edited again and again to its tree: lines that stayed as they were are not read again.

A piece is a run of lines from one without indentation up to another. It is read as if nothing stood around it; what
could reach over its borders is part of what it is kept by: whether its last line would go on in the next, and odd
indentations that were told before. All spans in a piece hang on its `Piece`, so a piece that moves is not touched.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from facescript.diagnostics.model import Diagnostic, Diagnostics
from facescript.syntax.blocks import cut
from facescript.syntax.commas import settle
from facescript.syntax.faults import MOST, Faults
from facescript.syntax.lexer import LARGEST, lex
from facescript.syntax.parser import parse
from facescript.syntax.reader import Reader
from facescript.syntax.tree import Item, Script
from facescript.text import Piece, Source

HEAD = re.compile(r"^\w", re.MULTILINE)
"""Where a piece may begin: at a line that begins with a letter. A comment stays with the lines above it."""


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """A piece and what was read in it: its items, the names that were lost, what is wrong.

    `before` and `after` are the odd indentations (`blocks.cut`) known at its borders; `open` is whether its last line
    would go on.
    """

    text: str
    place: Piece
    items: tuple[Item, ...]
    lost: frozenset[str]
    faults: list[Diagnostic]
    found: int
    before: dict[int, int]
    after: dict[int, int]
    open: bool


class Pieces:
    """Reads one source after another, each much like the one before.

    What `parse` gave before is not to be used any more once it is called again: its spans have moved.
    """

    def __init__(self) -> None:
        self._parts: list[Part] = []
        self._reader: Reader | None = None

    def parse(self, source: Source, diagnostics: Diagnostics) -> Script:
        """The same as `parser.parse`, tree and diagnostics."""
        parts = self._renewed(source) if len(source.text) <= LARGEST else None
        if parts is None or not any(part.items or part.found for part in parts):
            self._parts = []
            return parse(source, diagnostics)
        self._parts = parts
        begin = 0
        items: list[Item] = []
        for part in parts:
            part.place.source, part.place.begin = source, begin
            begin += len(part.text)
            items += part.items
            for fault in part.faults:
                diagnostics.add(fault)
        return Script(source, tuple(items), frozenset().union(*(part.lost for part in parts if part.lost)))

    def _renewed(self, source: Source) -> list[Part] | None:
        """The parts of a source, in order; None where more is wrong than is told."""
        text = source.text
        parts, at = self._front(text)
        rest, limit = self._rest(text, at, len(parts))
        found = sum(part.found for part in parts)
        while at < len(text):
            odd = parts[-1].after if parts else {}
            if at == limit and rest[-1].before == odd:
                parts += reversed(rest)
                break
            parts.append(self._next(source, at, odd))
            at += len(parts[-1].text)
            while limit < at:
                limit += len(rest.pop().text)
            found += parts[-1].found
            if found > MOST:
                return None
        return parts if sum(part.found for part in parts) <= MOST else None

    # -------------------------------------------------------------------------------------------- what stayed

    def _front(self, text: str) -> tuple[list[Part], int]:
        """The parts before the first change, and where they end."""
        kept: list[Part] = []
        at = 0
        for part in self._parts:
            if not text.startswith(part.text, at):
                break
            kept.append(part)
            at += len(part.text)
        while kept and at < len(text) and (kept[-1].open or not HEAD.match(text, at)):
            at -= len(kept.pop().text)
        return kept, at

    def _rest(self, text: str, at: int, known: int) -> tuple[list[Part], int]:
        """The parts behind the last change, the last one first, and where they would begin; none begins before `at`.

        They stay if a part ends just there; what is read up to their beginning may as well go on into them.
        """
        kept: list[Part] = []
        begin = len(text)
        for part in reversed(self._parts[known:]):
            if not text.endswith(part.text, at, begin):
                break
            kept.append(part)
            begin -= len(part.text)
        return kept, begin

    # -------------------------------------------------------------------------------------------- what is new

    def _next(self, source: Source, at: int, odd: dict[int, int]) -> Part:
        """The part that begins at an offset: up to where a line without indentation begins something new."""
        end, more = at, 1
        while True:
            for _ in range(more):
                head = HEAD.search(source.text, end + 1)
                end = head.start() if head else len(source.text)
            part = self._read(source.name, source.text[at:end], odd)
            if not part.open or end == len(source.text):
                return part
            more *= 2

    def _read(self, name: str, text: str, odd: dict[int, int]) -> Part:
        place = Piece(Source(name, text))
        faults = Faults(place)
        if self._reader is None:
            self._reader = Reader(faults)
        self._reader.turn_to(faults)
        lexed = lex(Source(name, text.removesuffix("\n")), faults)
        after = dict(odd)
        items: list[Item] = []
        for block in cut(lexed.lines, faults, after):
            items += self._reader.items(block)
        settled = settle(items, faults)
        after = {indent: width for indent, width in after.items() if not width}
        lost = frozenset(self._reader.lost)
        return Part(text, place, settled, lost, faults.items, faults.found, odd, after, lexed.open)
