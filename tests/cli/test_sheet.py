"""`facescript sheet` on the command line: kinds and scripts, where sheets go, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

from facescript.cli.main import main

Captured = pytest.CaptureFixture[str]
SCRIPT = "face ada = woman, hair #e0b35c\nface bruno = man\nexpression wry = smile.left 60%\nada: show wry\n"


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.face").write_text(SCRIPT, "utf-8")


def told(path: str) -> list[str]:
    return [str(each.text) for each in etree.parse(path).getroot().iter("{*}title")][1:]


def test_without_an_output_it_stands_beside_the_script(capsys: Captured) -> None:
    assert main(["sheet", "a.face", "--face", "ada", "--cell", "64"]) == 0
    assert sorted(path.name for path in Path().iterdir()) == ["a.face", "a.sheet.png"]
    assert capsys.readouterr() == ("", "")


def test_a_kind_and_all_its_outputs() -> None:
    assert main(["sheet", "man", "--cell", "64", "-o", "m.svg", "-o", "m.html", "-o", "m.png"]) == 0
    assert Path("m.png").read_bytes().startswith(b"\x89PNG") and "<svg" in Path("m.html").read_text("utf-8")
    assert "somebody: sadness" in told("m.svg")


def test_faces_of_a_script_in_its_expressions() -> None:
    assert main(["sheet", "a.face", "-o", "a.svg"]) == 0
    assert {"ada: wry", "bruno: wry"} <= set(told("a.svg"))
    assert main(["sheet", "a.face", "--face", "bruno", "--units", "-o", "b.svg"]) == 0
    assert {title.partition(":")[0] for title in told("b.svg")} == {"bruno"} and "bruno: AU12" in told("b.svg")


def test_standard_output(capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    assert main(["sheet", "woman", "-o", "-", "--as", "svg"]) == 0
    assert capfdbinary.readouterr().out.startswith(b"<?xml")


@pytest.mark.parametrize(
    ("words", "code", "exit_code"),
    [
        (["womam"], "FS930", 2),
        (["unseen"], "FS930", 2),
        (["missing.face"], "FS901", 1),
        (["a.face", "--face", "cleo"], "FS931", 2),
        (["a.face", "--cell", "5"], "FS934", 2),
        (["a.face", "--cell", "big"], "FS904", 2),
        (["a.face", "-o", "sheet.pdf"], "FS902", 2),
        (["a.face", "-o", "-"], "FS902", 2),
        (["woman", "-o", "missing/sheet.svg"], "FS903", 1),
        (["woman", "--cell", "64", "-o", "fine.png", "-o", "missing/sheet.svg"], "FS903", 1),
    ],
)
def test_refused_and_nothing_written(words: list[str], code: str, exit_code: int, capsys: Captured) -> None:
    assert main(["sheet", *words]) == exit_code
    assert code in capsys.readouterr().err
    assert [path.name for path in Path().iterdir()] == ["a.face"]


def test_faults_of_the_script_are_told(capsys: Captured) -> None:
    Path("b.face").write_text("face ada = woman\nshow smle\n", "utf-8")
    assert main(["sheet", "b.face"]) == 1
    assert "FS201" in capsys.readouterr().err and not Path("b.sheet.png").exists()


def test_what_needs_a_value_is_left_out_and_told(capsys: Captured) -> None:
    Path("b.face").write_text("face ada = woman\nexpression wry(much) = smile much\nshow wry(50%)\n", "utf-8")
    assert main(["sheet", "b.face", "--cell", "64"]) == 0
    assert "FS935" in capsys.readouterr().err and Path("b.sheet.png").exists()
