"""A name to all places that mean the same, over the files of the project."""

from __future__ import annotations

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.names.asking import asked, location, symbol_at
from facescript.lsp.server import FaceServer


def references(analysis: Analysis, place: types.Position, declaration: bool) -> list[types.Location]:
    """All that means what the name at a position means; with `declaration` its definition too."""
    at = symbol_at(analysis, place)
    if at is None:
        return []
    names, symbol = at
    spans = [mention.span for mention in names.mentions(symbol) if declaration or not mention.defines]
    return [found for span in spans if (found := location(analysis, span)) is not None]


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_REFERENCES)
    def _(_: FaceServer, params: types.ReferenceParams) -> list[types.Location]:
        analysis = asked(server.desk, params.text_document.uri)
        declaration = params.context.include_declaration
        return references(analysis, params.position, declaration) if analysis is not None else []
