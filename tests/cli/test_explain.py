"""`explain --channel --at` on the command line: what it prints, and what it refuses."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from facescript.cli.main import main

Captured = pytest.CaptureFixture[str]

SCRIPT = """face ada = woman
    life still
face bruno = man
    life still
face voice = unseen
ada: show smile 60%
bruno: look left 30deg
"""


@pytest.fixture(autouse=True)
def script(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.face").write_text(SCRIPT, "utf-8")


def test_each_channel_is_told_at_each_moment(capsys: Captured) -> None:
    words = ["--channel", "ada.cheek.lower.left", "--channel", "bruno.head.yaw", "--at", "0s", "--at", "500ms"]
    assert main(["explain", "a.face", *words]) == 0
    blocks = capsys.readouterr().out.strip().split("\n\n")
    assert [block.splitlines()[0].rpartition(":")[0] for block in blocks] == [
        "ada.cheek.lower.left at 0 s",
        "ada.cheek.lower.left at 0.5 s",
        "bruno.head.yaw at 0 s",
        "bruno.head.yaw at 0.5 s",
    ]
    assert "owner: show smile 60% (a.face:6)" in blocks[1]


def test_the_face_may_be_said_apart(capsys: Captured) -> None:
    assert main(["explain", "a.face", "--channel", "lid.left", "--face", "bruno", "--at", "0s", "--json"]) == 0
    (told,) = json.loads(capsys.readouterr().out)
    assert (told["face"], told["channel"], told["time"], told["owner"]) == ("bruno", "lid.left", 0.0, None)


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["--channel", "lid.left", "--at", "0s"], "FS913", "`lid.left` needs a face's name in front"),
        (["--channel", "lid.left", "--face", "voice", "--at", "0s"], "FS913", "there is `ada`, `bruno`"),
        (["--channel", "ada.lid.lef", "--at", "0s"], "FS914", "did you mean `lid.left`?"),
        (["--channel", "ada.blushing", "--at", "0s"], "FS914", "`facescript list channels` has them"),
        (["--channel", "ada.ear.left", "--at", "0s"], "FS914", "only these kinds of face have it: `dog`, `rodent`."),
        (["--channel", "ada.hair.slow.x", "--at", "0s"], "FS914", "`facescript list channels` has them"),
        (["--channel", "ada.lid.left", "--at", "90s"], "FS906", "`--at 90s` lies outside the film"),
        (["--channel", "ada.lid.left", "--at", "soon"], "FS904", "write for example `--at 2s`"),
        (["--channel", "ada.lid.left"], "FS912", "`--channel` needs `--at` beside it"),
        (["--at", "1s"], "FS912", "`--at` needs `--channel` beside it"),
        (["--face", "ada"], "FS912", "`--face` needs `--channel` beside it"),
    ],
)
def test_what_cannot_be_told_is_said(words: list[str], code: str, said: str, capsys: Captured) -> None:
    assert main(["explain", "a.face", *words]) == 2
    told = capsys.readouterr()
    assert told.out == "" and code in told.err and said in told.err
