"""A script to the names in what it reads besides scripts: cells of its tables, and brackets in files of text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace

from facescript.lsp.desk import OpenWorld
from facescript.lsp.names.model import GLOBAL, Mention, Sight
from facescript.lsp.names.script import ScriptNames
from facescript.lsp.names.words import read, text
from facescript.resolve.cells import cell_words
from facescript.resolve.files import project_path
from facescript.syntax.tree import String
from facescript.text import Source, Span
from facescript.world import WorldFailure

_READS = re.compile(r'\bin +"|\btext +"')
"""What stands in every script that repeats over a table, or speaks a file."""

_CELL = re.compile(r'"([^"]*)"(?=,|$)|([^,]*)')


def elsewhere(world: OpenWorld, script: ScriptNames) -> Iterator[Mention]:
    """The names of definitions in the files that a script reads. A cell counts where the script reads its column."""
    if _READS.search(script.source.text) is None:
        return
    columns: dict[String, dict[str, bool]] = {}
    for mention in script.all():
        table = mention.local.table if mention.local is not None else None
        if mention.space == "text":
            yield from _text(_source(world, mention.span, mention.name))
        elif mention.space in ("column", "spoken") and table is not None:
            columns.setdefault(table, {})[mention.name] = mention.space == "spoken"
    seen: set[tuple[str, int]] = set()
    for table, wanted in columns.items():
        for mention in _cells(_source(world, table.span, table.value), wanted):
            place = mention.span.source.name, mention.span.start
            if place not in seen:
                seen.add(place)
                yield mention


def column_span(world: OpenWorld, table: String, name: str) -> Span | None:
    """Where a table names a column."""
    source = _source(world, table.span, table.value)
    line = source.line(1) if source is not None else ""
    spans = (span for span in _spans(line) if line[span[0] : span[1]].strip() == name)
    found = next(spans, None)
    return Span(source, *found) if source is not None and found is not None else None


def _source(world: OpenWorld, span: Span, path: str) -> Source | None:
    try:
        return world.source(project_path(span, path))
    except WorldFailure:
        return None


def _text(source: Source | None) -> list[Mention]:
    if source is None:
        return []
    sight = Sight([])
    text(sight, String(source.text, Span(source, -1, len(source.text) + 1)))
    return sight.found


def _cells(source: Source | None, columns: dict[str, bool]) -> Iterator[Mention]:
    """The names in a table's columns; `columns` says of each whether its cells are spoken."""
    header: list[str] | None = None
    at = 0
    for line in source.text.split("\n") if source is not None else ():
        spans = list(_spans(line))
        if header is None:
            header = [line[start:end].strip() for start, end in spans]
        elif source is not None:
            for name, (start, end) in zip(header, spans, strict=False):
                if name in columns:
                    yield from _cell(Span(source, at + start, at + end), columns[name])
        at += len(line) + 1


def _spans(line: str) -> Iterable[tuple[int, int]]:
    """Where the cells of a line are, without the quotes around them."""
    at = 0
    while at <= len(line):
        found = _CELL.match(line, at)
        assert found is not None
        yield found.span(1 if found[1] is not None else 2)
        at = found.end() + 1


def _cell(span: Span, spoken: bool) -> Iterator[Mention]:
    written = span.text
    bare = written.strip()
    start = span.start + written.index(bare)
    sight = Sight([])
    if spoken:
        text(sight, String(bare, Span(span.source, start - 1, start + len(bare) + 1)))
        yield from sight.found
        return
    read(sight, (word for word in cell_words(span.source.name, bare) if not isinstance(word, String)), GLOBAL)
    for mention in sight.found:
        there = Span(span.source, start + mention.span.start, start + mention.span.end)
        yield replace(mention, span=there)
