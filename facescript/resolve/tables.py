"""Tables that a script repeats over: CSV files of the project to rows of words."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from functools import partial
from itertools import islice

from facescript.resolve.files import project_path
from facescript.resolve.project import Project
from facescript.resolve.scope import Row
from facescript.syntax.tree import String
from facescript.world import WorldFailure

MOST_ROWS = 20_000
LARGEST = 16 * 1024 * 1024
"""Bytes of a table."""


def rows(project: Project, path: String) -> tuple[Row, ...]:
    """The rows of a table under its header line, empty lines left out. Raises `Refused`."""
    return project.memo.once(project, ("table", path.value), path, partial(_rows, project, path))


def _rows(project: Project, path: String) -> tuple[Row, ...]:
    name, lines = path.value, _lines(project, path)
    if not lines:
        raise project.refuse("FS703", path.span, path=name, reason="it is empty")
    header = [column.strip() for column in lines[0]]
    if len(set(header)) < len(header) or not all(header):
        raise project.refuse("FS703", path.span, path=name, reason="its first line does not name each column once")
    if len(lines) == 1:
        project.report("FS705", path.span, path=name)
    return tuple(_row(project, path, number, header, cells) for number, cells in enumerate(lines[1:], 1))


def _lines(project: Project, path: String) -> list[list[str]]:
    lines = list(islice(cells(project, path, LARGEST), MOST_ROWS + 2))
    if len(lines) > MOST_ROWS + 1:
        reason = f"it has more than {MOST_ROWS} rows"
        raise project.refuse("FS703", path.span, path=path.value, reason=reason)
    return lines


def cells(project: Project, path: String, largest: int) -> Iterator[list[str]]:
    """The rows of a CSV file of at most `largest` bytes as cells, read one by one, empty ones left out.

    Raises `Refused` where the file cannot be read, and at the row that cannot.
    """
    try:
        name = project_path(path.span, path.value)
        data = project.world_of(name).read(name, largest)
        lines = io.TextIOWrapper(io.BytesIO(data), "utf-8-sig", newline="")
        yield from (row for row in csv.reader(lines, strict=True) if any(row))
    except WorldFailure as failure:
        raise project.refuse("FS701", path.span, path=path.value, reason=failure.args[0]) from None
    except UnicodeDecodeError:
        raise project.refuse("FS701", path.span, path=path.value, reason="it is not UTF-8") from None
    except csv.Error as fault:
        raise project.refuse("FS703", path.span, path=path.value, reason=str(fault)) from None


def _row(project: Project, path: String, number: int, header: list[str], cells: list[str]) -> Row:
    if len(cells) != len(header):
        reason = f"row {number} has {len(cells)} cells under {len(header)} columns"
        raise project.refuse("FS703", path.span, path=path.value, reason=reason)
    return Row(path.value, number, {column: cell.strip() for column, cell in zip(header, cells, strict=True)})
