"""A hundred thousand random and mutated scripts: none may crash the compiler or hold it for more than a second.

`python benchmarks/fuzz.py [COUNT] [SEED]`; prints the slowest and every fault with the script that brought it about.
A second is one of the processor's time, so that other work on the machine does not count.
"""

from __future__ import annotations

import random
import signal
import sys
import time
import traceback
from collections.abc import Iterator
from pathlib import Path

from _measure import row
from _scripts import lines_of
from _wild import wild

from facescript.compile import compile_source
from facescript.speech.estimate import EstimatedVoice
from facescript.syntax.formatter import format_source
from facescript.text import Source
from facescript.world import World

ROOT = Path(__file__).parents[1]
SLOWEST_ALLOWED = 1.0
HELD = 20.0
"""After so many seconds a script is given up, which is a fault."""

SHOWN = 1200


def seeds() -> list[str]:
    texts = [path.read_text("utf-8") for path in sorted((ROOT / "examples").glob("*.face"))]
    return [*texts, lines_of(60)]


def scripts(count: int, seed: int) -> Iterator[str]:
    chance, grown = random.Random(seed), seeds()
    return (wild(grown, chance) for _ in range(count))


def run(text: str, world: World) -> float:
    """The processor's seconds that a script takes, from text to score and to its one layout."""
    start = time.process_time()
    signal.setitimer(signal.ITIMER_VIRTUAL, HELD)
    source = Source("fuzz.face", text)
    compile_source(source, world, EstimatedVoice())
    format_source(source)
    return time.process_time() - start


def show(what: str, text: str) -> None:
    shown = text if len(text) <= SHOWN else f"{text[:SHOWN]}... ({len(text):,} characters)"
    print(f"--- {what}\n{shown}", file=sys.stderr, flush=True)


def give_up(*_: object) -> None:
    raise TimeoutError


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    signal.signal(signal.SIGVTALRM, give_up)
    world = World(ROOT / "examples")
    slowest, slow, faults = 0.0, 0, 0
    for number, text in enumerate(scripts(count, seed)):
        try:
            seconds = run(text, world)
        except Exception:
            faults += 1
            show(f"number {number}: {traceback.format_exc(limit=-4)}", text)
            continue
        if seconds > SLOWEST_ALLOWED:
            slow += 1
            show(f"number {number}: {seconds:.2f} s", text)
        slowest = max(slowest, seconds)
    row(f"{count:,} random and mutated scripts", f"{faults} faults, {slow} slow, slowest {slowest:.2f} s",
        "0 faults, 1 s", faults == 0 and slow == 0)  # fmt: skip


if __name__ == "__main__":
    main()
