"""A name to where it is defined: in the script, in one that it uses, in a table or in the library; a file to itself."""

from __future__ import annotations

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.names.asking import asked, location, mention_at, uri_in
from facescript.lsp.names.elsewhere import column_span
from facescript.lsp.names.model import Mention
from facescript.lsp.names.script import names_of
from facescript.lsp.names.spoken import word_span
from facescript.lsp.names.symbols import ProjectNames
from facescript.lsp.server import FaceServer
from facescript.resolve.files import project_path
from facescript.text import Span


def definition(analysis: Analysis, place: types.Position) -> types.Location | None:
    """Where the name at a position is defined."""
    mention = mention_at(analysis, place)
    if mention is None:
        return None
    if mention.space in ("file", "text"):
        return _file(analysis, mention)
    span = _WHERE.get(mention.space, _defined)(analysis, mention)
    return location(analysis, span) if span is not None else None


def _defined(analysis: Analysis, mention: Mention) -> Span | None:
    symbol = ProjectNames(analysis.world, analysis.compiled.script).symbol(mention, analysis.source.name)
    return symbol.span if symbol is not None else None


def _word(analysis: Analysis, mention: Mention) -> Span | None:
    """Where a word of a line is written. The line that a label names may be read only now."""
    act = mention.act
    if mention.local is not None:
        names_of(analysis.compiled.script).at(mention.local.span.start)
        act = mention.local.act
    return word_span(act, mention.name, mention.nth) if act is not None else None


def _column(analysis: Analysis, mention: Mention) -> Span | None:
    """Where a column is named in its table; of a crowd's member there is none."""
    table = mention.local.table if mention.local is not None else None
    return column_span(analysis.world, table, mention.name) if table is not None else None


_WHERE = {"word": _word, "column": _column, "spoken": _column}


def _file(analysis: Analysis, mention: Mention) -> types.Location | None:
    name = project_path(mention.span, mention.name)
    uri = uri_in(analysis.world, name) if analysis.world.exists(name) else None
    start = types.Position(0, 0)
    return types.Location(uri, types.Range(start, start)) if uri is not None else None


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    def _(_: FaceServer, params: types.DefinitionParams) -> types.Location | None:
        analysis = asked(server.desk, params.text_document.uri)
        return definition(analysis, params.position) if analysis is not None else None
