"""A script to the one layout: commas set by the tree (`commas.py`), then the text laid out (`layout.py`)."""

from __future__ import annotations

from facescript.diagnostics.edits import edited, fitting
from facescript.diagnostics.model import Severity
from facescript.syntax.faults import MOST, Faults
from facescript.syntax.layout import lay_out
from facescript.syntax.parser import read
from facescript.text import Source

ROUNDS = 20
"""How often commas are set; a round sets all whose places do not overlap, so that two or three do."""


def format_source(source: Source) -> str:
    """The text in the one layout; unchanged where it has errors. The layout of a layout is itself.

    - Four spaces for each block; a line that goes on is indented by four more, by eight where a block stands below it.
    - One space between words, around `=` and operators and after `,` and `:`; none inside brackets.
    - Direct modifiers without a comma, others with one, `as` last.
    - Lines stay broken where their author broke them; one of more than 100 columns is broken after a comma or `+`.
    - One blank line at most, none at the start and the end of the file.
    - A comment stands with the line below it, or in the block it was indented for; comments at the ends of lines in a
      row stand below each other. Positions of a moving target stand in columns.
    """
    text, most = source.text, MOST
    for _ in range(ROUNDS):
        current = Source(source.name, text)
        faults = Faults(current, most)
        read(current, faults)
        if any(item.severity is Severity.ERROR for item in faults.items):
            return source.text
        most = len(text)
        fixes = fitting(fix for hint in faults.items for fix in hint.fixes)
        if not fixes:
            break
        text = edited(text, (edit for fix in fixes for edit in fix.edits))
    return lay_out(Source(source.name, text))
