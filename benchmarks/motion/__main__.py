"""Measures the motion of faces against the bars of human motion and prints a row a bar: `python benchmarks/motion`."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

sys.path.insert(1, str(Path(__file__).parents[2] / "tests" / "motion"))

import announcer
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
    """Print all tables; 1 where a counted bar or a statistic of the announcer fails."""
    with ProcessPoolExecutor(len(groups.HALVES)) as workers:
        halves = workers.map(work, groups.HALVES)
        thesis = list(workers.map(announcer.p_values, announcer.SEEDS))
    done = list(halves)
    rows = [each for half, _ in done for each in half]
    rows += extremes({side: max(furthest[side] for _, furthest in done) for side in done[0][1]})
    print(table.printed(rows), announcer.printed(thesis), sources.printed(), table.totals(rows), sep="\n\n")
    spoken = all(announcer.passes(thesis, name) for name in thesis[0])
    return 0 if spoken and not table.failed(rows) else 1


if __name__ == "__main__":
    sys.exit(main())
