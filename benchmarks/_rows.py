"""A folder of measurements to the rows of a table: a file `measure_NAME.py` has `rows() -> Iterator[Row]`."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from pathlib import Path


def printed(folder: Path, names: Sequence[str]) -> int:
    """Print the rows of some measurements (none named: of all) as they are found; 1 where a bar is not met.

    The folder's files must be importable by their names.
    """
    known = sorted(path.stem.removeprefix("measure_") for path in folder.glob("measure_*.py"))
    met = True
    print("| what | bar | found | |\n|---|---|---|---|", flush=True)
    for name in names or known:
        for row in import_module(f"measure_{name}").rows():
            print(row, flush=True)
            met = met and row.met is not False
    return 0 if met else 1
