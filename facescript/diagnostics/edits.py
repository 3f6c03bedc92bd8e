"""Fixes to one text: those that touch no other are chosen, and their edits made."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Iterable

from facescript.diagnostics.model import Edit, Fix


def fitting(fixes: Iterable[Fix]) -> list[Fix]:
    """The fixes of which no edit touches an edit of another; of two that do, the earlier one."""
    taken: list[tuple[int, int]] = []
    chosen = []
    for fix in fixes:
        places = [(edit.span.start, edit.span.end) for edit in fix.edits]
        if places and not any(_touches(taken, place) for place in places):
            chosen.append(fix)
            for place in places:
                insort(taken, place)
    return chosen


def _touches(taken: list[tuple[int, int]], place: tuple[int, int]) -> bool:
    """Whether a place touches one of those that are taken, which stand in order and apart."""
    index = bisect_left(taken, place)
    return any(other[0] <= place[1] and place[0] <= other[1] for other in taken[max(0, index - 1) : index + 1])


def edited(text: str, edits: Iterable[Edit]) -> str:
    """A text with edits made, none of which touches another."""
    parts: list[str] = []
    place = 0
    for edit in sorted(edits, key=lambda edit: edit.span.start):
        parts += text[place : edit.span.start], edit.text
        place = edit.span.end
    return "".join(parts) + text[place:]
