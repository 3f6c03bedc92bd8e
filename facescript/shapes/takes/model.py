"""Rows of numbers by time to a take, and what is said of a file that is none."""

from __future__ import annotations

import base64
import sys
from array import array
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import isfinite
from statistics import median
from typing import Literal

from facescript.ir.acts import Take

MOST_FRAMES = 36_000
"""Rows of a take: ten minutes at 60 a second."""

LONGEST = 3600.0
"""Seconds that a take lasts at most."""


class NotATake(ValueError):
    """A file that cannot be played; `args[0]` is a clause for the author, `line` is from 1, 0 where it is the file."""

    def __init__(self, reason: str, line: int = 0) -> None:
        super().__init__(reason)
        self.line = line


@dataclass(frozen=True, slots=True)
class Found:
    """What a file holds: a take, and in how many of its rows there is no face (what is before and after is joined)."""

    take: Take
    lost: int = 0


def number(text: str, line: int, column: str, most: float) -> float:
    """A finite number of a file, `most` either way. Raises `NotATake`."""
    try:
        value = float(text if "_" not in text else "")
    except ValueError:
        raise NotATake(f"`{text[:40]}` in the column `{column}` is no number", line) from None
    if not isfinite(value):
        raise NotATake(f"`{text[:40]}` in the column `{column}` is no finite number", line)
    if abs(value) > most:
        raise NotATake(f"`{text[:40]}` in the column `{column}` is beyond {most:g}", line)
    return value


def counted(rows: int, line: int) -> None:
    """Refuses a row too many. Raises `NotATake`."""
    if rows >= MOST_FRAMES:
        raise NotATake(f"it has more than {MOST_FRAMES} rows; take a part of it", line)


def take(
    path: str,
    kind: Literal["arkit", "fap", "channels"],
    columns: tuple[str, ...],
    times: Sequence[float],
    rows: Sequence[Sequence[float]],
    step: float | None = None,
) -> Take:
    """The take of rows at rising times (s). Each lasts until the next, the last one a `step`: where none is given, as
    long as rows usually do. Raises `NotATake`."""
    if not rows:
        raise NotATake("it has no rows of a face")
    if step is None:
        step = median(after - before for before, after in pairwise(times)) if len(times) > 1 else 0.0
    duration = times[-1] - times[0] + step
    if not 0.0 < duration <= LONGEST:
        raise NotATake("it is a single moment" if duration <= 0.0 else f"it lasts longer than {LONGEST / 60:g} minutes")
    data = array("f")
    for time, row in zip(times, rows, strict=True):
        data.append(time - times[0])
        data.extend(row)
    if sys.byteorder == "big":
        data.byteswap()
    return Take(path, kind, columns, len(rows), round(duration, 6), base64.b64encode(data.tobytes()).decode("ascii"))
