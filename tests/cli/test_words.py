"""What the command line says to those who do not know it yet."""

from __future__ import annotations

from pathlib import Path

import pytest

from facescript.cli.arguments import COMMANDS
from facescript.cli.arguments import LISTS as NAMES
from facescript.cli.list import LISTS
from facescript.cli.main import main

Captured = pytest.CaptureFixture[str]


def test_without_words_it_shows_all_commands(capsys: Captured) -> None:
    assert main([]) == 2
    told = capsys.readouterr()
    assert told.out == "" and all(command in told.err for command in COMMANDS)


@pytest.mark.parametrize("what", NAMES)
def test_every_list_has_names_and_what_they_mean(what: str, capsys: Captured) -> None:
    assert main(["list", what]) == 0
    rows = capsys.readouterr().out.splitlines()
    assert len(rows) == len(list(LISTS[what]())) >= 3
    assert what == "words" or all(len(row.split(maxsplit=1)) == 2 for row in rows)


def test_list_without_a_name_says_what_there_is(capsys: Captured) -> None:
    with pytest.raises(SystemExit):
        main(["list"])
    assert "WHAT" in capsys.readouterr().err


def test_standard_output_asks_for_its_kind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.face").write_text("nod\n", "utf-8")
    assert main(["build", "a.face", "-o", "-"]) == 2
    assert "`--as csv`" in capsys.readouterr().err


def test_starter_is_clean_and_in_the_layout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["new", "first"]) == 0
    assert "facescript build first.face -o first.mp4" in capsys.readouterr().err
    assert main(["check", "first.face"]) == 0 == main(["fmt", "--check", "first.face"])
    assert capsys.readouterr().err == ""


def test_diagnostics_stand_apart(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.face").write_text("wait 2\nnodd\n", "utf-8")
    assert main(["check", "a.face"]) == 1
    told = capsys.readouterr().err
    assert told.count("\n\n") == 1 and not told.endswith("\n\n")
