"""Measures the author's desk against its bars and prints a row a bar: `python benchmarks/desk [NAME]...`.

A file `measure_NAME.py` beside this one has a function `rows() -> Iterator[Row]`; without a name all are run.
"""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path


def main(names: list[str]) -> int:
    """Print the rows as they are found; 1 where a bar is not met."""
    here = Path(__file__).parent
    sys.path += [str(here.parent), str(here.parent / "speech")]
    known = sorted(path.stem.removeprefix("measure_") for path in here.glob("measure_*.py"))
    met = True
    print("| what | bar | found | |\n|---|---|---|---|", flush=True)
    for name in names or known:
        for row in import_module(f"measure_{name}").rows():
            print(row, flush=True)
            met = met and row.met is not False
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
