"""A CSV of Live Link Face, or one like it, to a take: `Timecode`, `BlendshapeCount`, and shapes of ARKit by name.

Columns may come in any order and any case, with `_L` and `_R` for `Left` and `Right`; those that are no shapes are
passed over. A row without shapes is one in which the phone saw no face.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from statistics import median

from facescript.shapes.rows import rows as table
from facescript.shapes.takes.model import Found, NotATake, counted, number, take

TIMECODE = "timecode"
COUNT = "blendshapecount"

CODE = re.compile(r"(\d{1,2}):([0-5]?\d):([0-5]?\d)[:;](\d{1,3}(?:\.\d+)?)")
"""Hours, minutes, seconds, frames."""

USUAL = 60.0
"""Frames a second that time codes count, where the file does not tell: those of the app."""

DAY = 24 * 3600.0

MOST = 10.0
"""The greatest value: shapes go from 0 to 1, rotations (rad) to pi."""

Codes = list[tuple[float, float]]
"""Whole seconds, and frames in them."""


def is_livelink(header: Sequence[str]) -> bool:
    """Whether a head line is one of such a file."""
    return bool(header) and header[0].strip().casefold() == TIMECODE


def read_livelink(path: str, lines: Iterator[tuple[int, list[str]]], header: Sequence[str]) -> Found:
    """The take of the rows under a header; `lines` are their cells with the numbers of their lines. Raises
    `NotATake`."""
    columns = _columns(header)
    codes: Codes = []
    found: list[list[float]] = []
    places: list[int] = []
    lost = 0
    for line, cells in lines:
        counted(len(found) + lost, line)
        code = _code(cells[0].strip(), line)
        if _faceless(cells, header):
            lost += 1
            continue
        if len(cells) != len(header):
            raise NotATake(f"there are {len(cells)} cells under {len(header)} columns", line)
        codes.append(code)
        places.append(line)
        found.append([number(cells[at].strip(), line, header[at].strip(), MOST) for _, at in columns])
    times = _times(codes, places)
    kept = [index for index in range(len(times)) if index == 0 or times[index] > times[index - 1]]
    values = [found[index] for index in kept]
    names = tuple(name for name, _ in columns)
    return Found(take(path, "arkit", names, [times[index] for index in kept], values), lost)


def _columns(header: Sequence[str]) -> list[tuple[str, int]]:
    """The columns that are shapes, by the names of the table."""
    known = {row["name"].casefold(): row["name"] for row in table("arkit")}
    found: dict[str, int] = {}
    for at, cell in enumerate(header):
        name = re.sub(r"_([lr])$", lambda side: {"l": "left", "r": "right"}[side[1]], cell.strip().casefold())
        if name in known and found.setdefault(known[name], at) != at:
            raise NotATake(f"it has the column `{known[name]}` twice", 1)
    if not found:
        raise NotATake("no column of it is a shape of ARKit", 1)
    return list(found.items())


def _faceless(cells: Sequence[str], header: Sequence[str]) -> bool:
    """Whether a row tells of no face: it counts no shapes, and has none."""
    counts = [cells[at] for at, name in enumerate(header[:2]) if name.strip().casefold() == COUNT and at < len(cells)]
    return bool(counts) and counts[0].strip() == "0" and not any(cell.strip() for cell in cells[2:])


def _code(text: str, line: int) -> tuple[float, float]:
    code = CODE.fullmatch(text)
    if code is None:
        raise NotATake(f"`{text[:40]}` is no time code such as `00:01:23:45.678`", line)
    hours, minutes, seconds, frames = code.groups()
    return int(hours) * 3600.0 + int(minutes) * 60.0 + int(seconds), float(frames)


def _times(codes: Codes, places: Sequence[int]) -> list[float]:
    """Seconds; a file that passes midnight goes on. Raises `NotATake` where time runs back."""
    rate = _rate(codes)
    times: list[float] = []
    days = 0.0
    for (seconds, frames), line in zip(codes, places, strict=True):
        time = seconds + frames / rate + days
        if times and time < times[-1] - DAY / 2:
            days += DAY
            time += DAY
        if times and time < times[-1] - 1e-9:
            raise NotATake("its time code comes before the one above it", line)
        times.append(time)
    return times


def _rate(codes: Codes) -> float:
    """Frames a second, from where frames begin to count anew."""
    pairs = list(pairwise(codes))
    steps = [after[1] - before[1] for before, after in pairs if after[0] == before[0] and after[1] > before[1]]
    turns = [before[1] - after[1] for before, after in pairs if after[0] == before[0] + 1.0]
    if not steps or not turns:
        return max(USUAL, *(frames + 1.0 for _, frames in codes)) if codes else USUAL
    return max(1.0, float(round(median(turns) + median(steps))))
