"""A spoken line to its text between quotes: stress, breaths, pauses, readings, marks, and statements in brackets."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from facescript.ir.acts import Say, Stretch
from facescript.ir.wording import unspaced
from facescript.writing.quotes import escaped

WIDEST = 90
"""Characters after which a text goes on in a further string."""


@dataclass(frozen=True, slots=True)
class Bracket:
    """A statement inside a text: what stands in its bracket, from the character `at` on; `[/]` at `until`."""

    text: str
    at: int
    until: int | None


def strings(line: Say, brackets: list[Bracket]) -> list[str]:
    """The strings of a line, without their quotes; none of a line that has no text."""
    if not line.text:
        return []
    signs = _signs(line, brackets)
    pieces, piece = [], ""
    for place, sign in enumerate((*line.text, "")):
        before, after = signs.get(place, ("", ""))
        piece += before
        if sign == " " and len(piece) > WIDEST and _parts(line.text, place):
            pieces.append(piece)
            piece = after
            continue
        piece += after + escaped(sign)
    return [*pieces, piece]


def _parts(text: str, place: int) -> bool:
    """Whether a space is read as one where a string ends in its place."""
    around = text[place - 1 : place], text[place + 1 : place + 2]
    return not all(sign and unspaced(sign) for sign in around)


def _signs(line: Say, brackets: list[Bracket]) -> dict[int, tuple[str, str]]:
    """By character: what stands before it and ends there, and what begins there."""
    ends: dict[int, list[tuple[int, str]]] = {}
    points: dict[int, list[str]] = {}
    opens: dict[int, list[tuple[int, str]]] = {}
    for start, end, opening, closing in _pairs(line, brackets):
        opens.setdefault(start, []).append((-end, opening))
        if closing:
            ends.setdefault(end, []).append((-start, closing))
    for stretch in line.stretches:
        if stretch.start == stretch.end:
            points.setdefault(stretch.start, []).append(_point(stretch))
    places = {*ends, *points, *opens}
    return {
        place: (
            "".join(sign for _, sign in sorted(ends.get(place, ()), key=lambda item: item[0]))
            + "".join(points.get(place, ())),
            "".join(sign for _, sign in sorted(opens.get(place, ()), key=lambda item: item[0])),
        )
        for place in places
    }


def _pairs(line: Say, brackets: list[Bracket]) -> Iterator[tuple[int, int, str, str]]:
    """Start, end, and the signs of all that has an end of its own."""
    for stretch in line.stretches:
        if stretch.kind == "stress":
            yield stretch.start, stretch.end, "*", "*"
        elif stretch.kind == "reading":
            yield stretch.start, stretch.end, f"[read {stretch.value}]", "[/]"
    for bracket in brackets:
        until = len(line.text) + 1 if bracket.until is None else bracket.until
        yield bracket.at, until, f"[{bracket.text}]", "" if bracket.until is None else "[/]"


def _point(stretch: Stretch) -> str:
    """What has no length: a breath, a pause, a mark."""
    if stretch.kind == "breath":
        return "|"
    return f"[wait {stretch.value}s]" if stretch.kind == "pause" else f"[mark {stretch.value}]"
