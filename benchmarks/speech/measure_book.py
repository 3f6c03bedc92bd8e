"""An audio book of three hours as a page in parts and as an EPUB: memory and time of each build, in a process of its
own, with nothing in the cache. `FACESCRIPT_BOOK_MINUTES=20` tries a shorter one."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from zipfile import ZipFile

from book_script import book_script
from PIL import Image
from row import Row

MINUTES = float(os.environ.get("FACESCRIPT_BOOK_MINUTES", "180"))
MEMORY, SHARE = 500.0, 1 / 3

PERIOD = 0.1
"""Seconds between two looks at the processes that a build has started."""

BUILD = """
import json, resource, sys, time
from facescript.cli.main import main
begun = time.perf_counter()
code = main(sys.argv[1:])
took = time.perf_counter() - begun
own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
used = own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime
print(json.dumps([code, took, used, own.ru_maxrss / 1024]))
"""
"""Builds, and prints the exit code, seconds by the clock and of the processors, and the program's peak resident MB."""


def rows() -> Iterator[Row]:
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as name:
        folder = Path(name)
        Image.new("RGB", (900, 600), "#88aacc").save(folder / "lake.png")
        (folder / "book.face").write_text(book_script(MINUTES), "utf-8")
        for kind, options in (("epub", []), ("html", ["--page", "book", "--split"])):
            yield from _built(folder, kind, options)


def _built(folder: Path, kind: str, options: list[str]) -> Iterator[Row]:
    out = folder / f"book.{kind}"
    words = [sys.executable, "-c", BUILD, "build", str(folder / "book.face"), "-o", str(out), *options, "--quiet"]
    fresh = os.environ | {"XDG_CACHE_HOME": str(folder / f"cache-{kind}")}
    process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=fresh)
    other = _others(process)
    assert process.stdout is not None
    code, took, used, own = json.loads(process.stdout.read().splitlines()[-1])
    assert code == process.returncode == 0
    length, size = _length(folder / "book.epub"), _size(out)
    what = f"book of {length / 3600:.2f} h as .{kind}"
    memory = f"{own + other:.0f} MB: {own:.0f} MB, and {other:.0f} MB in the processes that it starts"
    yield Row(f"{what}: memory", f"{MEMORY:g} MB", memory, own + other < MEMORY)
    share = f"{took / length:.3f} ({took:.0f} s, {used:.0f} s of the processors), {size / 1e6:.0f} MB"
    yield Row(f"{what}: time, of its length", f"{SHARE:.2f}", share, took <= SHARE * length)


def _others(process: subprocess.Popen[str]) -> float:
    """The most MB, at their peaks, that the processes started by one have had at a time; waits until it has ended."""
    most = 0.0
    while process.poll() is None:
        most = max(most, sum(map(_resident, _started(process.pid))))
        time.sleep(PERIOD)
    return most


def _started(parent: int) -> list[int]:
    """The processes below one, but for those that have only just branched off and are still its image."""
    try:
        image = Path(f"/proc/{parent}/cmdline").read_bytes()
        children = [
            int(pid)
            for each in Path(f"/proc/{parent}/task").iterdir()
            for pid in (each / "children").read_text().split()
        ]
        own = [pid for pid in children if Path(f"/proc/{pid}/cmdline").read_bytes() != image]
    except OSError:
        return []
    return [*own, *(pid for child in own for pid in _started(child))]


def _resident(pid: int) -> float:
    """Peak resident MB of a running process so far; 0 where it has ended."""
    try:
        lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    except OSError:
        return 0.0
    return sum(int(line.split()[1]) / 1024 for line in lines if line.startswith("VmHWM"))


def _length(book: Path) -> float:
    """Seconds of what is heard, as the EPUB has it."""
    package = ZipFile(book).read("EPUB/package.opf").decode()
    hours, minutes, seconds = package.rpartition('"media:duration">')[2].partition("<")[0].split(":")
    return int(hours) * 3600 + int(minutes) * 60 + float(seconds)


def _size(out: Path) -> int:
    beside = out.with_name(f"{out.stem}-files")
    parts = [out, *(beside.iterdir() if out.suffix == ".html" else ())]
    return sum(part.stat().st_size for part in parts)
