"""A text file of MPEG-4's facial animation parameters (`.fap`) to a take.

Files of several programs are read: a name with blanks, masks of 69, blanks at the ends of lines. FAP 1 and 2 have a
single value there. A parameter that a frame's mask leaves out stays as it was.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from facescript.shapes.rows import rows as table
from facescript.shapes.takes.model import MOST_FRAMES, Found, NotATake, counted, take

HEAD = re.compile(r"\s*\d+(?:\.\d+)*\s+(?:\S.*\s)?\s*(\d{1,4})\s+(\d{1,9})\s*")
"""Version, name, frames a second, frames."""

LONGEST_HEAD = 1000
"""Characters of a first line: in a longer one the name's end is not sought."""

FAPS = 68
MOST_RATE = 1000
MOST = 1_000_000
"""The greatest value: a turn of ten radians."""

Lines = Iterator[tuple[int, str]]


def is_fap(line: str) -> bool:
    """Whether a first line is one of such a file."""
    return len(line) <= LONGEST_HEAD and HEAD.fullmatch(line) is not None


def read_fap(path: str, first: str, lines: Lines) -> Found:
    """The take of a file: `lines` are the others with their numbers, blank ones left out. Raises `NotATake`."""
    rate, frames = _head(first)
    held = [0] * FAPS
    seen = [False] * FAPS
    rows: list[list[int]] = []
    while len(rows) < frames:
        counted(len(rows), 0)
        _frame(len(rows), frames, lines, held, seen)
        rows.append(list(held))
    more = next(lines, None)
    if more is not None:
        raise NotATake(f"there is more behind its {frames} frames", more[0])
    names = [row["name"] for row in table("fap")]
    told = [at for at in range(FAPS) if seen[at]]
    if not told:
        raise NotATake("no mask of it has a parameter")
    values = [[float(row[at]) for at in told] for row in rows]
    times = [number / rate for number in range(frames)]
    return Found(take(path, "fap", tuple(names[at] for at in told), times, values, 1 / rate))


def _head(line: str) -> tuple[int, int]:
    found = HEAD.fullmatch(line)
    assert found is not None
    rate, frames = int(found[1]), int(found[2])
    if not 1 <= rate <= MOST_RATE:
        raise NotATake(f"{rate} frames a second are not within 1 and {MOST_RATE}", 1)
    if not 1 <= frames <= MOST_FRAMES:
        raise NotATake(f"it says that it has {frames} frames; 1 to {MOST_FRAMES} can be played", 1)
    return rate, frames


def _frame(number: int, frames: int, lines: Lines, held: list[int], seen: list[bool]) -> None:
    """Read a frame's mask and values into what is `held`, and note which are `seen`."""
    at, mask = next(lines, (0, ""))
    if not at:
        raise NotATake(f"it ends after {number} of its {frames} frames")
    flags = mask.split()
    if len(flags) not in (FAPS, FAPS + 1) or any(flag not in ("0", "1") for flag in flags):
        raise NotATake(f"a mask is {FAPS} times 0 or 1", at)
    line, text = next(lines, (at, ""))
    told = [index for index, flag in enumerate(flags[:FAPS]) if flag == "1"]
    values = text.split()
    if len(values) != len(told) + 1:
        raise NotATake(
            f"behind its number a frame has {len(told)} values, as its mask says; here are {max(len(values) - 1, 0)}",
            line,
        )
    for index, value in zip(told, values[1:], strict=True):
        held[index], seen[index] = _whole(value, line), True


def _whole(text: str, line: int) -> int:
    try:
        value = int(text if "_" not in text else "")
    except ValueError:
        raise NotATake(f"`{text[:40]}` is no whole number", line) from None
    if abs(value) > MOST:
        raise NotATake(f"`{text[:40]}` is beyond {MOST}", line)
    return value
