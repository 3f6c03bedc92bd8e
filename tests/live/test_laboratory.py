"""The how-to for laboratories: its face answers to its cues, over LSL and over a WebSocket, and writes down when."""

from __future__ import annotations

import csv
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import Timer
from typing import Any

import pytest

PAGE = Path(__file__).parents[2] / "docs" / "howto" / "stimuli.md"
LSL = Path(__file__).parents[1] / "streams" / "lsl_api.cfg"


def block(start: str) -> str:
    """The block of the page that begins so."""
    blocks = re.findall(r"^```\w+[^\n]*\n(.*?)^```$", PAGE.read_text("utf-8"), re.MULTILINE | re.DOTALL)
    return next(text for text in blocks if start in text)


@contextmanager
def running(folder: Path, *sources: str) -> Iterator[Callable[[str], str]]:
    """The how-to's face, taking events from somewhere; waits for what it says."""
    (folder / "answer.face").write_text(block("# answer.face"), "utf-8")
    words = ["live", "answer.face", "--to", "csv:run.csv", "--onsets", "p01.csv"]
    words += [word for source in sources for word in ("--from", source)]
    command = [sys.executable, "-m", "facescript.cli.main", *words]
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, cwd=folder, stderr=pipe, text=True, env={**os.environ, "LSLAPICFG": str(LSL)})
    assert process.stderr is not None
    stderr = process.stderr
    late = Timer(60, process.kill)
    late.start()

    def said(what: str) -> str:
        return next((line for line in stderr if what in line), "")

    try:
        yield said
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=20) == 0
    finally:
        late.cancel()
        process.kill()
        process.wait()


def onsets(folder: Path, *labels: str) -> dict[str, dict[str, str]]:
    """The rows of what bears these names, once they are written."""
    end = time.monotonic() + 20
    while time.monotonic() < end:
        path = folder / "p01.csv"
        rows = {row["label"]: row for row in csv.DictReader(path.read_text().splitlines())} if path.exists() else {}
        if set(labels) <= {name.rpartition(".")[2] for name in rows}:
            return {name.rpartition(".")[2]: row for name, row in rows.items()}
        time.sleep(0.05)
    raise AssertionError(f"{labels} did not begin")


def in_time(row: dict[str, str]) -> bool:
    return 0.0 <= float(row["frame"]) - float(row["planned"]) < 0.1 and float(row["real"]) >= float(row["frame"])


def test_cues_over_a_websocket_and_lsl(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pylsl")
    monkeypatch.setenv("LSLAPICFG", str(LSL))
    name, scope = f"Cues {time.monotonic_ns()}", dict[str, Any]()
    exec(block("def present"), scope)
    exec(block("outlet.push_sample").replace('"Cues"', f'"{name}"'), scope)
    with running(tmp_path, "ws://127.0.0.1:0", f"lsl://{name}") as said:
        address = said("listens at").split()[-1].rstrip(".")
        assert scope["outlet"].wait_for_consumers(20)
        scope["cue"]("smile")
        scope["present"](["aside"], 0.1, address)
        found = onsets(tmp_path, "smiled", "averted")
    assert in_time(found["smiled"]) and in_time(found["averted"])
