"""A run to files: the table that a build makes, lines of JSON, and files that take no more."""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path

import pytest
from streaming import HELLO, ONSET, Told, frame, layout, line, opened, smiling

import facescript
from facescript.live.address import AddressFault
from facescript.live.model import Frame, Layout, Mark
from facescript.live.sinks import writer

SCRIPT = """film 30fps
face ada = woman
    life still

show smile over 200ms as onset
wait 100ms
look left 10deg as aside
wait 100ms
show neutral as offset
"""


async def test_a_table_is_what_a_build_makes(tmp_path: Path) -> None:
    take = facescript.loads(SCRIPT)
    take.save(tmp_path / "built.csv")
    head, *rows = [row.split(",") for row in (tmp_path / "built.csv").read_text().splitlines()]
    of = layout(fps=30)
    assert head == ["time", *of.names, "marker"]
    markers = sorted((one.time, one.name) for one in take.score.markers)
    async with opened(f"csv:{tmp_path}/run.csv", of, Told().setting(patient=True)) as sink:
        for number in range(len(rows)):
            now = number / 30
            while markers and markers[0][0] <= now:
                at, name = markers.pop(0)
                sink.mark(Mark("act", at, "an act", "ada", name))
            sink.frame(Frame(number, now, take.job.performance.sample([now])[0]))
    assert (tmp_path / "run.csv").read_bytes() == (tmp_path / "built.csv").read_bytes()


async def test_a_run_that_is_cut_leaves_whole_rows(tmp_path: Path) -> None:
    of, path = layout(), tmp_path / "run.csv"
    async with opened(f"csv:{path}", of) as sink:
        for number in range(10):
            sink.frame(smiling(number, of))
        ends = time.monotonic() + 5
        while path.read_text().count("\n") < 10 and time.monotonic() < ends:
            time.sleep(0.01)
        text = path.read_text()
    assert text.count("\n") == 10 and text.endswith(",\n")  # the head, nine rows


async def test_a_full_disk_is_told_and_counted_and_ends_nothing() -> None:
    of, told = layout(), Told()
    async with opened("csv:/dev/full", of, told.setting()) as sink:
        for number in range(100):
            sink.frame(smiling(number, of))
            time.sleep(0.001)
    assert told.texts == ["/dev/full cannot be written any more: no space left on device."]
    assert sink.counts()["dropped"] > 50


async def test_a_table_that_cannot_be_made_is_refused(tmp_path: Path) -> None:
    with pytest.raises(AddressFault) as fault:
        async with opened(f"csv:{tmp_path}/missing/run.csv", layout()):
            pass
    assert (fault.value.code, fault.value.values["reason"]) == ("FS903", "no such file or directory")


class Pipe:
    """A pipe as standard output."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.read, write = os.pipe()
        monkeypatch.setattr(sys, "stdout", os.fdopen(write, "w"))


async def test_lines_begin_with_the_layout(monkeypatch: pytest.MonkeyPatch) -> None:
    of, pipe = layout("ada", "eve"), Pipe(monkeypatch)
    async with opened("-", of) as sink:
        sink.mark(HELLO)
        sink.utter(line())
        sink.frame(frame(30, of, eve_head_yaw=-0.00001, ada_lid_left=0.123456))
    first, mark, said, shown = map(json.loads, os.read(pipe.read, 60_000).splitlines())
    assert (first["type"], first["fps"], first["seed"], first["faces"]) == ("layout", 60.0, 7, ["ada", "eve"])
    assert first["channels"][0] == {"name": "ada.head.yaw", "unit": "deg", "rest": 0.0}
    assert mark == {
        "type": "mark", "kind": "word", "time": 0.25, "text": "Hello", "face": "ada", "label": None, "late": 0.001
    }  # fmt: skip
    assert said["words"] == [{"text": "Hello", "start": 1.1, "end": 1.5}] and said["number"] == 3
    assert (shown["number"], shown["time"], shown["values"]["ada.lid.left"]) == (30, 0.5, 0.1235)
    assert list(shown["values"]) == list(of.names) and str(shown["values"]["eve.head.yaw"]) == "0.0"


async def test_who_does_not_read_misses_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writer, "MOST", 20_000)
    monkeypatch.setattr(writer, "PATIENCE", 0.1)
    of = layout()
    pipe = Pipe(monkeypatch)
    began = time.process_time()
    async with opened("-", of) as sink:
        _feed(sink, of, 300)
        assert sink.counts()["dropped"] > 100
    assert time.process_time() - began < 2
    lines = os.read(pipe.read, 200_000).splitlines()
    assert all(json.loads(one) for one in lines[:-1])


def _feed(sink: object, of: Layout, many: int) -> None:
    for number in range(many):
        sink.frame(smiling(number, of))  # type: ignore[attr-defined]
        time.sleep(0.0002)


async def test_the_run_ends_when_nobody_reads_any_more(monkeypatch: pytest.MonkeyPatch) -> None:
    of, pipe = layout(), Pipe(monkeypatch)
    with pytest.raises(BrokenPipeError):  # noqa: PT012 - a thread writes: it is one of the next frames
        async with opened("-", of) as sink:
            os.close(pipe.read)
            sink.mark(ONSET)
            _feed(sink, of, 2000)
