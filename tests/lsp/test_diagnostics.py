"""What is wrong with a document, as an editor is told: after each edit, and when it asks."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types
from pytest_lsp import LanguageClient


def opened(client: LanguageClient, path: Path, text: str) -> str:
    item = types.TextDocumentItem(path.as_uri(), "face", 1, text)
    client.text_document_did_open(types.DidOpenTextDocumentParams(item))
    return path.as_uri()


async def test_a_fault_is_told_where_it_is_and_goes_when_it_is_mended(client: LanguageClient, tmp_path: Path) -> None:
    uri = opened(client, tmp_path / "a.face", "show smlie 60%  # \U0001f600\n")
    await client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    (told,) = client.diagnostics[uri]
    assert (told.code, told.source) == ("FS201", "facescript") and "smile" in told.message
    assert told.range == types.Range(types.Position(0, 5), types.Position(0, 10))
    change = types.TextDocumentContentChangePartial(told.range, "smile")
    identifier = types.VersionedTextDocumentIdentifier(2, uri)
    client.text_document_did_change(types.DidChangeTextDocumentParams(identifier, [change]))
    await client.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    assert not client.diagnostics[uri]
    report = await client.text_document_diagnostic_async(
        types.DocumentDiagnosticParams(types.TextDocumentIdentifier(uri))
    )
    assert not report.items
