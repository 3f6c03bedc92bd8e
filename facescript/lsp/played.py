"""A score to when each statement of a document is played: by where it stands in the text."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeVar

from facescript.lsp.desk import Analysis
from facescript.schedule.score import TimedAct, TimedBlock, TimedLine
from facescript.text import Source

Timed = TypeVar("Timed", TimedAct, TimedLine, TimedBlock)

Place = tuple[int, int]
"""Start and end of a statement in the document."""


@dataclass(frozen=True, slots=True)
class Played:
    """The plays of the statements of a stretch of the document, each list by time: what is done, lines of speech, and
    calls of actions."""

    acts: dict[Place, list[TimedAct]]
    lines: dict[Place, list[TimedLine]]
    calls: dict[Place, list[TimedBlock]]


def played(analysis: Analysis, start: int, end: int) -> Played | None:
    """What stands between two offsets, as it is played; None where nothing is solved."""
    score = analysis.compiled.score
    if score is None:
        return None
    source = analysis.source
    return Played(
        _within(source, start, end, score.acts),
        _within(source, start, end, score.lines),
        _within(source, start, end, score.blocks),
    )


def _within(source: Source, start: int, end: int, timed: Iterable[Timed]) -> dict[Place, list[Timed]]:
    found: dict[Place, list[Timed]] = {}
    for one in timed:
        span = one.span
        if span.source is source and span.start <= end and span.end >= start:
            found.setdefault((span.start, span.end), []).append(one)
    return found
