"""`facescript live` as a process of its own, for benchmarks: what it says at its end, and what it took."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import threading
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType

KIOSK = Path(__file__).parents[2] / "examples" / "kiosk.face"

ENDED = re.compile(
    r"(\d+) frames in [\d.]+ s at [\d.]+ a second, (\d+) late, (\d+) dropped; 99 of 100 were given within ([\d.]+) ms, "
    r"all within ([\d.]+) ms"
)


@dataclass(frozen=True, slots=True)
class Ended:
    """Frames given, late and dropped, the ms within which 99 of 100 and all were given, seconds of processor time."""

    frames: int
    late: int
    dropped: int
    within: float
    all: float
    spent: float

    def __str__(self) -> str:
        part = 100 * self.dropped / (self.frames + self.dropped)
        return f"all within {self.all:.0f} ms, 99 of 100 within {self.within:.0f} ms, {part:.1f} % dropped"


class Running:
    """A run for so many seconds; `port` is where it takes events, where it says so."""

    def __init__(self, seconds: float, *words: str, script: Path = KIOSK) -> None:
        self.folder = tempfile.TemporaryDirectory(prefix="facescript-bench-")
        command = [sys.executable, "-m", "facescript.cli.main", "live", str(script), "--for", str(seconds), *words]
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(command, stdin=pipe, stderr=pipe, text=True, cwd=self.folder.name)
        self.said: list[str] = []
        self.ended = threading.Event()
        self._listening = threading.Thread(target=self._listen, daemon=True)
        self._listening.start()

    def _listen(self) -> None:
        assert self.process.stderr is not None
        for line in self.process.stderr:
            self.said.append(line.rstrip())
        self.ended.set()

    def __enter__(self) -> Running:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, at: TracebackType | None) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.folder.cleanup()

    def wait(self, text: str) -> str:
        """The first line that has a text."""
        while True:
            for line in list(self.said):
                if text in line:
                    return line
            if self.ended.wait(0.01):
                raise RuntimeError("\n".join(self.said))

    def end(self) -> Ended:
        """Waits for its end."""
        _, status, usage = os.wait4(self.process.pid, 0)
        self.process.returncode = os.waitstatus_to_exitcode(status)
        self._listening.join(5.0)
        found = ENDED.search("\n".join(self.said))
        assert found is not None, self.said
        frames, late, dropped = (int(found[index]) for index in (1, 2, 3))
        return Ended(frames, late, dropped, float(found[4]), float(found[5]), usage.ru_utime + usage.ru_stime)
