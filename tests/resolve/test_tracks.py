"""Targets that follow a file: what a track says, and everything that can be wrong with one."""

from __future__ import annotations

from pathlib import Path

import pytest
from plays import codes, play_of, resolved, said

from facescript.ir.json_form import dump, load
from facescript.ir.play import MovingTarget
from facescript.resolve import tracks
from facescript.resolve.units import LARGEST, TIME

DAY = LARGEST[TIME]
SCRIPT = 'target fly from "track.csv"\nlook at fly\n'


def tracked(folder: Path, text: str | bytes, script: str = SCRIPT) -> MovingTarget:
    write(folder, text)
    (fly,) = play_of(script, folder).targets
    assert isinstance(fly, MovingTarget)
    return fly


def write(folder: Path, text: str | bytes) -> None:
    (folder / "track.csv").write_bytes(text if isinstance(text, bytes) else text.encode())


def fault(folder: Path, text: str | bytes) -> str:
    write(folder, text)
    return said(resolved(SCRIPT, folder)[1])


def test_rows_are_keys_and_other_columns_are_passed_over(tmp_path: Path) -> None:
    fly = tracked(tmp_path, "Frame, TIME ,Z,y,X,note\n1,0,200,-5,-30,a\n\n2,0.5,1e2,0,30,b\n")
    assert fly.times == (0.0, 0.5)
    assert [(place.x, place.y, place.z) for place in fly.places] == [(-30, -5, 200), (30, 0, 100)]
    assert fly.lost == ()


def test_directions_are_as_in_a_script(tmp_path: Path) -> None:
    fly = tracked(tmp_path, b"\xef\xbb\xbftime,azimuth,elevation,distance\r\n0,25,10,200\r\n1,-25,0,100\r\n")
    (same,) = play_of("target fly moves\n    0s 25deg 10deg 2m\n    1s -25deg 0deg 1m\nlook at fly\n").targets
    assert fly.places == same.places


@pytest.mark.parametrize(
    ("rows", "times", "lost"),
    [
        ("0,1\n0.1,nan\n0.2,\n0.3,2\n", (0.0, 0.3), ()),
        ("0,1\n0.1,nan\n0.4,2\n", (0.0, 0.4), ((0.0, 0.4),)),
        ("0,1\n0.5,2\n0.6,-inf\n1.5,NaN\n2,3\n3,4\n", (0.0, 0.5, 2.0, 3.0), ((0.5, 2.0),)),
        ("0,\n0.1,1\n1,2\n", (0.1, 1.0), ((-DAY, 0.1),)),
        ("0,1\n1,2\n1.1,\n", (0.0, 1.0), ()),
        ("0,1\n1,2\n1.1,\n2,\n", (0.0, 1.0), ((1.0, DAY),)),
    ],
)
def test_a_short_gap_is_bridged_and_in_a_long_one_the_target_is_lost(
    tmp_path: Path, rows: str, times: tuple[float, ...], lost: tuple[tuple[float, float], ...]
) -> None:
    fly = tracked(tmp_path, "time,x,y,z\n" + "".join(f"{row},0,100\n" for row in rows.split()))
    assert (fly.times, fly.lost) == (times, lost)


def test_a_row_that_is_cut_short_says_nothing_of_the_place(tmp_path: Path) -> None:
    assert tracked(tmp_path, "time,x,y,z\n0,1,2,3\n1,2\n2,1,2,3").lost == ((0.0, 2.0),)


def test_the_form_for_programs_has_the_keys_and_the_gaps(tmp_path: Path) -> None:
    write(tmp_path, "time,x,y,z\n0,1,2,3\n1,,,\n2,1,2,3\n")
    play = play_of(SCRIPT, tmp_path)
    (fly,) = load(dump(play)).targets
    assert isinstance(fly, MovingTarget)
    assert (fly.times, fly.lost) == ((0.0, 2.0), ((0.0, 2.0),))
    assert dump(load(dump(play))) == dump(play)


@pytest.mark.parametrize(
    ("text", "code", "part"),
    [
        ("", "FS706", "it has no column `time`, `x`, `y`, `z`"),
        ("time,x,y\n0,1,1\n", "FS706", "it has no column `z`"),
        ("x,y,z\n1,1,1\n", "FS706", "it has no column `time`"),
        ("time,azimuth,distance\n0,1,1\n", "FS706", "it has no column `elevation`"),
        ("time,x,y,z,X\n0,1,1,1,1\n", "FS706", "it has `x` twice"),
        ("time,x,y,z\n", "FS706", "it has no rows"),
        ("time,x,y,z\n0,nan,1,1\n1,,1,1\n", "FS706", "no row says where the target is"),
        ("time,x,y,z\n0,1,1,1\n1,1,left,1\n", "FS707", "`left` in row 2, column `y` of “track.csv” is no number"),
        ('time,x,y,z\n0,"1,5",1,1\n', "FS707", "`1,5` in row 1, column `x`"),
        ("time,x,y,z\n0,1_0,1,1\n", "FS707", "`1_0` in row 1, column `x`"),
        ("time,x,y,z\nnan,1,1,1\n", "FS707", "`nan` in row 1, column `time` of “track.csv” is no number"),
        ("time,x,y,z\n,1,1,1\n", "FS707", "`` in row 1, column `time`"),
        ("time,x,y,z\n-1,1,1,1\n", "FS707", "is not within 0 and 86400 s"),
        ("time,x,y,z\n0,1e9,1,1\n", "FS707", "is beyond 10000000"),
        ("time,azimuth,elevation,distance\n0,1,1,0\n", "FS707", "column `distance` of “track.csv” is not above 0"),
        ("time,x,y,z\n0,1,1,1\n2,1,1,1\n1,1,1,1\n", "FS708", "The time `1` of row 3"),
        ("time,x,y,z\n0,1,1,1\n0,1,1,1\n", "FS708", "The time `0` of row 2"),
        (b"time,x,y,z\n0,\xff,1,1\n", "FS701", "it is not UTF-8"),
        ('time,x,y,z\n0,"1,1,1\n', "FS703", "unexpected end of data"),
    ],
)
def test_faults_are_told_with_their_place(tmp_path: Path, text: str | bytes, code: str, part: str) -> None:
    message = fault(tmp_path, text)
    assert f"script.face:1:17: {code} error:" in message
    assert part in message
    assert message.count("\n") == 1


def test_a_track_is_given_up_at_the_row_that_is_too_many(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The row after it, which is no row at all, is never read; two tracks count together, one file once."""
    monkeypatch.setattr(tracks, "MOST_KEYS", 3)
    write(tmp_path, "time,x,y,z\n0,1,1,1\n1,1,1,1\n")
    (tmp_path / "other.csv").write_text("time,x,y,z\n0,1,1,1\n1,1,1,1\nnever,1,1,1\n", "utf-8")
    assert codes(SCRIPT + 'target bee from "track.csv"\nlook at bee\n', tmp_path) == []
    assert codes(SCRIPT + 'target bee from "other.csv"\nlook at bee\n', tmp_path) == ["FS706"]


def test_a_file_that_is_too_large_is_not_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tracks, "LARGEST_TRACK", 20)
    assert "FS701" in fault(tmp_path, "time,x,y,z\n0,1,1,1\n1,1,1,1\n")


def test_no_file_outside_the_project_is_followed(tmp_path: Path) -> None:
    inner = tmp_path / "inner"
    inner.mkdir()
    write(tmp_path, "time,x,y,z\n0,1,1,1\n")
    assert codes(SCRIPT.replace("track.csv", "../track.csv"), inner) == ["FS701"]
