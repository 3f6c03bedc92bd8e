"""Two rows of words to the pairs that are the same word in both: exact where they are short, by rare words in a row
where they are long."""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Sequence
from itertools import pairwise

Pairs = list[tuple[int, int]]

MOST_CELLS = 400_000
"""Pairs of words that are weighed against each other one by one."""


def matches(first: Sequence[str], second: Sequence[str]) -> Pairs:
    """The numbers of equal words, in order in both: a longest common row, or nearly so for long texts."""
    found: Pairs = []
    waiting = [(0, len(first), 0, len(second))]
    while waiting:
        a, b, c, d = waiting.pop()
        while a < b and c < d and first[a] == second[c]:
            found.append((a, c))
            a, c = a + 1, c + 1
        while a < b and c < d and first[b - 1] == second[d - 1]:
            b, d = b - 1, d - 1
            found.append((b, d))
        if a == b or c == d:
            continue
        if (b - a) * (d - c) <= MOST_CELLS:
            found += [(a + i, c + j) for i, j in _longest(first[a:b], second[c:d])]
        else:
            anchors = [(a + i, c + j) for i, j in _anchors(first[a:b], second[c:d])]
            found += anchors
            if anchors:
                waiting += [(i + 1, k, j + 1, n) for (i, j), (k, n) in pairwise([(a - 1, c - 1), *anchors, (b, d)])]
            else:
                waiting += [(a, (a + b) // 2, c, (c + d) // 2), ((a + b) // 2, b, (c + d) // 2, d)]
    return sorted(found)


def _longest(first: Sequence[str], second: Sequence[str]) -> Pairs:
    """A longest common row, by dynamic programming."""
    width = len(second) + 1
    rows = [[0] * width]
    for word in reversed(first):
        below, row = rows[-1], [0] * width
        for at in range(width - 2, -1, -1):
            row[at] = below[at + 1] + 1 if word == second[at] else max(below[at], row[at + 1])
        rows.append(row)
    rows.reverse()
    pairs, i, j = [], 0, 0
    while i < len(first) and j < len(second):
        if first[i] == second[j]:
            pairs.append((i, j))
            i, j = i + 1, j + 1
        elif rows[i + 1][j] >= rows[i][j + 1]:
            i += 1
        else:
            j += 1
    return pairs


def _anchors(first: Sequence[str], second: Sequence[str]) -> Pairs:
    """Words that with their neighbours stand once in either row, the longest row of them in order in both."""
    here, there = _once(first), _once(second)
    shared = sorted((here[key], there[key]) for key in here.keys() & there.keys())
    return _rising(shared)


def _once(row: Sequence[str]) -> dict[tuple[str, ...], int]:
    padded = ["", *row, ""]
    keys = [tuple(padded[at : at + 3]) for at in range(len(row))]
    counts = Counter(keys)
    return {key: at for at, key in enumerate(keys) if counts[key] == 1}


def _rising(pairs: Pairs) -> Pairs:
    """The most pairs of which the second numbers rise with the first."""
    tops: list[int] = []
    ends: list[int] = []
    before: list[int] = []
    for number, (_, value) in enumerate(pairs):
        at = bisect_left(tops, value)
        before.append(ends[at - 1] if at else -1)
        tops[at : at + 1] = [value]
        ends[at : at + 1] = [number]
    kept: Pairs = []
    number = ends[-1] if ends else -1
    while number >= 0:
        kept.append(pairs[number])
        number = before[number]
    return kept[::-1]
