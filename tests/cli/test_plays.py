"""Plays in JSON on the command line: built, explained and checked as scripts are; written as scripts by `fmt`."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from io import BytesIO, TextIOWrapper
from pathlib import Path
from typing import Any

import pytest

from facescript.cli.main import main

SCRIPT = """face ada = woman, voice en-us female
    life still
target cup at 10cm -12cm 20cm

show smile 40% as warm
look at cup
wait 500ms
"""


@pytest.fixture
def play(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """The play of `SCRIPT` as a build writes it, in the folder in which the test works."""
    monkeypatch.chdir(tmp_path)
    Path("x.face").write_text(SCRIPT, "utf-8")
    assert main(["build", "x.face", "-o", "x.json", "--quiet"]) == 0
    found: dict[str, Any] = json.loads(Path("x.json").read_text("utf-8"))
    return found


def put(form: dict[str, Any]) -> None:
    Path("x.json").write_text(json.dumps(form, indent=1), "utf-8")


def verbs(form: dict[str, Any]) -> list[dict[str, Any]]:
    return [item["verb"] for item in form["play"]["scenes"][0]["body"]["items"]]


def without_places(value: Any) -> Any:
    if isinstance(value, list):
        return [without_places(item) for item in value]
    if isinstance(value, dict):
        return {name: without_places(item) for name, item in value.items() if name != "span"}
    return value


@pytest.mark.usefixtures("play")
def test_a_play_is_built_as_its_script(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", "x.face", "-o", "a.csv", "-o", "a.json", "--quiet"]) == 0
    assert main(["build", "x.json", "-o", "b.csv", "-o", "b.json", "--quiet"]) == 0
    assert Path("a.csv").read_bytes() == Path("b.csv").read_bytes()
    assert Path("a.json").read_bytes() == Path("b.json").read_bytes()
    assert capsys.readouterr().err == ""


@pytest.mark.usefixtures("play")
def test_a_play_is_explained_with_the_lines_of_its_script(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "x.json"]) == 0
    assert "x.face:5" in capsys.readouterr().out


def test_back_to_a_script_and_again_a_play(play: dict[str, Any]) -> None:
    assert main(["fmt", "x.json", "-o", "y.face"]) == 0
    assert main(["build", "y.face", "-o", "y.json", "--quiet"]) == 0
    again = json.loads(Path("y.json").read_text("utf-8"))
    assert without_places(again["play"]) == without_places(play["play"])


def test_a_fault_of_the_schedule_is_told_at_the_line_of_the_script(
    play: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    verbs(play)[0]["timing"] |= {"over": 2.0, "lasting": 1.0}
    put(play)
    assert main(["check", "x.json"]) == 0
    told = capsys.readouterr().err
    assert "FS424" in told and "x.face:5:1" in told and "show smile 40% as warm" in told


def test_what_has_no_place_is_told_where_it_is_in_the_json(
    play: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    verbs(play)[1]["aim"]["name"] = "cop"
    put(without_places(play))
    assert main(["check", "--json", "x.json"]) == 1
    (fault,) = json.loads(capsys.readouterr().out)
    assert (fault["code"], fault["file"], fault["fixes"]) == ("FS202", "x.json", [])
    first = Path("x.json").read_text("utf-8").splitlines()[fault["line"] - 1 : fault["end_line"]]
    assert any('"cop"' in line for line in first) and not any('"Show"' in line for line in first)


def change(path: str, value: object) -> Callable[[dict[str, Any]], None]:
    def made(form: dict[str, Any]) -> None:
        *steps, last = [int(step) if step.isdigit() else step for step in path.split("/")]
        for step in steps:
            form = form[step]  # type: ignore[index]
        form[last] = value  # type: ignore[index]

    return made


BODY = "play/scenes/0/body/items"
SPAN = {"file": "x.face", "line": 1, "column": 1, "end_line": 1, "end_column": 2}


@pytest.mark.parametrize(
    ("made", "code"),
    [
        (change("play/film/width", 9_000_000), "FS304"),
        (change("play/faces/0/kind", "wolf"), "FS329"),
        (change("play/faces/0/name", "../x"), "FS1"),
        (change("play/faces/0/life/knobs", []), "FS962"),
        (change("play/faces/0/voice/variant", 'x"; rm'), "FS"),
        (change(f"{BODY}/0/verb/timing/ease", "bouncy"), "FS329"),
        (change(f"{BODY}/0/verb/mix/terms/0/drivers/0/name", "nose.tip"), "FS201"),
        (change(f"{BODY}/0/span", {**SPAN, "end_line": 1_000_000, "file": "far"}), None),
        (change(f"{BODY}/0/span", {**SPAN, "line": 2}), "FS961"),
        (change(f"{BODY}/1/verb/aim", {"type": "AtPerson", "name": "guest"}), "FS202"),
        (change(f"{BODY}/2/verb", {"type": "SetPicture", "picture": "/etc/passwd"}), "FS7"),
        (change(f"{BODY}/2/verb", {"type": "SetPicture", "picture": "../../etc/passwd"}), "FS7"),
        (change(f"{BODY}/2/verb", {"type": "SetPicture", "picture": ""}), "FS7"),
        (change("play/targets/0", {"type": "MovingTarget", "name": "cup", "times": [], "places": []}), "FS332"),
        (change(f"{BODY}/2/verb/duration", 1e300), "FS115"),
        (change(f"{BODY}/2/face", "nobody"), "FS"),
        (change("version", 2), "FS961"),
    ],
)
def test_what_no_script_says_is_refused(
    made: Callable[[dict[str, Any]], None], code: str | None, play: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    made(play)
    put(play)
    assert (main(["check", "x.json"]) != 0) == (code is not None)
    assert (code or "") in capsys.readouterr().err


@pytest.mark.usefixtures("play")
def test_a_play_from_standard_input(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "stdin", TextIOWrapper(BytesIO(Path("x.json").read_bytes())))
    assert main(["fmt", "-", "-o", "-"]) == 0
    assert "show smile 40% as warm" in capsys.readouterr().out


@pytest.mark.usefixtures("play")
def test_fmt_never_writes_over_a_play() -> None:
    before = Path("x.json").read_bytes()
    assert main(["fmt", "x.json"]) == 2
    assert main(["fmt", "--check", "x.json"]) == 2
    assert Path("x.json").read_bytes() == before and sorted(os.listdir()) == ["x.face", "x.json"]


def test_fmt_writes_a_script_elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.face").write_text("show   smile", "utf-8")
    assert main(["fmt", "a.face", "-o", "b.face"]) == 0
    assert (Path("a.face").read_text("utf-8"), Path("b.face").read_text("utf-8")) == ("show   smile", "show smile\n")
