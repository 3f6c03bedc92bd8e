"""Measures the motion of faces against the bars of human motion and prints a row a bar: `python benchmarks/motion`."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

sys.path.insert(1, str(Path(__file__).parents[2] / "tests" / "motion"))

import groups
import sources
import table
from playing import CannotPlay, Studio
from saccades import extremes
from table import Measures, Row, bars


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
        rows += measured(groups.GROUPS[name], studio)
        print(f"{name} measured", file=sys.stderr, flush=True)
    return rows, studio.extremes


def main() -> int:
    """Print all tables; 1 where a counted bar fails."""
    with ProcessPoolExecutor(len(groups.HALVES)) as workers:
        done = list(workers.map(work, groups.HALVES))
    rows = [each for half, _ in done for each in half]
    rows += extremes({side: max(furthest[side] for _, furthest in done) for side in done[0][1]})
    print(table.printed(rows), sources.printed(), table.totals(rows), sep="\n\n")
    return 1 if table.failed(rows) else 0


if __name__ == "__main__":
    sys.exit(main())
