"""Diagnostics to what the page shows of them."""

from __future__ import annotations

from collections.abc import Iterable

from facescript.diagnostics.model import Diagnostic
from facescript.preview.places import Units
from facescript.text import Source
from facescript.web.messages import Message

MOST = 200
"""Diagnostics that are told; the first of them in the text."""


def told(diagnostics: Iterable[Diagnostic], source: Source, units: Units) -> list[Message]:
    """By their places in the script; what is said of another file, or of no place, comes first."""
    ordered = sorted(diagnostics, key=lambda item: _place(item, source))
    return [_told(item, source, units) for item in ordered[:MOST]]


def _place(item: Diagnostic, source: Source) -> int:
    return item.span.start if item.span is not None and item.span.source is source else -1


def _told(item: Diagnostic, source: Source, units: Units) -> Message:
    found: Message = {
        "code": item.code,
        "severity": str(item.severity),
        "message": item.message,
        "help": item.fixes[0].title if item.fixes else None,
    }
    if item.span is None:
        return found
    line, column = item.span.source.position(item.span.start)
    found |= {"file": item.span.source.name, "line": line, "column": column}
    if item.span.source is source:
        found |= {"start": units.at(item.span.start), "end": units.at(item.span.end)}
    return found
