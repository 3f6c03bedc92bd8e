"""The files and addresses that a document leads to."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types
from pygls.workspace import Workspace

from facescript.lsp.desk import Desk
from facescript.lsp.features.links import links

SCRIPT = """\
use "parts/studio.face"
use "missing.face"
use "../outside.face"
target walker from "track.csv"
say "track.csv" from "take.wav" timed "take.srt" as t
repeat trial in "track.csv":
    background "sky.png"
play "track.csv"
link "https://example.org/" "there"
link "command:run" "no"
"""


def test_paths_that_lead_to_files_of_the_project_are_links(tmp_path: Path) -> None:
    root = tmp_path / "project"
    (root / "parts").mkdir(parents=True)
    (tmp_path / "outside.face").write_text("")
    for name in ("parts/studio.face", "track.csv", "take.wav"):
        (root / name).write_text("")
    workspace = Workspace(root.as_uri())
    for name, text in (("main.face", SCRIPT), ("sky.png", "")):
        workspace.put_text_document(types.TextDocumentItem((root / name).as_uri(), "face", 1, text))
    found = links(Desk(workspace).analysis((root / "main.face").as_uri()))
    assert [(link.range.start.line, link.target) for link in found] == [
        (0, (root / "parts/studio.face").as_uri()),
        (3, (root / "track.csv").as_uri()),
        (4, (root / "take.wav").as_uri()),
        (5, (root / "track.csv").as_uri()),
        (6, (root / "sky.png").as_uri()),
        (7, (root / "track.csv").as_uri()),
        (8, "https://example.org/"),
    ]
    assert found[0].range.start.character == len('use "')
