"""Cells of tables to words of the language, each when a statement first reads it."""

from __future__ import annotations

from functools import lru_cache

from facescript.diagnostics.model import Diagnostics
from facescript.syntax.parser import parse_phrases
from facescript.syntax.tree import String, Word
from facescript.text import Source, Span


@lru_cache(maxsize=4096)
def cell_words(file: str, cell: str) -> tuple[Word, ...]:
    """A cell as words of the language; what cannot be one is a text. Parsed once for the same text."""
    source = Source(file, cell)
    whole = Span(source, 0, len(cell))
    phrases = parse_phrases(whole, Diagnostics())
    if phrases is None or len(phrases) != 1 or not phrases[0].words:
        return (String(cell, whole),)
    return phrases[0].words
