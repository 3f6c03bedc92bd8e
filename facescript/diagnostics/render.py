"""A diagnostic to lines for a terminal, with the place in the script marked, or to a record for JSON."""

from __future__ import annotations

import re
from typing import Any

from facescript.diagnostics.columns import columns
from facescript.diagnostics.model import Diagnostic, Edit, Fix, Severity
from facescript.text import Span

WIDEST = 100
"""Signs of a source line that are shown; of a longer one a piece around the place is."""

LONGEST_MESSAGE = 1000
MOST_RELATED = 10

_COLOURS = {Severity.ERROR: "\x1b[1;31m", Severity.WARNING: "\x1b[1;33m", Severity.HINT: "\x1b[1;36m"}
_BOLD, _DIM, _PLAIN = "\x1b[1m", "\x1b[2m", "\x1b[0m"
_UNDRAWN = re.compile("[\x00-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff\ud800-\udfff]")


def render(diagnostic: Diagnostic, colour: bool) -> str:
    """The code and the sentence, the line with carets below the exact place, fixes, and related places.

    Nothing from a script reaches the terminal that could steer it, and no line is long.
    """
    paint = _COLOURS[diagnostic.severity]
    head = f"{diagnostic.severity} {diagnostic.code}: {_BOLD if colour else ''}{_safe(diagnostic.message)}"
    rows = [f"{paint}{head}{_PLAIN}" if colour else head]
    if diagnostic.span:
        rows += _excerpt(diagnostic.span, "^", paint if colour else "")
    rows += [f"  = fix: {_safe(fix.title)}" for fix in diagnostic.fixes]
    for related in diagnostic.related[:MOST_RELATED]:
        rows.append(f"  = {_safe(related.message)}")
        rows += _excerpt(related.span, "-", _DIM if colour else "")
    if len(diagnostic.related) > MOST_RELATED:
        rows.append(f"  = and {len(diagnostic.related) - MOST_RELATED} more places")
    return "\n".join(rows)


def as_json(diagnostic: Diagnostic) -> dict[str, Any]:
    """The record that `--json` prints. Lines and columns count from 1, the end is behind the last sign.

    A diagnostic without a place has None for its file, lines and columns. `edits` of a fix go from the last place to
    the first, so that each leaves the places of those after it as they are; a fix without edits is advice. `related`
    are further places that matter, such as an earlier definition.
    """
    place = _place(diagnostic.span) if diagnostic.span else dict.fromkeys(("file", *_BORDERS))
    fixes = [{"title": fix.title, "edits": [_edit(edit) for edit in _backwards(fix)]} for fix in diagnostic.fixes]
    return {
        "code": diagnostic.code,
        "severity": str(diagnostic.severity),
        **place,
        "message": diagnostic.message,
        "fixes": fixes,
        "related": [{**_place(other.span), "message": other.message} for other in diagnostic.related],
    }


_BORDERS = ("line", "column", "end_line", "end_column")


def _place(span: Span) -> dict[str, Any]:
    borders = (*span.source.position(span.start), *span.source.position(span.end))
    return {"file": span.source.name, **dict(zip(_BORDERS, borders, strict=True))}


def _backwards(fix: Fix) -> list[Edit]:
    return sorted(fix.edits, key=lambda edit: (edit.span.source.name, edit.span.start, edit.span.end), reverse=True)


def _edit(edit: Edit) -> dict[str, Any]:
    return {**_place(edit.span), "text": edit.text}


def _excerpt(span: Span, sign: str, paint: str) -> list[str]:
    """The file, line and column, and the line with its first stretch of the span marked."""
    number, column = span.source.position(span.start)
    line = span.source.line(number)
    first = column - 1
    last = max(first, min(first + span.end - span.start, len(line)))
    before, marked, after = _window(line, first, last)
    margin = " " * len(str(number))
    carets = " " * columns(before) + sign * max(1, columns(marked))
    return [
        f"{margin}--> {_safe(span.source.name)}:{number}:{column}",
        f"{margin} |",
        f"{number} | {before}{marked}{after}",
        f"{margin} | {paint}{carets}{_PLAIN if paint else ''}",
    ]


def _window(line: str, first: int, last: int) -> tuple[str, str, str]:
    """The line before, in and after first..last, cut to `WIDEST` signs around the place."""
    start = 0 if len(line) <= WIDEST else max(0, min(first - WIDEST // 4, len(line) - WIDEST))
    end = min(len(line), start + WIDEST)
    last = min(last, end)
    head = "…" if start else ""
    tail = "…" if end < len(line) else ""
    return head + _drawn(line[start:first]), _drawn(line[first:last]), _drawn(line[last:end]) + tail


def _drawn(text: str) -> str:
    """Source text as it is shown: a tab as four columns, what is not drawn as one sign."""
    return _UNDRAWN.sub("\N{REPLACEMENT CHARACTER}", text.replace("\t", "    "))


def _safe(text: str) -> str:
    """A message without what could steer a terminal, and of bounded length."""
    short = text if len(text) <= LONGEST_MESSAGE else text[:LONGEST_MESSAGE] + "…"
    return _UNDRAWN.sub("\N{REPLACEMENT CHARACTER}", short)
