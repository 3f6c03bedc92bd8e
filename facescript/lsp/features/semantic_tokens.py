"""A document to the colours of its words: tokens in the numbers of the protocol, whole or a part."""

from __future__ import annotations

from collections.abc import Sequence

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.places import offset, units
from facescript.lsp.server import FaceServer
from facescript.lsp.tokens import Packed, tokens, unpack
from facescript.text import Source

KEPT = 8
"""Documents of which is kept what was told of them."""

Answer = types.SemanticTokens | types.SemanticTokensDelta


def semantic_tokens(analysis: Analysis, within: types.Range | None = None) -> list[int]:
    """Five numbers a token; `within` a range only those that begin in it."""
    if within is None:
        return _numbers(analysis.source, tokens(analysis))
    first, last = (offset(analysis.source, place) for place in (within.start, within.end))
    found = tokens(analysis, first, last)
    return _numbers(analysis.source, [one for one in found if first <= unpack(one)[0] <= last])


def _numbers(source: Source, found: Sequence[Packed]) -> list[int]:
    numbers: list[int] = []
    line = column = start = 0
    after = -1
    plain = source.text.isascii()
    for begin, end, meaning, bits in map(unpack, found):
        before = line
        if begin >= after:
            line, start, after = _line(source, begin)
        place, length = begin - start, end - begin
        if not plain:
            place, length = units(source.text[start:begin]), units(source.text[begin:end])
        numbers += (line - before, place - column if line == before else place, length, meaning, bits)
        column = place
    return numbers


def _line(source: Source, at: int) -> tuple[int, int, int]:
    """The number (from 0) of the line of an offset, where it begins, and where the next does."""
    line, column = source.position(at)
    after = source.offset(line + 1)
    return line - 1, at - column + 1, len(source.text) + 1 if after is None else after


def change(before: Sequence[int], after: Sequence[int]) -> list[types.SemanticTokensEdit]:
    """What makes the numbers of one state those of the next: one stretch, from the first that differs to the last."""
    if before == after:
        return []
    most = min(len(before), len(after))
    start = next((place for place in range(most) if before[place] != after[place]), most)
    end = next((place for place in range(most - start) if before[-1 - place] != after[-1 - place]), most - start)
    return [types.SemanticTokensEdit(start, len(before) - start - end, after[start : len(after) - end])]


class Told:
    """What each client was told last of a document, of the last few documents, so that only changes are sent."""

    def __init__(self) -> None:
        self.count = 0
        self.numbers: dict[str, tuple[str, list[int]]] = {}

    def tell(self, uri: str, numbers: list[int]) -> str:
        """Keeps what is told now; its name."""
        self.count += 1
        self.numbers.pop(uri, None)
        self.numbers[uri] = str(self.count), numbers
        while len(self.numbers) > KEPT:
            del self.numbers[next(iter(self.numbers))]
        return str(self.count)


def register(server: FaceServer) -> None:
    told = Told()

    @server.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL)
    def whole(_: FaceServer, params: types.SemanticTokensParams) -> types.SemanticTokens:
        uri = params.text_document.uri
        numbers = semantic_tokens(server.desk.analysis(uri))
        return types.SemanticTokens(numbers, told.tell(uri, numbers))

    @server.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL_DELTA)
    def changed(
        _: FaceServer, params: types.SemanticTokensDeltaParams
    ) -> types.SemanticTokens | types.SemanticTokensDelta:
        uri = params.text_document.uri
        name, before = told.numbers.get(uri, ("", []))
        numbers = semantic_tokens(server.desk.analysis(uri))
        now = told.tell(uri, numbers)
        if name != params.previous_result_id:
            return types.SemanticTokens(numbers, now)
        return types.SemanticTokensDelta(change(before, numbers), now)

    @server.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE)
    def part(_: FaceServer, params: types.SemanticTokensRangeParams) -> types.SemanticTokens:
        return types.SemanticTokens(semantic_tokens(server.desk.analysis(params.text_document.uri), params.range))
