"""What the benchmarks share: a figure beside its bar, a process's time and memory, a compiled script."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from facescript.backends.job import Job
from facescript.compile import compile_source
from facescript.speech.model import VoiceBox
from facescript.text import Source
from facescript.world import World


def row(what: str, figure: str, bar: str, met: bool) -> None:
    """One line of the table."""
    print(f"| {what} | {figure} | {bar} | {'met' if met else 'NOT MET'} |", flush=True)


def timed(words: list[str], runs: int = 7) -> list[float]:
    """Wall seconds of a command, one a run, after one run that is not counted."""
    seconds = []
    for _ in range(runs + 1):
        start = time.perf_counter()
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        seconds.append(time.perf_counter() - start)
    return sorted(seconds[1:])


def peak_memory(words: list[str]) -> tuple[float, float]:
    """Wall seconds and peak resident MB of one process."""
    start = time.perf_counter()
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    assert os.waitstatus_to_exitcode(status) == 0, words
    return time.perf_counter() - start, usage.ru_maxrss / 1024


def facescript(*words: str) -> list[str]:
    return [sys.executable, "-m", "facescript.cli.main", *words]


def script_file(text: str) -> Path:
    """A script in a folder of its own."""
    path = Path(tempfile.mkdtemp(prefix="facescript-bench-")) / "bench.face"
    path.write_text(text, "utf-8")
    return path


def job_of(text: str, voice: VoiceBox) -> Job:
    """A whole script as a job."""
    world = World(Path(tempfile.gettempdir()))
    compiled = compile_source(Source("bench.face", text), world, voice)
    assert compiled.play is not None, [item.message for item in compiled.diagnostics]
    assert compiled.score is not None, [item.message for item in compiled.diagnostics]
    return Job(compiled.play, compiled.score, world.read, 0.0, compiled.score.duration)
