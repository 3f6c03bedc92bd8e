"""A name and another one to the edits that rename it, in every file that means it; a clash is refused and told."""

from __future__ import annotations

from collections.abc import Sequence

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from facescript.lsp.desk import Analysis
from facescript.lsp.names.asking import asked, location, mention_at, symbol_at
from facescript.lsp.names.renaming import RenameRefused, check_renamed, renamed
from facescript.lsp.names.symbols import ProjectNames, Symbol
from facescript.lsp.places import range_of
from facescript.lsp.server import FaceServer


def prepared(analysis: Analysis, place: types.Position) -> types.PrepareRenamePlaceholder:
    """The name at a position, where it may be renamed. Raises `RenameRefused`."""
    names, symbol = _symbol(analysis, place)
    check_renamed(names, symbol)
    mention = mention_at(analysis, place)
    assert mention is not None
    return types.PrepareRenamePlaceholder(range_of(mention.span), symbol.name)


def edits(analysis: Analysis, place: types.Position, new: str) -> dict[str, list[types.TextEdit]]:
    """The edits by the addresses of the files. Raises `RenameRefused`."""
    names, symbol = _symbol(analysis, place)
    found: dict[str, list[types.TextEdit]] = {}
    for span in renamed(names, symbol, new):
        spot = location(analysis, span)
        if spot is not None:
            found.setdefault(spot.uri, []).append(types.TextEdit(spot.range, new))
    return found


def _symbol(analysis: Analysis, place: types.Position) -> tuple[ProjectNames, Symbol]:
    at = symbol_at(analysis, place)
    if at is None:
        raise RenameRefused("Here is no name that the script defines; words of the language stay as they are.")
    return at


def _changes(server: FaceServer, found: dict[str, list[types.TextEdit]]) -> types.WorkspaceEdit:
    """The edits in the form that the editor knows; with versions, so that none falls on a newer text."""
    workspace = server.client_capabilities.workspace
    known = workspace.workspace_edit if workspace is not None else None
    if known is None or not known.document_changes:
        return types.WorkspaceEdit(changes={uri: list(items) for uri, items in found.items()})
    changes = []
    for uri, items in found.items():
        document = server.workspace.text_documents.get(uri)
        version = document.version if document is not None else None
        several: Sequence[types.TextEdit] = items
        identifier = types.OptionalVersionedTextDocumentIdentifier(uri, version)
        changes.append(types.TextDocumentEdit(identifier, list(several)))
    return types.WorkspaceEdit(document_changes=changes)


def _refused(reason: RenameRefused) -> JsonRpcException:
    return JsonRpcException(reason.args[0], types.LSPErrorCodes.RequestFailed)


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    def _(_: FaceServer, params: types.PrepareRenameParams) -> types.PrepareRenamePlaceholder | None:
        analysis = asked(server.desk, params.text_document.uri)
        try:
            return prepared(analysis, params.position) if analysis is not None else None
        except RenameRefused as reason:
            raise _refused(reason) from None

    @server.feature(types.TEXT_DOCUMENT_RENAME)
    def _(_: FaceServer, params: types.RenameParams) -> types.WorkspaceEdit | None:
        analysis = asked(server.desk, params.text_document.uri)
        try:
            found = edits(analysis, params.position, params.new_name) if analysis is not None else {}
            return _changes(server, found)
        except RenameRefused as reason:
            raise _refused(reason) from None
