"""An editor that asks for diagnostics is not told them unasked as well: it would show each twice."""

from __future__ import annotations

import sys
from collections.abc import AsyncIterator
from pathlib import Path

import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

COMMAND = [sys.executable, "-m", "facescript.cli.main", "lsp"]


@pytest_lsp.fixture(config=ClientServerConfig(server_command=COMMAND))
async def asking(lsp_client: LanguageClient, tmp_path: Path) -> AsyncIterator[None]:
    capabilities = client_capabilities("visual-studio-code")
    assert capabilities.text_document is not None
    capabilities.text_document.diagnostic = types.DiagnosticClientCapabilities()
    folder = types.WorkspaceFolder(tmp_path.as_uri(), "project")
    await lsp_client.initialize_session(types.InitializeParams(capabilities, workspace_folders=[folder]))
    yield
    await lsp_client.shutdown_session()


async def test_diagnostics_are_given_when_asked_and_not_pushed(asking: LanguageClient, tmp_path: Path) -> None:
    uri = (tmp_path / "a.face").as_uri()
    item = types.TextDocumentItem(uri, "face", 1, "show smlie\n")
    asking.text_document_did_open(types.DidOpenTextDocumentParams(item))
    params = types.DocumentDiagnosticParams(types.TextDocumentIdentifier(uri))
    for _ in range(2):  # the second answer comes after whatever was due at the opening
        report = await asking.text_document_diagnostic_async(params)
        assert isinstance(report, types.RelatedFullDocumentDiagnosticReport)
        assert [found.code for found in report.items] == ["FS201"]
    assert uri not in asking.diagnostics
