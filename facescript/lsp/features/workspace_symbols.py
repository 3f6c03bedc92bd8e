"""A few letters to the definitions, scenes and labels of all projects at hand that have them in their names."""

from __future__ import annotations

from collections.abc import Iterator

from lsprotocol import types

from facescript.lsp.desk import Desk, OpenWorld
from facescript.lsp.names.asking import uri_in
from facescript.lsp.names.model import Mention
from facescript.lsp.names.symbols import ProjectNames
from facescript.lsp.places import range_of
from facescript.lsp.server import FaceServer

MOST = 1_000
"""Symbols that are told at once."""

Kind = types.SymbolKind

KINDS = {
    "face": Kind.Class,
    "kind": Kind.Interface,
    "life": Kind.Struct,
    "target": Kind.Variable,
    "expression": Kind.Function,
    "action": Kind.Method,
    "let": Kind.Constant,
    "scene": Kind.Module,
    "label": Kind.Key,
    "viseme": Kind.String,
}
"""What is told, by what a mention defines, and what it is to an editor."""


def workspace_symbols(desk: Desk, query: str) -> list[types.WorkspaceSymbol]:
    """What has the letters of `query` in this order in its name, each place once."""
    found: dict[tuple[str, int], types.WorkspaceSymbol] = {}
    for world in desk.worlds():
        for uri, mention in _defined(world, query.casefold()):
            place = types.Location(uri, range_of(mention.span))
            told = types.WorkspaceSymbol(place, mention.name, KINDS[mention.defines], container_name=_file(mention))
            found.setdefault((uri, mention.span.start), told)
            if len(found) >= MOST:
                return list(found.values())
    return list(found.values())


def _defined(world: OpenWorld, query: str) -> Iterator[tuple[str, Mention]]:
    names = ProjectNames(world)
    for name in names.found[0]:
        script = names.script(name)
        uri = uri_in(world, name)
        if script is None or uri is None or not _fits(query, script.source.text.casefold()):
            continue
        for mention in script.all():
            if mention.defines in KINDS and _fits(query, mention.name.casefold()):
                yield uri, mention


def _fits(query: str, text: str) -> bool:
    """Whether the letters of a query stand in a text in this order."""
    at = 0
    for letter in query:
        at = text.find(letter, at) + 1
        if at == 0:
            return False
    return True


def _file(mention: Mention) -> str:
    return mention.span.source.name


def register(server: FaceServer) -> None:
    @server.feature(types.WORKSPACE_SYMBOL)
    def _(_: FaceServer, params: types.WorkspaceSymbolParams) -> list[types.WorkspaceSymbol]:
        return workspace_symbols(server.desk, params.query)
