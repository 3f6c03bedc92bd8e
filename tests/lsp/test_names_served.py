"""What is asked of names, through a real client: definition, references, rename, calls and symbols."""

from __future__ import annotations

from pathlib import Path

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pytest_lsp import LanguageClient

STUDIO = "let beat = 400ms\naction bow:\n    nod\n    wait beat\n"
MAIN = '# \U0001f600\nuse "studio.face"\nlet long = 2s\naction greet:\n    bow\ngreet\nwait beat + long\n'
BEAT = types.Position(6, 6)


async def test_an_editor_is_served_over_files(client: LanguageClient, tmp_path: Path) -> None:
    studio, main = tmp_path / "studio.face", tmp_path / "main.face"
    studio.write_text(STUDIO, "utf-8")
    uri, other = main.as_uri(), studio.as_uri()
    item = types.TextDocumentItem(uri, "face", 7, MAIN)
    client.text_document_did_open(types.DidOpenTextDocumentParams(item))
    here = types.TextDocumentIdentifier(uri)
    await _led(client, here, other)
    await _renamed(client, here, other)
    await _called(client, other)
    nowhere = types.TextDocumentIdentifier((tmp_path / "gone.face").as_uri())
    assert await client.text_document_definition_async(types.DefinitionParams(nowhere, BEAT)) is None


async def _led(client: LanguageClient, here: types.TextDocumentIdentifier, other: str) -> None:
    spot = await client.text_document_definition_async(types.DefinitionParams(here, BEAT))
    assert isinstance(spot, types.Location) and spot.uri == other
    context = types.ReferenceContext(include_declaration=False)
    told = await client.text_document_references_async(types.ReferenceParams(context, here, BEAT))
    assert told is not None and sorted(one.uri for one in told) == [here.uri, other]
    lit = await client.text_document_document_highlight_async(types.DocumentHighlightParams(here, BEAT))
    assert lit is not None and [one.range.start.line for one in lit] == [6]


async def _renamed(client: LanguageClient, here: types.TextDocumentIdentifier, other: str) -> None:
    ready = await client.text_document_prepare_rename_async(types.PrepareRenameParams(here, BEAT))
    place = types.Range(types.Position(6, 5), types.Position(6, 9))
    assert ready == types.PrepareRenamePlaceholder(place, "beat")
    told = await client.text_document_rename_async(types.RenameParams(here, BEAT, "pulse"))
    assert told is not None and told.document_changes is not None
    files = [one.text_document for one in told.document_changes if isinstance(one, types.TextDocumentEdit)]
    assert {file.uri: file.version for file in files} == {other: None, here.uri: 7}
    with pytest.raises(JsonRpcException, match=r"a let already, in main\.face line 3"):
        await client.text_document_rename_async(types.RenameParams(here, BEAT, "long"))
    with pytest.raises(JsonRpcException, match="no name"):
        await client.text_document_prepare_rename_async(types.PrepareRenameParams(here, types.Position(0, 0)))


async def _called(client: LanguageClient, other: str) -> None:
    place = types.CallHierarchyPrepareParams(types.TextDocumentIdentifier(other), types.Position(1, 8))
    items = await client.text_document_prepare_call_hierarchy_async(place)
    assert items is not None
    calls = await client.call_hierarchy_incoming_calls_async(types.CallHierarchyIncomingCallsParams(items[0]))
    assert calls is not None and [call.from_.name for call in calls] == ["greet"]
    others = await client.call_hierarchy_outgoing_calls_async(types.CallHierarchyOutgoingCallsParams(calls[0].from_))
    assert others is not None and [call.to.name for call in others] == ["bow"]
    told = await client.workspace_symbol_async(types.WorkspaceSymbolParams("gr"))
    assert told is not None and [one.name for one in told] == ["greet"]
