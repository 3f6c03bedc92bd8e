"""`facescript live` on the command line: a run and its log, what it writes, what it refuses, and how it ends."""

from __future__ import annotations

import csv
import json
import os
import re
import signal
import subprocess
import sys
from math import inf
from pathlib import Path
from urllib.request import urlopen

import pytest

from facescript.cli.arguments import parser
from facescript.cli.live import Orders
from facescript.cli.main import main
from facescript.compile import Settings
from facescript.live.log import Head, Recorded

Captured = pytest.CaptureFixture[str]

SCRIPT = """\
film 320x240, seed 3

let degree = 60%

face mia = woman
    life calm

scene wait:
    repeat forever:
        look left 10deg as aside
        wait 200ms
        look camera
        wait 200ms

when heard "no":
    show frown degree over 200ms as frowned
when person arrives as guest:
    look at guest
"""


@pytest.fixture(autouse=True)
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("FACESCRIPT_TOKEN", raising=False)
    Path("kiosk.face").write_text(SCRIPT.replace("look camera", "look at camera"), "utf-8")


def says(monkeypatch: pytest.MonkeyPatch, *lines: str) -> None:
    """What stands on standard input."""
    ends = os.pipe()
    os.write(ends[1], "".join(f"{line}\n" for line in lines).encode())
    os.close(ends[1])
    monkeypatch.setattr(sys, "stdin", os.fdopen(ends[0]))


def rows_of(name: str) -> list[dict[str, str]]:
    return list(csv.DictReader(Path(name).read_text("utf-8").splitlines()))


def test_a_run_is_had_again_by_its_log(monkeypatch: pytest.MonkeyPatch, capsys: Captured) -> None:
    said = ("arrives ann 30cm 0cm 80cm", 'heard "no" at 0.3s', "sighting ann 40cm 0cm 80cm", "key q", "what?")
    says(monkeypatch, *said)
    with Path("kiosk.face").open("a", encoding="utf-8") as script:
        script.write('event heard "no" at 0s\n')
    words = ["live", "kiosk.face", "--set", "degree=80%", "--seed", "11", "--fps", "50"]
    assert main([*words, "--from", "stdin:", "--log", "run.log", "--to", "csv:run.csv", "--for", "0.8"]) == 0
    told = capsys.readouterr().err
    assert "A line of standard input is refused" in told and 'key "q"' in told
    assert re.search(r"^events: .*\b2 taken", told, re.MULTILINE) and "at 50 a second" in told
    assert main(["live", "kiosk.face", "--replay", "run.log", "--to", "csv:again.csv", "--log", "again.log"]) == 0
    assert Path("again.csv").read_bytes() == Path("run.csv").read_bytes()
    first, again = (Path(name).read_text("utf-8").splitlines() for name in ("run.log", "again.log"))
    assert first[1:] == again[1:] and len(first) >= 5
    head = json.loads(first[0])
    assert (head["seed"], head["fps"], head["set"]) == (11, 50.0, {"degree": "80%"})
    rows = rows_of("run.csv")
    assert float(rows[-1]["brow.lower.left"]) > 0.5 > 0.01 > float(rows[0]["brow.lower.left"])
    assert main(["build", "kiosk.face", "--events", "run.log", "--fps", "50", "-o", "film.csv", "--quiet"]) == 0
    film = {row["time"]: row for row in rows_of("film.csv")}
    assert abs(len(film) - 40) <= 1
    for row in rows:
        if row["time"] in film:
            found = float(film[row["time"]]["brow.lower.left"])
            assert float(row["brow.lower.left"]) == pytest.approx(found, abs=2e-4)


def test_a_log_of_another_script_is_refused(capsys: Captured) -> None:
    Path("mine.face").write_text("expression wry = smile.left 60%\n", "utf-8")
    Path("uses.face").write_text('use "mine.face"\nshow wry\n', "utf-8")
    assert main(["live", "uses.face", "--log", "run.log", "--to", "csv:run.csv", "--for", "0.05"]) == 0
    log = Path("run.log").read_text("utf-8")
    Path("mine.face").write_text("expression wry = smile.left 70%\n", "utf-8")
    assert main(["live", "uses.face", "--replay", "run.log"]) == 2
    assert "FS974" in capsys.readouterr().err
    Path("run.log").write_text(log.splitlines()[0] + '\n{"frame": 1, "time": 0.01, "told": "nod"}\n', "utf-8")
    assert main(["build", "uses.face", "--events", "run.log", "-o", "film.csv"]) == 2
    assert "FS973" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "hasty"),
    [
        ([], True),
        (["--to", "csv:again.csv", "--to", "-"], True),
        (["--page"], False),
        (["--to", "csv:again.csv", "--page"], False),
        (["--to", "csv:again.csv", "--to", "ws://127.0.0.1:8765"], False),
    ],
)
def test_a_replay_that_somebody_watches_takes_its_time(words: list[str], hasty: bool) -> None:
    options = parser("1").parse_args(["live", "kiosk.face", "--replay", "run.log", *words])
    recorded = Recorded(Path("run.log"), Head("kiosk.face", "", 1, 60.0, "1"), 60)
    assert Orders(options, 60.0, inf, "", Settings(), recorded).hasty is hasty


def test_onsets_are_the_plan_and_what_became_of_it() -> None:
    words = ["live", "kiosk.face", "--to", "csv:run.csv", "--for", "0.5s", "--onsets", "onsets.csv"]
    assert main(words) == 0
    rows = rows_of("onsets.csv")
    aside = [row for row in rows if "aside" in row["label"]]
    assert [row["kind"] for row in rows[:1]] == ["scene"] and len(aside) >= 1
    assert float(aside[0]["planned"]) == 0.0 == float(aside[0]["frame"])
    assert all(float(row["planned"]) <= float(row["frame"]) + 1e-6 for row in rows)
    assert all(0.0 <= float(row["real"]) - float(row["frame"]) < 5.0 for row in rows)


def test_a_trial_sets_what_its_columns_name() -> None:
    Path("trials.csv").write_text("degree,rise\n10%,\n90%,\n", "utf-8")
    Path("unit.face").write_text("let degree = 50%\nlet rise = 0ms\nshow AU12 degree over rise\n", "utf-8")
    words = ["--trials", "trials.csv", "--trial", "2", "--to", "csv:run.csv", "--log", "run.log", "--for", "0.1"]
    assert main(["live", "unit.face", *words]) == 0
    assert json.loads(Path("run.log").read_text("utf-8").splitlines()[0])["set"] == {"degree": "90%"}
    assert float(rows_of("run.csv")[-1]["cheek.lower.left"]) > 0.7


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (["--from", "ws://0.0.0.0:8080"], "FS983"),
        (["--for", "soon"], "FS904"),
        (["--fps", "20000"], "FS904"),
        (["--log", "missing/run.log"], "FS903"),
        (["--trials", "missing.csv", "--trial", "1"], "FS901"),
        (["--replay", "missing.log"], "FS973"),
        (["--replay", "run.log", "--log", "./run.log"], "FS978"),
    ],
)
def test_what_cannot_be_is_told(words: list[str], code: str, capsys: Captured) -> None:
    assert main(["live", "kiosk.face", *words]) == 2
    assert code in capsys.readouterr().err


@pytest.mark.parametrize(
    ("script", "code"),
    [
        ("smiel\n", "FS204"),
        ("at a.end: nod as b\nat b.end: nod as a\n", "FS405"),
        ('face ada = woman, voice en-us nobody\nnod\nwhen heard "no":\n    say "Oh."\n', "FS501"),
    ],
)
def test_faults_of_the_script_are_told_before_it_runs(script: str, code: str, capsys: Captured) -> None:
    Path("kiosk.face").write_text(script, "utf-8")
    assert main(["live", "kiosk.face", "--for", "1"]) == 1
    told = capsys.readouterr()
    assert code in told.err and told.out == ""


def test_a_scene_that_only_an_event_brings_is_no_fault(capsys: Captured) -> None:
    scenes = (
        'scene wait:\n    repeat forever:\n        nod\nscene visit:\n    shake\nwhen key "q":\n    blink\n    stop\n'
    )
    Path("kiosk.face").write_text(scenes, "utf-8")
    assert main(["live", "kiosk.face", "--for", "0.1", "--to", "csv:run.csv"]) == 0
    assert "FS4" not in capsys.readouterr().err


def test_it_ends_in_order() -> None:
    words = ["live", "kiosk.face", "--from", "stdin:", "--from", "http://127.0.0.1:0", "--log", "run.log"]
    command = [sys.executable, "-m", "facescript.cli.main", *words]
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe, env=dict(os.environ))
    try:
        assert process.stdout is not None and process.stderr is not None
        place = re.search(rb"http://[\d.:]+\d", process.stderr.readline())
        for _ in range(5):
            assert json.loads(process.stdout.readline())
        assert place is not None
        with urlopen(f"{place[0].decode()}/status", timeout=5) as answer:
            status = json.load(answer)
        assert status["frames"] > 0 and status["to"]["-"]["sent"] > 0 and set(status["from"]) == {words[3], words[5]}
        process.send_signal(signal.SIGTERM)
        out, said = process.communicate(timeout=20)
        assert process.returncode == 0
        assert b" frames in " in said and b"Traceback" not in said
        assert all(json.loads(line) for line in out.splitlines())
        assert json.loads(Path("run.log").read_text("utf-8").splitlines()[-1])["ended"] is True
    finally:
        process.kill()
        process.wait()
