"""A document to the edits that bring it, or a part of it, into the one layout; one with errors is left alone."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import SequenceMatcher

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.server import FaceServer
from facescript.syntax.formatter import format_source


def edits(analysis: Analysis) -> list[types.TextEdit]:
    """What differs in the layout of the whole document, line by line."""
    return list(_differences(analysis.source.text.split("\n"), format_source(analysis.source).split("\n")))


def edits_within(analysis: Analysis, where: types.Range) -> list[types.TextEdit]:
    """Those of `edits` that touch no line outside of a range; a last line of which nothing is chosen is outside."""
    last = where.end.line + (1 if where.end.character or where.start == where.end else 0)
    return [
        edit for edit in edits(analysis) if where.start.line <= edit.range.start.line and edit.range.end.line <= last
    ]


def _differences(old: list[str], new: list[str]) -> Iterator[types.TextEdit]:
    """A line that became one line is an edit of its own, so that a range may take it without its neighbours."""
    head = _same(old, new)
    tail = min(_same(old[::-1], new[::-1]), len(old) - head, len(new) - head)
    matcher = SequenceMatcher(None, old[head : len(old) - tail], new[head : len(new) - tail])
    for kind, first, last, start, end in matcher.get_opcodes():
        if kind == "equal":
            continue
        if last - first == end - start:
            for step in range(last - first):
                yield _edit(old, head + first + step, head + first + step + 1, [new[head + start + step]])
        else:
            yield _edit(old, head + first, head + last, new[head + start : head + end])


def _same(old: list[str], new: list[str]) -> int:
    """How many lines both begin with."""
    count = 0
    for one, other in zip(old, new, strict=False):
        if one != other:
            break
        count += 1
    return count


def _edit(old: list[str], first: int, last: int, new: list[str]) -> types.TextEdit:
    """Replaces whole lines with their ends; the last line of a text has none, so there the end before it goes along."""
    if last < len(old):
        where = types.Range(types.Position(first, 0), types.Position(last, 0))
        return types.TextEdit(where, "".join(f"{line}\n" for line in new))
    if first == 0:
        return types.TextEdit(types.Range(types.Position(0, 0), _end(old, last - 1)), "\n".join(new))
    return types.TextEdit(types.Range(_end(old, first - 1), _end(old, last - 1)), "".join(f"\n{line}" for line in new))


def _end(lines: list[str], number: int) -> types.Position:
    return types.Position(number, len(lines[number].encode("utf-16-le")) // 2)


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_FORMATTING)
    def whole(_: FaceServer, params: types.DocumentFormattingParams) -> list[types.TextEdit]:
        uri = params.text_document.uri
        return edits(server.desk.analysis(uri)) if uri in server.workspace.text_documents else []

    @server.feature(types.TEXT_DOCUMENT_RANGE_FORMATTING)
    def part(_: FaceServer, params: types.DocumentRangeFormattingParams) -> list[types.TextEdit]:
        uri = params.text_document.uri
        if uri not in server.workspace.text_documents:
            return []
        return edits_within(server.desk.analysis(uri), params.range)
