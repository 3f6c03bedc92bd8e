"""An action to what calls it and to the actions that it calls."""

from __future__ import annotations

from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.names.asking import asked, location, symbol_at
from facescript.lsp.names.calling import Caller, called, caller_at, callers
from facescript.lsp.names.script import names_of
from facescript.lsp.names.symbols import ProjectNames
from facescript.lsp.places import offset, range_of
from facescript.lsp.server import FaceServer
from facescript.text import Span

Kind = types.SymbolKind
KINDS = {"action": Kind.Method, "scene": Kind.Module, "reaction": Kind.Event, "script": Kind.File}


def prepared(analysis: Analysis, place: types.Position) -> list[types.CallHierarchyItem]:
    """The action at a position."""
    at = symbol_at(analysis, place)
    if at is None or at[1].kind != "action":
        return []
    item = _at(analysis, at[0], at[1].span)
    return [item] if item is not None else []


def incoming(analysis: Analysis, item: types.CallHierarchyItem) -> list[types.CallHierarchyIncomingCall]:
    """Who calls the action of an item, which is defined in the document; where they do, in their own files."""
    at = symbol_at(analysis, item.selection_range.start)
    if at is None or at[1].kind != "action":
        return []
    found = callers(*at).items()
    calls = ((_item(analysis, caller), spans) for caller, spans in found)
    return [
        types.CallHierarchyIncomingCall(told, [range_of(span) for span in spans])
        for told, spans in calls
        if told is not None
    ]


def outgoing(analysis: Analysis, item: types.CallHierarchyItem) -> list[types.CallHierarchyOutgoingCall]:
    """The actions that an item of the document calls."""
    script = names_of(analysis.compiled.script)
    names = ProjectNames(analysis.world, analysis.compiled.script)
    start = offset(analysis.source, item.selection_range.start)
    caller = caller_at(script, start if item.kind != Kind.File else len(analysis.source.text))
    calls = ((_at(analysis, names, symbol.span), spans) for symbol, spans in called(names, script, caller).items())
    return [
        types.CallHierarchyOutgoingCall(told, [range_of(span) for span in spans])
        for told, spans in calls
        if told is not None
    ]


def _at(analysis: Analysis, names: ProjectNames, span: Span) -> types.CallHierarchyItem | None:
    """The item of the action whose name stands there."""
    script = names.script(span.source.name)
    return _item(analysis, caller_at(script, span.start)) if script is not None else None


def _item(analysis: Analysis, caller: Caller) -> types.CallHierarchyItem | None:
    spot = location(analysis, caller.span)
    if spot is None:
        return None
    file = caller.span.source.name
    return types.CallHierarchyItem(
        caller.name, KINDS[caller.kind], spot.uri, spot.range, range_of(caller.head), detail=file
    )


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY)
    def _(_: FaceServer, params: types.CallHierarchyPrepareParams) -> list[types.CallHierarchyItem]:
        analysis = asked(server.desk, params.text_document.uri)
        return prepared(analysis, params.position) if analysis is not None else []

    @server.feature(types.CALL_HIERARCHY_INCOMING_CALLS)
    def _(_: FaceServer, params: types.CallHierarchyIncomingCallsParams) -> list[types.CallHierarchyIncomingCall]:
        analysis = asked(server.desk, params.item.uri)
        return incoming(analysis, params.item) if analysis is not None else []

    @server.feature(types.CALL_HIERARCHY_OUTGOING_CALLS)
    def _(_: FaceServer, params: types.CallHierarchyOutgoingCallsParams) -> list[types.CallHierarchyOutgoingCall]:
        analysis = asked(server.desk, params.item.uri)
        return outgoing(analysis, params.item) if analysis is not None else []
