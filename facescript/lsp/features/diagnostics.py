"""A document to what is wrong with it, pushed after each edit and given when asked."""

from __future__ import annotations

import asyncio

from lsprotocol import types

from facescript.diagnostics.model import Diagnostic, Severity
from facescript.lsp.desk import Analysis
from facescript.lsp.places import range_of
from facescript.lsp.server import FaceServer

PAUSE = 0.12
"""Seconds without an edit after which diagnostics are made."""

SEVERITIES = {
    Severity.ERROR: types.DiagnosticSeverity.Error,
    Severity.WARNING: types.DiagnosticSeverity.Warning,
    Severity.HINT: types.DiagnosticSeverity.Hint,
}


def diagnostics(analysis: Analysis) -> list[types.Diagnostic]:
    """What the compiler says of the document itself; what lies in a file that it uses is told there."""
    return [
        _told(item, analysis)
        for item in analysis.compiled.diagnostics
        if item.span is None or item.span.source is analysis.source
    ]


def _told(item: Diagnostic, analysis: Analysis) -> types.Diagnostic:
    nowhere = types.Range(types.Position(0, 0), types.Position(0, 0))
    related = [
        types.DiagnosticRelatedInformation(types.Location(uri, range_of(other.span)), other.message)
        for other in item.related
        if (uri := analysis.uri_of(other.span.source))
    ]
    return types.Diagnostic(
        range_of(item.span) if item.span else nowhere,
        item.message,
        severity=SEVERITIES[item.severity],
        code=item.code,
        source="facescript",
        related_information=related or None,
    )


def pulls(server: FaceServer) -> bool:
    """Whether the editor asks for diagnostics by itself."""
    document = server.client_capabilities.text_document
    return document is not None and document.diagnostic is not None


def register(server: FaceServer) -> None:
    waiting: dict[str, asyncio.TimerHandle] = {}

    def push(uri: str) -> None:
        waiting.pop(uri, None)
        if uri in server.workspace.text_documents:
            found = server.desk.analysis(uri)
            server.text_document_publish_diagnostics(
                types.PublishDiagnosticsParams(uri, diagnostics(found), found.version)
            )

    def later(pause: float) -> None:
        """An edit may change what is said of every open document that uses it. Who asks is not told twice."""
        if pulls(server):
            return
        for uri in server.workspace.text_documents:
            if uri in waiting:
                waiting.pop(uri).cancel()
            waiting[uri] = asyncio.get_running_loop().call_later(pause, push, uri)

    def follow(uri: str) -> None:
        for follower in server.followers:
            follower(uri)

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(_: FaceServer, params: types.DidOpenTextDocumentParams) -> None:
        later(0.0)
        follow(params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(_: FaceServer, params: types.DidChangeTextDocumentParams) -> None:
        later(PAUSE)
        follow(params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(_: FaceServer, params: types.DidCloseTextDocumentParams) -> None:
        uri = params.text_document.uri
        if not pulls(server):
            server.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, []))
        later(0.0)

    @server.feature(types.TEXT_DOCUMENT_DIAGNOSTIC)
    def asked(_: FaceServer, params: types.DocumentDiagnosticParams) -> types.RelatedFullDocumentDiagnosticReport:
        found = server.desk.analysis(params.text_document.uri)
        return types.RelatedFullDocumentDiagnosticReport(items=diagnostics(found))
