"""A line's text to the stretches of it that a speaker says in one breath: sentences, and the clauses of long ones."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise

from facescript.ir.acts import Say, Stretch
from facescript.speech.lines import is_letter, is_unspaced

ENDS = re.compile(r"(?:[.!?…؟]+[\"'”’»)\]]*(?=\s|$)|[。！？।]+[”’」』）]*|\n\s*\n)")
CLAUSES = re.compile(r"[,;:–—،](?=\s)|[，；：、]")
SPACES = re.compile(r"\s+")

LONGEST = 180
"""Letters of a stretch; one that an unspaced script writes counts as `DENSE`: both say about 12 seconds."""

DENSE = 4


def sentences(line: Say) -> tuple[tuple[int, int], ...]:
    """First and last character of each stretch, in order, without gaps; each has a letter, if the text has one."""
    text = line.text
    pauses = sorted({mark.start for mark in line.stretches if mark.start == mark.end and mark.start < len(text)} - {0})
    cuts = _cut(text, list(pairwise([0, *pauses, len(text)])), ENDS, 0)
    for rule in (CLAUSES, SPACES):
        cuts = _cut(text, cuts, rule, LONGEST)
    return _with_letters(text, cuts)


def part_of(line: Say, first: int, last: int) -> Say:
    """The characters `first` to `last` of a line as a line of its own, with its marks; the recording has its own
    pauses."""
    marks = tuple(
        Stretch(mark.kind, max(mark.start, first) - first, min(mark.end, last) - first, mark.value)
        for mark in line.stretches
        if mark.start < mark.end and mark.start < last and mark.end > first
    )
    return replace(line, text=line.text[first:last], stretches=marks, cues=(), recording=None, times=None)


def _cut(text: str, spans: list[tuple[int, int]], rule: re.Pattern[str], longest: int) -> list[tuple[int, int]]:
    """The spans that are longer than `longest` cut behind what `rule` finds, no more often than they need it."""
    found: list[tuple[int, int]] = []
    for first, last in spans:
        start = first
        for match in rule.finditer(text, first, last):
            if not longest or _size(text[start : match.end()]) > longest / 2 < _size(text[start:last]) - longest / 2:
                found.append((start, match.end()))
                start = match.end()
        found.append((start, last))
    return found


def _size(text: str) -> int:
    return sum(DENSE if is_unspaced(sign) else 1 for sign in text if is_letter(sign))


def _with_letters(text: str, cuts: list[tuple[int, int]]) -> tuple[tuple[int, int], ...]:
    """The cuts, one without a letter together with its neighbour."""
    found: list[tuple[int, int]] = []
    for first, last in cuts:
        if found and not (any(map(is_letter, text[first:last])) and any(map(is_letter, text[slice(*found[-1])]))):
            found[-1] = (found[-1][0], last)
        else:
            found.append((first, last))
    return tuple(found)
