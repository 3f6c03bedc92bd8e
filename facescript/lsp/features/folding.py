"""A document to what can be folded: blocks, lines that go on, and runs of comments; of a broken file too.

Blocks are what is indented: so they fold while a line in them cannot be read.
"""

from __future__ import annotations

from collections.abc import Iterator

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.server import FaceServer
from facescript.syntax.lexer import LARGEST

BLANK, COMMENT = -1, -2


def folding(analysis: Analysis) -> list[types.FoldingRange]:
    """In the order of their first lines; nothing of a file that is too large to be read."""
    if len(analysis.source.text) > LARGEST:
        return []
    indents = [_indent(line) for line in analysis.source.text.split("\n")]
    return sorted([*_blocks(indents), *_comments(indents)], key=lambda found: (found.start_line, -found.end_line))


def _indent(line: str) -> int:
    """Columns of a line's margin; BLANK and COMMENT for lines without words."""
    bare = line.lstrip()
    if not bare:
        return BLANK
    if bare.rstrip() == "#" or bare.startswith(("# ", "#\t", "#!")):
        return COMMENT
    return len(line) - len(bare)


def _blocks(indents: list[int]) -> Iterator[types.FoldingRange]:
    """Each line with those below it that are indented more, to the last that holds a word."""
    opened: list[tuple[int, int]] = []
    last = 0
    for number, indent in enumerate([*indents, 0]):
        if indent < 0:
            continue
        while opened and opened[-1][1] >= indent:
            first = opened.pop()[0]
            if last > first:
                yield types.FoldingRange(first, last)
        opened.append((number, indent))
        last = number


def _comments(indents: list[int]) -> Iterator[types.FoldingRange]:
    first: int | None = None
    for number, indent in enumerate([*indents, BLANK]):
        if indent == COMMENT:
            first = number if first is None else first
        elif first is not None:
            if number - 1 > first:
                yield types.FoldingRange(first, number - 1, kind=types.FoldingRangeKind.Comment)
            first = None


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_FOLDING_RANGE)
    def asked(_: FaceServer, params: types.FoldingRangeParams) -> list[types.FoldingRange]:
        return folding(server.desk.analysis(params.text_document.uri))
