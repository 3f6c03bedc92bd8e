"""Edits of long scripts, a key at a time: the processor's time to the tree and to all diagnostics, and the memory."""

from __future__ import annotations

import gc
import resource
import statistics
import time
from collections.abc import Iterator
from pathlib import Path
from random import Random
from tempfile import gettempdir

from _scripts import lines_of
from row import Row

from facescript.compile import Compiled
from facescript.recompile import Recompiler
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

MANY = 20_000
"""Edits after which the memory is as it was."""

GROWN = 4.0
"""MB that do not count as growth: what an allocator keeps for itself."""

FLAT = """\
say "Good evening, number {number}." as line{number}
    on "evening": glance lamp
look at lamp for 1s
show smile {degree}% over 300ms
wait {length}00ms
together:
    nod 30%
    show neutral
"""


def flat(count: int) -> str:
    """A script of at least `count` lines without scenes."""
    parts = [FLAT.format(number=number, degree=40 + number % 50, length=number % 5) for number in range(count // 8 + 1)]
    return "target lamp at 25deg 10deg 2m\n" + "".join(parts)


class Author:
    """Types a statement at places here and there and takes it away again; `text` is what stands in the editor."""

    def __init__(self, text: str, seed: int = 1) -> None:
        self.text = text
        self.recompiler, self.voice, self.world = Recompiler(), EstimatedVoice(), World(Path(gettempdir()))
        self._chance, self._undo = Random(seed), [text]
        self.compile()

    def key(self) -> None:
        """One key: a sign more in a new line, or, once the line is whole, none of it."""
        if len(self._undo) > 14:
            self.text = self._undo[0]
            self._undo = [self.text]
            return
        if len(self._undo) == 1:
            at = self.text.find("    nod", self._chance.randrange(len(self.text) - 1000))
            self._at = at if at >= 0 else self.text.find("    nod")
        typed = "    shake 20%\n"[len(self._undo) - 1]
        self.text = self.text[: self._at] + typed + self.text[self._at :]
        self._at += 1
        self._undo.append(self.text)

    def compile(self, whole: bool = False) -> Compiled:
        compiled = self.recompiler.compile(Source("edited.face", self.text), self.world, self.voice)
        if whole:
            _ = compiled.diagnostics
        return compiled


def rows() -> Iterator[Row]:
    for name, text in (("scenes", lines_of), ("one flat script", flat)):
        yield _edits(f"an edit in 2,000 lines, {name}", text(2_000), 600, True, (25, 80))
        yield _edits(f"an edit in 10,000 lines, {name}", text(10_000), 300, True, (None, 150))
        yield _edits(f"to the tree of 2,000 lines, {name}", text(2_000), 300, False, (5, 20))
        yield _edits(f"to the tree of 10,000 lines, {name}", text(10_000), 150, False, (None, 20))
        yield _resolves(f"from the tree to the play of 2,000 lines, {name}", text(2_000), 200, (10, 30))
        yield _resolves(f"from the tree to the play of 10,000 lines, {name}", text(10_000), 100, (None, 60))
        yield _schedules(f"from the play to the faults of 2,000 lines, {name}", text(2_000), 60, (20, 60))
        yield _schedules(f"from the play to the faults of 10,000 lines, {name}", text(10_000), 15, (None, 90))
    yield _memory()


def _edits(what: str, text: str, count: int, whole: bool, bars: tuple[float | None, float]) -> Row:
    author = Author(text)
    author.compile(whole)
    took = []
    for _ in range(count):
        author.key()
        start = time.process_time()
        author.compile(whole)
        took.append((time.process_time() - start) * 1000)
    return judged(what, took, bars)


def judged(what: str, took: list[float], bars: tuple[float | None, float]) -> Row:
    """Milliseconds beside the bars of their p50 (None: none) and p99."""
    half, most = statistics.median(took), sorted(took)[int(len(took) * 0.99)]
    met = most <= bars[1] and (bars[0] is None or half <= bars[0])
    bar = f"p99 {bars[1]} ms" if bars[0] is None else f"p50 {bars[0]} ms, p99 {bars[1]} ms"
    return Row(what, bar, f"p50 {half:.1f} ms, p99 {most:.1f} ms", met)


def _memory() -> Row:
    """What `MANY` edits to all diagnostics of 300 lines leave behind."""
    author = Author(lines_of(300))
    before = 0.0
    for number in range(MANY):
        author.key()
        author.compile(whole=True)
        if number == MANY // 10:
            before = _resident()
    grown = _resident() - before
    return Row(f"memory after {MANY:,} edits of 300 lines", "does not grow", f"{grown:+.1f} MB", grown <= GROWN)


def _resident() -> float:
    """MB of this process now, after what can be let go is."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize() / 2**20


def _resolves(what: str, text: str, count: int, bars: tuple[float | None, float]) -> Row:
    """Resolving alone: from a tree of which one piece is new to the play, or to what is wrong with it."""
    author = Author(text)
    _ = author.compile().play
    took = []
    for _ in range(count):
        author.key()
        compiled = author.compile()
        start = time.process_time()
        _ = compiled.play
        took.append((time.process_time() - start) * 1000)
    return judged(what, took, bars)


def _schedules(what: str, text: str, count: int, bars: tuple[float | None, float]) -> Row:
    """Scheduling alone: from a play of which a few statements are new to all that is wrong with its times."""
    author = Author(text)
    author.compile(whole=True)
    took = []
    while len(took) < count:
        author.key()
        compiled = author.compile()
        played = compiled.play is not None
        start = time.process_time()
        _ = compiled.diagnostics
        if played:
            took.append((time.process_time() - start) * 1000)
    return judged(what, took, bars)
