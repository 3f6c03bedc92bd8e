"""A hundred thousand random and mutated scripts: none may crash the compiler or hold it for more than a second.

`python benchmarks/fuzz.py [COUNT] [SEED]`; prints the slowest and every fault with the script that brought it about.
"""

from __future__ import annotations

import random
import sys
import time
import traceback
from pathlib import Path

from _measure import row
from _scripts import lines_of

from facescript.compile import compile_source
from facescript.speech.estimate import EstimatedVoice
from facescript.syntax.formatter import format_source
from facescript.text import Source
from facescript.world import World

ROOT = Path(__file__).parents[1]
WORDS = (
    "say look at glance scan show add drop nod shake tilt blink wink wait until together: choose: in turn: repeat "
    "times forever for over back ease as face target film scene action expression let use when event life target "
    'camera smile AU4 AU12.left head.yaw lid.left 40% 300ms 2s 10deg 60cm 2m 17/min 3 "Hello *you*." "[smile]a[/]" '
    "( ) + - * / , : . = # #ff8800 1280x720 left right ada bruno hello.end hello."
).split()
SIGNS = "\t\"'()[]{}+-*/,.:;=#%|\\ \n\u201c\u201d\uff0c\uff1a\u200f\u0000\u4e2d\u00e9\U0001f600"
SLOWEST_ALLOWED = 1.0


def seeds() -> list[str]:
    texts = [path.read_text("utf-8") for path in sorted((ROOT / "examples").glob("*.face"))]
    return [*texts, lines_of(60)]


def invented(chance: random.Random) -> str:
    """Words of the language in no order, on indented lines."""
    lines = []
    for _ in range(chance.randrange(1, 14)):
        words = " ".join(chance.choice(WORDS) for _ in range(chance.randrange(1, 9)))
        lines.append(" " * 4 * chance.randrange(0, 4) + words)
    return "\n".join(lines) + "\n"


def mutated(text: str, chance: random.Random) -> str:
    """A script with a few signs or lines changed, moved, doubled or lost."""
    for _ in range(chance.randrange(1, 5)):
        at, length = chance.randrange(len(text) + 1), chance.randrange(0, 30)
        piece = text[at : at + length]
        kind = chance.randrange(5)
        new = (chance.choice(SIGNS), "", piece * 2, f" {chance.choice(WORDS)} ", piece[::-1])[kind]
        text = text[:at] + new + text[at + length :]
    return text


def run(text: str, world: World) -> float:
    start = time.perf_counter()
    source = Source("fuzz.face", text)
    compile_source(source, world, EstimatedVoice())
    format_source(source)
    return time.perf_counter() - start


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    chance = random.Random(int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    world, grown = World(ROOT / "examples"), seeds()
    slowest, faults = 0.0, 0
    for _ in range(count):
        text = invented(chance) if chance.random() < 0.4 else mutated(chance.choice(grown), chance)
        try:
            seconds = run(text, world)
        except Exception:
            faults += 1
            print(f"--- a fault in\n{text}\n{traceback.format_exc(limit=-4)}", file=sys.stderr)
            continue
        if seconds > SLOWEST_ALLOWED:
            print(f"--- {seconds:.2f} s for\n{text}", file=sys.stderr)
        slowest = max(slowest, seconds)
    row(f"{count:,} random and mutated scripts", f"{faults} faults, slowest {slowest:.2f} s", "0 faults, 1 s",
        faults == 0 and slowest <= SLOWEST_ALLOWED)  # fmt: skip


if __name__ == "__main__":
    main()
