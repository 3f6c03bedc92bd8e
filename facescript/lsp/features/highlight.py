"""A name to all places in the document that mean the same."""

from __future__ import annotations

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.names.asking import asked, symbol_at
from facescript.lsp.names.script import names_of
from facescript.lsp.places import range_of
from facescript.lsp.server import FaceServer


def highlights(analysis: Analysis, place: types.Position) -> list[types.DocumentHighlight]:
    """What means the same as the name at a position; where it is defined, it is written."""
    at = symbol_at(analysis, place)
    if at is None:
        return []
    names, symbol = at
    found = []
    for mention in names_of(analysis.compiled.script).named(symbol.name):
        other = names.symbol(mention, analysis.source.name)
        if other is not None and other.key == symbol.key:
            kind = types.DocumentHighlightKind.Write if mention.defines else types.DocumentHighlightKind.Read
            found.append(types.DocumentHighlight(range_of(mention.span), kind))
    return found


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
    def _(_: FaceServer, params: types.DocumentHighlightParams) -> list[types.DocumentHighlight]:
        analysis = asked(server.desk, params.text_document.uri)
        return highlights(analysis, params.position) if analysis is not None else []
