"""Measures the motion of faces against the bars of human motion and prints a row a bar: `python benchmarks/motion`."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

sys.path.insert(1, str(Path(__file__).parents[2] / "tests" / "motion"))

import groups
from playing import CannotPlay, Studio
from saccades import extremes
from table import Measures, Row, bars, failed, printed


def measured(measures: Measures, studio: Studio) -> Iterator[Row]:
    """The rows of a group; bars whose scripts do not compile have a failed row with the compiler's message."""
    for names, measure in measures.items():
        try:
            yield from measure(studio)
        except CannotPlay as fault:
            yield from (Row(name, bars()[name].text, str(fault), ()) for name in names.split())


def work(names: Sequence[str]) -> tuple[list[Row], dict[str, float]]:
    """The rows of several groups, and how far any eye turned in their traces."""
    studio, rows = Studio(), []
    for name in names:
        begun = time.perf_counter()
        rows += measured(groups.GROUPS[name], studio)
        print(f"{name}: {time.perf_counter() - begun:.0f} s", file=sys.stderr, flush=True)
    return rows, studio.extremes


def main() -> int:
    wanted = sys.argv[1:]
    halves = [wanted] if wanted else list(groups.HALVES)
    with ProcessPoolExecutor(len(halves)) as workers:
        done = list(workers.map(work, halves))
    rows = [each for half, _ in done for each in half]
    rows += extremes({side: max(furthest[side] for _, furthest in done) for side in done[0][1]})
    print(printed(rows))
    missed = failed(rows)
    print(f"\n{len(bars()) - 3 - len(missed)} of {len(bars()) - 3} bars pass; not: {' '.join(missed) or 'none'}")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
