"""The server's preview, with a page that drags and clicks: the editor is asked for edits, and shown what is meant."""

from __future__ import annotations

import asyncio
import json
import os
import signal
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types
from pytest_lsp import LanguageClient
from websockets.asyncio.client import ClientConnection, connect

TEXT = 'say "\U0001f600 Hello."  # first\nwait 500ms\nnod\n'


def opened(client: LanguageClient, folder: Path) -> str:
    path = folder / "a.face"
    path.write_text(TEXT, "utf-8")
    uri = path.as_uri()
    client.text_document_did_open(types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "face", 3, TEXT)))
    return uri


async def command(client: LanguageClient, *arguments: Any) -> Any:
    asked = types.ExecuteCommandParams("facescript.preview", list(arguments))
    return await client.workspace_execute_command_async(asked)


@asynccontextmanager
async def page(address: str) -> AsyncIterator[ClientConnection]:
    live = address.replace("http", "ws") + "live"
    async with connect(live, max_size=None) as connection:
        yield connection


async def told(connection: ClientConnection, kind: str, **values: object) -> dict[str, Any]:
    """The next message of a kind with such values."""
    async with asyncio.timeout(60):
        while True:
            said = await connection.recv()
            message = json.loads(said) if isinstance(said, str) else {}
            if message.get("kind") == kind and all(message[name] == value for name, value in values.items()):
                return message


async def eventually(holds: Any) -> None:
    async with asyncio.timeout(60):
        while not holds():
            await asyncio.sleep(0.02)


@pytest.mark.skipif(not Path("/proc/self/cwd").exists(), reason="looks for processes where Linux lists them")
@pytest.mark.asyncio
async def test_a_page_and_an_editor_share_a_script(client: LanguageClient, tmp_path: Path) -> None:
    edits: list[types.ApplyWorkspaceEditParams] = []

    @client.feature(types.WORKSPACE_APPLY_EDIT)
    def _(params: types.ApplyWorkspaceEditParams) -> types.ApplyWorkspaceEditResult:
        edits.append(params)
        return types.ApplyWorkspaceEditResult(applied=True)

    uri = opened(client, tmp_path)
    address = await command(client, uri, 0.5, False)
    assert not client.shown_documents and await command(client, uri) == address
    assert [(shown.uri, shown.external) for shown in client.shown_documents] == [(address, True)]
    async with page(address) as wire:
        score = await told(wire, "score")
        (nod,) = (number for number, act in enumerate(score["acts"]) if act["label"] == "nod")

        def drag(version: int, by: float, done: bool) -> str:
            values = {"version": version, "id": nod, "handle": "body", "by": by, "degree": None, "done": done}
            return json.dumps({"kind": "drag", **values})

        # a drag is an edit of the editor's own text
        await wire.send(drag(score["version"], 0.3, False))
        assert (await told(wire, "would"))["text"] == "800ms" and not edits
        await wire.send(drag(score["version"], 0.3, True))
        await eventually(lambda: edits)
        ((change,),) = ([each.edits for each in edits[0].edit.document_changes or ()],)  # type: ignore[union-attr]
        where = types.Range(types.Position(1, 5), types.Position(1, 10))
        assert [(edit.range, edit.new_text) for edit in change] == [(where, "800ms")]  # type: ignore[union-attr]
        assert edits[0].edit.document_changes[0].text_document.version == 3  # type: ignore[index,union-attr]

        # what the editor makes of it comes back, and what is edited since is not overwritten
        after = TEXT.replace("500ms", "800ms")
        document = types.VersionedTextDocumentIdentifier(4, uri)
        whole = types.TextDocumentContentChangeWholeDocument(after)
        client.text_document_did_change(types.DidChangeTextDocumentParams(document, [whole]))
        assert (await told(wire, "script"))["text"] == after
        await wire.send(drag(score["version"], 0.3, True))
        assert "changed since" in (await told(wire, "refused"))["why"]

        # who clicks an act sees its line, and who is in a line sees it lit
        await wire.send(json.dumps({"kind": "jump", "from": 8, "to": 13}))
        await eventually(lambda: len(client.shown_documents) > 1)
        shown = client.shown_documents[1]
        assert shown.uri == uri and shown.take_focus and not shown.external
        assert shown.selection == types.Range(types.Position(0, 8), types.Position(0, 13))
        place = {"textDocument": {"uri": uri}, "position": {"line": 2, "character": 1}}
        client.protocol.notify("facescript/caret", place)
        lit = await told(wire, "lit")
        start = len(after.partition("nod")[0]) + 1
        assert (lit["from"], lit["to"]) == (start, start + 3)
        client.protocol.notify("facescript/caret", {"nonsense": 1})

    # one that dies is told; what cannot be had says why
    (process,) = previews(tmp_path)
    os.kill(process, signal.SIGKILL)
    await eventually(lambda: client.messages)
    assert client.messages[0].message.startswith("The preview of a.face is gone: it ended with -9")
    assert await command(client, "file:///nowhere.face") is None
    assert client.messages[1].message == "nowhere.face cannot be previewed: the script has to be saved first."


def previews(folder: Path) -> list[int]:
    """The processes of previews of scripts in a folder."""
    found = []
    for path in Path("/proc").glob("[0-9]*"):
        try:
            words, here = (path / "cmdline").read_bytes().split(b"\0"), (path / "cwd").readlink()
        except OSError:
            continue
        if here == folder and b"--editor" in words:
            found.append(int(path.name))
    return found
