"""An audio book of three hours as a page in parts and as an EPUB: memory and time of each build, in a process of its
own, with nothing in the cache. `FACESCRIPT_BOOK_MINUTES=20` tries a shorter one."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from zipfile import ZipFile

from book_script import book_script
from PIL import Image
from row import Row

MINUTES = float(os.environ.get("FACESCRIPT_BOOK_MINUTES", "180"))
MEMORY, SHARE = 500.0, 1 / 3

BUILD = """
import json, resource, sys, time
from facescript.cli.main import main
begun = time.perf_counter()
code = main(sys.argv[1:])
took = time.perf_counter() - begun
own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
used = own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime
print(json.dumps([code, took, used, own.ru_maxrss / 1024, others.ru_maxrss / 1024]))
"""
"""Builds, and prints the exit code, seconds by the clock and of the processor, and the peak resident MB of the program
and of the largest process that it started."""


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
    done = subprocess.run(words, capture_output=True, text=True, check=True, env=fresh)
    code, took, used, own, other = json.loads(done.stdout.splitlines()[-1])
    assert code == 0, done.stderr
    length, size = _length(folder / "book.epub"), _size(out)
    what = f"book of {length / 3600:.2f} h as .{kind}"
    memory = f"{own + other:.0f} MB ({own:.0f} MB, and at most {other:.0f} MB in another process)"
    yield Row(f"{what}: memory", f"{MEMORY:g} MB", memory, own + other < MEMORY)
    share = f"{took / length:.3f} ({took:.0f} s, {used:.0f} s of the processor), {size / 1e6:.0f} MB"
    yield Row(f"{what}: time, of its length", f"{SHARE:.2f}", share, took <= SHARE * length)


def _length(book: Path) -> float:
    """Seconds of what is heard, as the EPUB has it."""
    package = ZipFile(book).read("EPUB/package.opf").decode()
    hours, minutes, seconds = package.rpartition('"media:duration">')[2].partition("<")[0].split(":")
    return int(hours) * 3600 + int(minutes) * 60 + float(seconds)


def _size(out: Path) -> int:
    beside = out.with_name(f"{out.stem}-files")
    parts = [out, *(beside.iterdir() if out.suffix == ".html" else ())]
    return sum(part.stat().st_size for part in parts)
