"""A place to what is around it, from the inside out: word, text, phrase, line, blocks, the whole file."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.places import offset, range_of
from facescript.lsp.server import FaceServer
from facescript.lsp.statements import Node, between, inside
from facescript.syntax import tree
from facescript.text import Source, Span

WORD = re.compile(r"[\w'’%#-]+(?:\.\w+)*")
"""What is a word to an author, in texts and in lines that cannot be read as well."""


def selection(analysis: Analysis, places: Sequence[types.Position]) -> list[types.SelectionRange]:
    """One chain of ranges for each place, each inside the next."""
    return [_chain(analysis, offset(analysis.source, place)) for place in places]


def _chain(analysis: Analysis, at: int) -> types.SelectionRange:
    source = analysis.source
    spans = [Span(source, 0, len(source.text)), *_around(analysis.compiled.script.items, at), *_word(source, at)]
    found = types.SelectionRange(range_of(spans[0]))
    for outer, inner in pairwise(spans):
        if (outer.start, outer.end) != (
            inner.start,
            inner.end,
        ) and outer.start <= inner.start <= inner.end <= outer.end:
            found = types.SelectionRange(range_of(inner), found)
    return found


def _around(nodes: Sequence[Node], at: int) -> Iterator[Span]:
    """Statements and blocks that a place stands in, then its phrase and what holds it there, outermost first."""
    for node in between(nodes, at, at):
        yield node.span
        yield from _around(inside(node), at)
        for phrase in _phrases(node):
            yield from _in_phrase(phrase, at)
        return


def _phrases(node: Node) -> Iterator[tree.Phrase]:
    """The phrases of a node's own line, and of the lines of a declaration."""
    match node:
        case tree.Act() | tree.Setting():
            yield from node.phrases
        case tree.Declaration():
            yield from node.phrases
            for line in node.lines:
                yield from line
        case tree.ExpressionDefinition() | tree.LetDefinition() | tree.VisemeDefinition():
            yield node.value
        case tree.Repeat():
            yield node.how
        case tree.Moment():
            yield node.time
        case tree.When():
            yield node.event


def _in_phrase(phrase: tree.Phrase, at: int) -> Iterator[Span]:
    if not phrase.span.start <= at <= phrase.span.end:
        return
    yield phrase.span
    for word in phrase.words:
        if word.span.start <= at <= word.span.end:
            yield from _in_word(word, at)
            return


def _in_word(word: tree.Word, at: int) -> Iterator[Span]:
    yield word.span
    if isinstance(word, tree.Bracket):
        yield from _in_phrase(word.inner, at)
    elif isinstance(word, tree.Call):
        for argument in word.arguments:
            yield from _in_phrase(argument.value, at)
    elif isinstance(word, tree.String):
        yield Span(word.span.source, word.span.start + 1, word.span.end - 1)


def _word(source: Source, at: int) -> Iterator[Span]:
    """The word at a place; none between two of them."""
    line, column = source.position(at)
    for match in WORD.finditer(source.line(line)):
        if match.start() < column <= match.end() + 1:
            yield Span(source, at - column + 1 + match.start(), at - column + 1 + match.end())
            return


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_SELECTION_RANGE)
    def asked(_: FaceServer, params: types.SelectionRangeParams) -> list[types.SelectionRange]:
        return selection(server.desk.analysis(params.text_document.uri), params.positions)
