"""What the desk knows of documents: as their files compile, whatever was edited before and wherever."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types
from pygls.workspace import Workspace

from facescript.compile import compile_source
from facescript.lsp.desk import Desk
from facescript.speech.voices.known import KnownTimes
from facescript.text import Source
from facescript.world import World

USED = "expression wry = smile 40% + AU4 10%\n"
TEXTS = (
    'use "used.face"\nnod\nshow wry 80%\n',
    'use "used.face"\nnod\nblink\nshow wry 80%\n',
    'use "used.face"\nnod 30%\nblink as b\nat c.end: show wri 80%\n',
    'use "used.face"\nat b.end: show wry 80%\nblink as b\n',
)


def test_an_edited_document_is_told_as_its_file_is(tmp_path: Path) -> None:
    (tmp_path / "used.face").write_text(USED, "utf-8")
    uri, world = (tmp_path / "a.face").as_uri(), World(tmp_path)
    workspace = Workspace(None, workspace_folders=[types.WorkspaceFolder(tmp_path.as_uri(), "project")])
    workspace.put_text_document(types.TextDocumentItem(uri, "face", 0, ""))
    desk = Desk(workspace)
    for version, text in enumerate((*TEXTS, *reversed(TEXTS)), 1):
        change = types.TextDocumentContentChangeWholeDocument(text)
        workspace.update_text_document(types.VersionedTextDocumentIdentifier(version, uri), change)
        found = desk.analysis(uri).compiled
        fresh = compile_source(Source("a.face", text), world, KnownTimes(world))
        told, meant = ([(item.code, item.span and (item.span.start, item.span.end)) for item in one.diagnostics]
                       for one in (found, fresh))  # fmt: skip
        assert told == meant
        assert (found.score is None) == (fresh.score is None)
        assert [item.span.text for item in found.script.items] == [item.span.text for item in fresh.script.items]
