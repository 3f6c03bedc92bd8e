"""The files of shapes, `.arkit.csv` and `.fap`, read here by their layouts as others document them."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from facescript.cli.main import main

LOOKING = """film 640x360, 25fps
face ada = woman
    life still
show smile.left over 0ms
look left 20deg, head 50%
wait 600ms
"""

TWO = "film 640x360\nface ada = woman\nface bruno = man\nada: nod\n"


@pytest.fixture
def build(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):  # type: ignore[no-untyped-def]
    """Build a script's outputs: the exit code, and what was said."""
    monkeypatch.chdir(tmp_path)

    def made(text: str, *words: str) -> tuple[int, str]:
        (tmp_path / "script.face").write_text(text, "utf-8")
        code = main(["build", "script.face", "--quiet", *words])
        return code, capsys.readouterr().err

    return made


def test_a_csv_of_live_link_face(build, tmp_path: Path) -> None:  # type: ignore[no-untyped-def]
    """Head line, time codes that count sixtieths, and signs, as recordings of the app have them."""
    assert build(LOOKING, "-o", "x.arkit.csv", "-o", "x.csv") == (0, "")
    rows = list(csv.DictReader((tmp_path / "x.arkit.csv").open(encoding="ascii", newline="")))
    header = list(rows[0])
    assert header[:3] == ["Timecode", "BlendshapeCount", "EyeBlinkLeft"] and len(header) == 63
    assert header[16:20] == ["JawForward", "JawRight", "JawLeft", "JawOpen"]
    assert header[-10:-6] == ["TongueOut", "HeadYaw", "HeadPitch", "HeadRoll"]
    assert [row["Timecode"] for row in rows[:3]] == ["00:00:00:00.000", "00:00:00:02.400", "00:00:00:04.800"]
    assert {row["BlendshapeCount"] for row in rows} == {"61"}
    last, channels = rows[-1], list(csv.DictReader((tmp_path / "x.csv").open(encoding="utf-8")))[-1]
    assert float(last["MouthSmileLeft"]) > 0.9 and float(last["MouthSmileRight"]) == 0.0
    assert float(last["HeadYaw"]) == pytest.approx(-np.radians(float(channels["head.yaw"])), abs=1e-6)
    assert float(last["EyeLookOutLeft"]) > 0.2 and float(last["EyeLookInLeft"]) == 0.0


def test_a_fap_file(build, tmp_path: Path) -> None:  # type: ignore[no-untyped-def]
    """Four fields, then two lines a frame: a mask of 68, and a number with as many values as the mask has."""
    assert build(LOOKING, "-o", "x.fap") == (0, "") == build(LOOKING, "-o", "again.fap")
    assert (tmp_path / "x.fap").read_bytes() == (tmp_path / "again.fap").read_bytes()
    head, *lines = (tmp_path / "x.fap").read_text("ascii").splitlines()
    version, name, fps, frames = head.split()
    assert (version, name, fps, len(lines)) == ("2.1", "ada.fap", "25", 2 * int(frames))
    for number, (mask, values) in enumerate(zip(lines[::2], lines[1::2], strict=True)):
        flags = mask.split()
        assert len(flags) == 68 and set(flags) <= {"0", "1"}
        assert int(values.split()[0]) == number
        assert len(values.split()) == flags.count("1") + 1
    told = [at for at, flag in enumerate(lines[-2].split(), 1) if flag == "1"]
    last = dict(zip(told, map(int, lines[-1].split()[1:]), strict=True))
    assert last[49] > 5000 and last[23] > 5000  # head and left eye, + is the face's left, 1e-5 rad
    assert last[59] > 200 and last[60] == 0  # its left corner of the mouth goes up


@pytest.mark.parametrize("suffix", ["arkit.csv", "fap"])
def test_with_several_faces_one_is_named(build, suffix: str, tmp_path: Path) -> None:  # type: ignore[no-untyped-def]
    code, said = build(TWO, "-o", f"x.{suffix}")
    assert code == 1 and "FS907" in said and "`--face NAME` says which: `ada`, `bruno`" in said
    assert not (tmp_path / f"x.{suffix}").exists()
    code, said = build(TWO, "-o", f"x.{suffix}", "--face", "carla")
    assert code == 1 and "there is no face `carla` to see" in said
    assert build(TWO, "-o", f"x.{suffix}", "--face", "ada") == (0, "")
    nodding = (tmp_path / f"x.{suffix}").read_bytes()
    assert build(TWO, "-o", f"x.{suffix}", "--face", "bruno") == (0, "")
    assert (tmp_path / f"x.{suffix}").read_bytes() != nodding


def test_what_does_not_fit_is_said(build) -> None:  # type: ignore[no-untyped-def]
    code, said = build(TWO, "-o", "x.csv", "--face", "ada")
    assert code == 2 and "FS905" in said and ".arkit.csv and .fap" in said
    code, said = build(LOOKING, "-o", "x.fap", "--fps", "29.97")
    assert code == 1 and "`--fps 30`" in said
    assert build(LOOKING, "-o", "x.fap", "--fps", "30")[0] == 0


def test_a_plain_csv_is_still_the_table_of_channels(build, tmp_path: Path) -> None:  # type: ignore[no-untyped-def]
    assert build(LOOKING, "-o", "arkit.csv") == (0, "")
    assert (tmp_path / "arkit.csv").read_text("utf-8").startswith("time,head.yaw")
