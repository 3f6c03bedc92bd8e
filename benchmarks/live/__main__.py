"""Measures live runs against their bars and prints a row a bar: `python benchmarks/live [NAME]...`.

A file `measure_NAME.py` beside this one has a function `rows() -> Iterator[Row]`; without a name all are run.
"""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path += [str(HERE.parent), str(HERE.parent / "speech")]

from _rows import printed  # noqa: E402

if __name__ == "__main__":
    sys.exit(printed(HERE, sys.argv[1:]))
