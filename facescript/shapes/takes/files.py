"""The bytes of a file to the take that is in it: what it is, it says in its first line, whatever its name."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator

from facescript.shapes.takes.channels_csv import is_channels, read_channels
from facescript.shapes.takes.fap_text import is_fap, read_fap
from facescript.shapes.takes.livelink import is_livelink, read_livelink
from facescript.shapes.takes.model import Found, NotATake

LARGEST = 64 * 1024 * 1024
"""Bytes of a file."""

KINDS = "a CSV with `Timecode` and shapes of ARKit, one with `time` and channels, or a `.fap` file"


def read_take(path: str, data: bytes, face: str) -> Found:
    """The take in a file of the project, of `face` where it has several. Raises `NotATake`."""
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise NotATake("it is not UTF-8 text") from None
    first, _, rest = text.partition("\n")
    if not first.strip():
        raise NotATake("it is empty" if not text.strip() else "its first line is blank", 0 if not text.strip() else 1)
    if is_fap(first):
        others = ((number, line) for number, line in enumerate(io.StringIO(rest), 2) if line.strip())
        return read_fap(path, first, others)
    try:
        return _table(path, text, face)
    except csv.Error as fault:
        raise NotATake(str(fault)) from None


def _table(path: str, text: str, face: str) -> Found:
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    header = next(reader)
    rows = _rows(reader)
    if is_livelink(header):
        return read_livelink(path, rows, header)
    if is_channels(header):
        return read_channels(path, rows, header, face)
    raise NotATake(f"it is no recorded face: that is {KINDS}", 1)


def _rows(reader: Iterator[list[str]]) -> Iterator[tuple[int, list[str]]]:
    """Rows with the numbers of their lines, empty ones left out; of a cell with line ends the last counts."""
    for cells in reader:
        if any(cell.strip() for cell in cells):
            yield reader.line_num, cells  # type: ignore[attr-defined]
