"""Offsets in a text to UTF-16 units, which browsers and editors count in, and back; places carried over an edit."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable
from difflib import SequenceMatcher

WIDE = 0xFFFF
"""Characters above this take two units."""

COMPARED = 2_000
"""Lines between the first and the last that changed, up to which the changes among them are told apart."""


class Units:
    """A text's places in UTF-16 units."""

    def __init__(self, text: str) -> None:
        self._length = len(text)
        self._wide = [] if text.isascii() else [place for place, sign in enumerate(text) if ord(sign) > WIDE]
        self._starts = [place + number for number, place in enumerate(self._wide)]

    def at(self, offset: int) -> int:
        """The units before an offset in characters."""
        return offset + bisect_left(self._wide, offset)

    def offset(self, units: int) -> int:
        """The offset in characters of a place in units; in the middle of a character, that before it."""
        found = units - bisect_right(self._starts, units - 1)
        if self._starts and units - 1 in self._starts:
            found = self._wide[bisect_left(self._starts, units - 1)]
        return min(max(found, 0), self._length)


def carried(before: str, after: str) -> Callable[[int], int | None]:
    """Where a place of the text `before` is in `after`; None for one in lines that are gone or are others."""
    blocks = list(_same(before.splitlines(keepends=True), after.splitlines(keepends=True)))
    starts = [first for first, _, _ in blocks]

    def carry(offset: int) -> int | None:
        number = bisect_right(starts, offset) - 1
        if number < 0:
            return None
        first, other, length = blocks[number]
        return other + offset - first if offset < first + length else None

    return carry


def _same(before: list[str], after: list[str]) -> list[tuple[int, int, int]]:
    """Stretches of lines that are the same in both texts: where they begin in each, and how long they are, in
    characters. A line that took another's place is taken for it as far as both begin alike."""
    shorter = min(len(before), len(after))
    head = next((n for n in range(shorter) if before[n] != after[n]), shorter)
    tail = next((n for n in range(shorter - head) if before[-1 - n] != after[-1 - n]), shorter - head)
    middle, other = before[head : len(before) - tail], after[head : len(after) - tail]
    pairs = [(n, n) for n in range(head)]
    if max(len(middle), len(other)) <= COMPARED:
        for kind, one, one_end, two, two_end in SequenceMatcher(None, middle, other, autojunk=False).get_opcodes():
            if kind in ("equal", "replace"):
                pairs += zip(range(head + one, head + one_end), range(head + two, head + two_end), strict=False)
    pairs += [(len(before) - tail + n, len(after) - tail + n) for n in range(tail)]
    lines, others = _starts(before), _starts(after)
    return [(lines[one], others[two], len(before[one])) for one, two in pairs]


def _starts(lines: list[str]) -> list[int]:
    found, at = [], 0
    for line in lines:
        found.append(at)
        at += len(line)
    return found
