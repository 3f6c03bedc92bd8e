"""A source to the tree of a script; and the phrases of a cue that stands in a text."""

from __future__ import annotations

from facescript.diagnostics.model import Diagnostics
from facescript.syntax.blocks import cut
from facescript.syntax.commas import settle
from facescript.syntax.faults import Faults
from facescript.syntax.lexer import lex, lex_piece
from facescript.syntax.reader import Reader
from facescript.syntax.tree import Item, Phrase, Script
from facescript.text import Source, Span


def parse(source: Source, diagnostics: Diagnostics) -> Script:
    """The tree of all that can be read; what cannot is in `diagnostics` (codes FS1xx), its names in `Script.lost`."""
    faults = Faults(source)
    script = read(source, faults)
    faults.pour(diagnostics)
    return script


def read(source: Source, faults: Faults) -> Script:
    """`parse` with what is wrong still in the hands of the caller."""
    lexed = lex(source, faults)
    if not lexed.lines and not faults.found:
        faults.add("FS123", 0, 0)
    reader = Reader(faults)
    items: list[Item] = []
    for block in cut(lexed.lines, faults):
        items += reader.items(block)
    return Script(source, settle(items, faults), frozenset(reader.lost))


def parse_phrases(span: Span, diagnostics: Diagnostics) -> tuple[Phrase, ...] | None:
    """The phrases of a piece of a line: a cue in a text, a value on the command line. None where it cannot be read."""
    faults = Faults(span.place)
    phrases: tuple[Phrase, ...] | None = Reader(faults).cue(lex_piece(span.text, span.first, faults))
    faults.pour(diagnostics)
    return phrases
