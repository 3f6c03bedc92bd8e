"""A place to what is around it, from the inside out: word, text, phrase, line, blocks, the whole file."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.places import offset, range_of
from facescript.lsp.server import FaceServer
from facescript.lsp.walk import Node, between, inside, phrases
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
    outer = spans[0]
    found = types.SelectionRange(range_of(outer))
    for inner in spans[1:]:
        if inner != outer and outer.start <= inner.start <= inner.end <= outer.end:
            outer = inner
            found = types.SelectionRange(range_of(outer), found)
    return found


def _around(nodes: Sequence[Node], at: int) -> Iterator[Span]:
    """Statements and blocks that a place stands in, then its phrase and what holds it there, outermost first."""
    for node in between(nodes, at, at):
        yield node.span
        yield from _around(inside(node), at)
        for phrase in phrases(node):
            yield from _in_phrase(phrase, at)
        return


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
