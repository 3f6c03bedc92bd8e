"""`check --fix`: all fixes are made, files stay whole, and what is left is said."""

from __future__ import annotations

import json
import re
import sys
from io import BytesIO, TextIOWrapper
from pathlib import Path

import pytest

from facescript.cli.main import main

MANUAL = Path(__file__).parents[2] / "docs" / "language.md"
FAULTY = "show smlie 40%\nwait 2\nlok at camera\nadd AU99\n"


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_all_fixes_are_made_and_the_rest_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    Path("x.face").write_text(FAULTY, "utf-8")
    assert main(["check", "--fix", "x.face"]) == 1
    assert Path("x.face").read_text("utf-8") == "show smile 40%\nwait 2s\nlook at camera\nadd AU99\n"
    told = capsys.readouterr().err
    assert "fixed x.face:1:6: FS201" in told and told.count("fixed ") == 3
    assert "error FS201" not in told and "AU99" in told


def test_a_fix_that_brings_out_another_fault_is_followed(capsys: pytest.CaptureFixture[str]) -> None:
    Path("x.face").write_text("lok at camra\n", "utf-8")
    assert main(["check", "--fix", "x.face"]) == 0
    assert Path("x.face").read_text("utf-8") == "look at camera\n"
    assert capsys.readouterr().err.count("fixed ") == 2


def test_json_says_what_is_left(capsys: pytest.CaptureFixture[str]) -> None:
    Path("x.face").write_text(FAULTY, "utf-8")
    assert main(["check", "--fix", "--json", "x.face"]) == 1
    assert [item["line"] for item in json.loads(capsys.readouterr().out)] == [4]


def test_standard_input_is_printed_mended(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "stdin", TextIOWrapper(BytesIO(b"show smlie\n")))
    assert main(["check", "--fix", "-"]) == 0
    assert capsys.readouterr().out == "show smile\n"


def test_links_line_ends_and_clean_files_stay_as_they_are() -> None:
    Path("real.face").write_bytes(b"\xef\xbb\xbfshow smlie\r\nwait 1s\r\n")
    Path("x.face").symlink_to("real.face")
    Path("clean.face").write_text("nod\n", "utf-8")
    before = Path("clean.face").stat().st_mtime_ns
    assert main(["check", "--fix", "x.face", "clean.face"]) == 0
    assert Path("x.face").is_symlink()
    assert Path("real.face").read_bytes() == b"\xef\xbb\xbfshow smile\r\nwait 1s\r\n"
    assert Path("clean.face").stat().st_mtime_ns == before
    assert {path.name for path in Path().iterdir()} == {"real.face", "x.face", "clean.face"}


def test_other_files_are_let_be() -> None:
    Path("other.face").write_text("expression wry = smlie\n", "utf-8")
    Path("x.face").write_text('use "other.face"\nshow wry\nwait 2\n', "utf-8")
    assert main(["check", "--fix", "x.face"]) == 1
    assert Path("other.face").read_text("utf-8") == "expression wry = smlie\n"
    assert Path("x.face").read_text("utf-8") == 'use "other.face"\nshow wry\nwait 2s\n'


def test_edits_of_a_fix_are_listed_from_the_last_place_to_the_first(capsys: pytest.CaptureFixture[str]) -> None:
    Path("x.face").write_text("show smile, over 2s\nshow smile over 1s for, 2s\nlook left,up\n“\n", "utf-8")
    main(["check", "--json", "x.face"])
    for item in json.loads(capsys.readouterr().out):
        for fix in item["fixes"]:
            places = [(edit["line"], edit["column"]) for edit in fix["edits"]]
            assert places == sorted(places, reverse=True)


def test_the_manual_shows_what_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    Path("x.face").write_text("wait 2\n", "utf-8")
    main(["check", "--json", "x.face"])
    (shown,) = re.findall(r"For `wait 2`:\n\n```json\n(.*?)```", MANUAL.read_text("utf-8"), re.DOTALL)
    assert json.loads(shown) == json.loads(capsys.readouterr().out)
