"""`--trials FILE --trial N`: a row of a table to the values of the `let`s that its columns name."""

from __future__ import annotations

import csv
import io

from facescript.cli.report import OptionFault
from facescript.cli.settings import count
from facescript.project import open_script
from facescript.world import WorldFailure


def trial(table: str | None, row: str | None) -> dict[str, str]:
    """The cells of a row, from 1 on, by their columns; empty cells leave what the script says. Raises `OptionFault`."""
    if table is None and row is None:
        return {}
    if table is None or row is None:
        raise OptionFault("FS977", option="--trial" if table is None else "--trials")
    number = count("--trial", row, "3")
    try:
        text = open_script(table)[0].text
        rows = list(csv.DictReader(io.StringIO(text), strict=True))
    except WorldFailure as fault:
        raise OptionFault("FS901", name=table, reason=fault.args[0]) from None
    except csv.Error as fault:
        raise OptionFault("FS976", name=table, reason=str(fault)) from None
    if not 1 <= number <= len(rows):
        raise OptionFault("FS976", name=table, reason=f"it has {len(rows)} rows, and no row {number}")
    return _cells(table, rows[number - 1])


def _cells(table: str, row: dict[str | None, object]) -> dict[str, str]:
    if None in row or None in row.values():
        raise OptionFault("FS976", name=table, reason="that row has not a cell for each column")
    return {str(name).strip(): str(cell).strip() for name, cell in row.items() if str(cell).strip()}
