"""What an author may have meant: the nearest known name, as a clause for the message and as a fix."""

from __future__ import annotations

from collections.abc import Iterable

from facescript.diagnostics.model import Edit, Fix
from facescript.text import Span


def nearest(name: str, known: Iterable[str]) -> str | None:
    """The known name that is few slips away from `name` (a third of its letters at most), or None."""
    wanted = name.casefold()
    best, least = None, max(1, len(wanted) // 3) + 1
    for candidate in known:
        if abs(len(candidate) - len(wanted)) >= least or candidate == name:
            continue
        distance = slips(wanted, candidate.casefold(), least)
        if distance < least:
            best, least = candidate, distance
    return best


def slips(first: str, second: str, bound: int) -> int:
    """How many letters must be put in, left out, changed or swapped with their neighbour; `bound` if not fewer."""
    before: list[int] = []
    row = list(range(len(second) + 1))
    for index, letter in enumerate(first, 1):
        older, before = before, row
        row = [index]
        for place, other in enumerate(second, 1):
            cost = min(before[place] + 1, row[-1] + 1, before[place - 1] + (letter != other))
            if index > 1 < place and letter == second[place - 2] and other == first[index - 2]:
                cost = min(cost, older[place - 2] + 1)
            row.append(cost)
        if min(row) >= bound:
            return bound
    return row[-1]


def meant(name: str, known: Iterable[str], span: Span) -> tuple[str, tuple[Fix, ...]]:
    """A clause for the message ("; did you mean `smile`?" or a full stop) and the fix that goes with it."""
    candidate = nearest(name, known)
    if candidate is None:
        return ".", ()
    return f"; did you mean `{candidate}`?", (replace(span, candidate),)


def replace(span: Span, text: str) -> Fix:
    return Fix(f"write `{text}`", (Edit(span, text),))
