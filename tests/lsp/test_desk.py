"""What the desk knows of documents: as their files compile, whatever was edited before and wherever."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from lsprotocol import types
from pygls.workspace import Workspace

from facescript.cli.main import main
from facescript.compile import compile_source
from facescript.lsp.desk import Desk
from facescript.speech.estimate import EstimatedVoice
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


def test_a_line_has_its_own_times_once_it_was_spoken(tmp_path: Path) -> None:
    """What is kept of an edited document's times does not outlive the guesses that they rest on."""
    script = 'scene one:\n    nod\nscene two:\n    say "Good evening, number seven."\n'
    uri, desk, change = edited(tmp_path, script)
    first = desk.analysis(uri).compiled.score
    assert first is not None and first.lines[0].spoken.estimated
    assert main(["build", str(tmp_path / "a.face"), "-o", str(tmp_path / "a.wav"), "--quiet"]) == 0
    change(script.replace("nod", "nod 50%"))
    again = desk.analysis(uri).compiled.score
    assert again is not None and not again.lines[0].spoken.estimated
    assert again.lines[0].spoken.duration != first.lines[0].spoken.duration


def test_an_edit_asks_for_the_times_of_no_other_scene(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    scenes = "scene one:\n    say 'Once.'\nscene two:\n    say 'Twice.'\n".replace("'", '"')
    uri, desk, change = edited(tmp_path, scenes)
    assert desk.analysis(uri).compiled.score is not None
    asked: list[str] = []
    speak = EstimatedVoice.speak
    monkeypatch.setattr(EstimatedVoice, "speak", lambda self, line: asked.append(line.text) or speak(self, line))
    change(scenes.replace("Twice.", "Twice, and again."))
    assert desk.analysis(uri).compiled.score is not None
    assert set(asked) == {"Twice, and again."}


def edited(folder: Path, text: str) -> tuple[str, Desk, Callable[[str], None]]:
    """A document that is a file too, its desk, and what puts another text into it."""
    (folder / "a.face").write_text(text, "utf-8")
    uri = (folder / "a.face").as_uri()
    workspace = Workspace(None, workspace_folders=[types.WorkspaceFolder(folder.as_uri(), "project")])
    workspace.put_text_document(types.TextDocumentItem(uri, "face", 0, text))

    def change(text: str) -> None:
        whole = types.TextDocumentContentChangeWholeDocument(text)
        workspace.update_text_document(types.VersionedTextDocumentIdentifier(1, uri), whole)

    return uri, Desk(workspace), change
