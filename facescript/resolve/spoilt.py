"""Lines that could not be read to what must not be blamed for them: the lines of their blocks, the names in them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from facescript.diagnostics.model import Diagnostics, Severity
from facescript.text import Source, Span

Place = tuple[str, int]
"""A line: its source's name, its number."""


def line_of(span: Span) -> Place:
    """The line in which a span begins."""
    return span.source.name, span.source.position(span.start)[0]


def spoilt(diagnostics: Diagnostics) -> tuple[frozenset[Place], frozenset[str]]:
    """The lines with errors and all lines in their blocks, and the names in the lines with errors.

    To be asked when all is parsed and nothing resolved: where the head of a block could not be read, what stands in
    the block may have come to stand elsewhere.
    """
    found = {
        line_of(item.span): item.span.source for item in diagnostics if item.span and item.severity is Severity.ERROR
    }
    lines: set[Place] = set()
    names: set[str] = set()
    for (name, number), source in found.items():
        if (name, number) not in lines:
            lines.update((name, line) for line in _block(source, number))
        names.update(_names(source.line(number)))
    return frozenset(lines), frozenset(names)


def _block(source: Source, number: int) -> Iterator[int]:
    """The line and those behind it that stand deeper; a tab counts for nothing."""
    yield number
    depth = _depth(source.line(number))
    for line in range(number + 1, source.text.count("\n") + 2):
        text = source.line(line)
        if text.strip() and _depth(text) <= depth:
            return
        yield line


def _depth(text: str) -> int:
    text = text.replace("\t", "")
    return len(text) - len(text.lstrip())


def _names(text: str) -> Iterator[str]:
    """The names in a line as it is, and as it would be without stray signs."""
    for line in (text, re.sub(r"[^\w\s.,:()=*/\"+-]", "", text)):
        yield from re.findall(r"[\w-]+", line)
