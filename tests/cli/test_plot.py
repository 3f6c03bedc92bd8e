"""`facescript plot` on the command line: where outputs go, and what is refused."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from facescript.cli.main import main

Captured = pytest.CaptureFixture[str]
SCRIPT = "face ada = woman\n    life still\nlook left 10deg\nnod\n"


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.face").write_text(SCRIPT, "utf-8")


def test_without_an_output_it_stands_beside_the_script(capsys: Captured) -> None:
    assert main(["plot", "a.face"]) == 0
    assert sorted(path.name for path in Path().iterdir()) == ["a.face", "a.plot.svg"]
    assert capsys.readouterr() == ("", "")


def test_two_outputs_of_one_plot() -> None:
    assert main(["plot", "a.face", "-o", "one.svg", "-o", "two.png", "--to", "500ms", "--size", "800x600"]) == 0
    assert 'width="800" height="600"' in Path("one.svg").read_text("utf-8")
    assert Path("two.png").read_bytes().startswith(b"\x89PNG")


def test_standard_output(capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    assert main(["plot", "a.face", "-o", "-", "--as", "svg"]) == 0
    assert capfdbinary.readouterr().out.startswith(b"<?xml")


@pytest.mark.parametrize(
    ("words", "code", "exit_code"),
    [
        (["--channels", "head.yew"], "FS920", 2),
        (["--channels", "head.yaw,,lid"], "FS904", 2),
        (["--size", "10x10"], "FS904", 2),
        (["--size", "500x100"], "FS921", 2),
        (["--from", "3s", "--to", "2s"], "FS906", 2),
        (["-o", "plot.pdf"], "FS902", 2),
        (["-o", "-"], "FS902", 2),
        (["-o", "missing/plot.svg"], "FS903", 1),
        (["-o", "fine.svg", "-o", "missing/plot.png"], "FS903", 1),
        (["--set", "beat=1s"], "FS232", 1),
    ],
)
def test_refused_and_nothing_written(words: list[str], code: str, exit_code: int, capsys: Captured) -> None:
    assert main(["plot", "a.face", *words]) == exit_code
    assert code in capsys.readouterr().err
    assert [path.name for path in Path().iterdir()] == ["a.face"]


def test_nothing_to_play(capsys: Captured) -> None:
    Path("b.face").write_text("let beat = 1s\n", "utf-8")
    assert main(["plot", "b.face"]) == 2
    assert "FS911" in capsys.readouterr().err


def test_size_of_the_plot_is_not_the_films() -> None:
    """Where a place in the picture is seen hangs on the film's shape; the plot's own shape changes nothing of it."""
    Path("b.face").write_text("film 640x480\ntarget chart at 45% 45%\nlook at chart\nwait 1s\n", "utf-8")
    for name, size in (("one.svg", "800x400"), ("two.svg", "3200x400")):
        assert main(["plot", "b.face", "-o", name, "--size", size, "--channels", "gaze.yaw"]) == 0
    one, two = (
        re.findall('text-anchor="end".*?>(.*?)<', Path(name).read_text("utf-8")) for name in ("one.svg", "two.svg")
    )
    assert one == two and "10" in one


def test_letters_the_picture_lacks_are_told(capsys: Captured) -> None:
    Path("c.face").write_text("target süd at 20deg 0deg 2m\nlook at süd\nwait 1s\n", "utf-8")
    assert main(["plot", "c.face", "-o", "c.png"]) == 0
    assert "FS924" in (told := capsys.readouterr().err) and "“ü”" in told
    assert main(["plot", "c.face", "-o", "c.svg"]) == 0
    assert "FS924" not in capsys.readouterr().err
