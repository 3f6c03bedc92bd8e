"""A line's words to where they are written."""

from __future__ import annotations

import re
from itertools import chain

from facescript.ir.wording import find
from facescript.syntax.tree import Act, String
from facescript.text import Span

_SILENT = re.compile(r"\[[^\[\]]*\]|\\|[*|]")
"""What stands in a text and is not spoken: brackets and signs."""


def word_span(act: Act, word: str, nth: int) -> Span | None:
    """Where the `nth` `word` of a line is written; None where its text stands elsewhere, or has no such word."""
    strings = [part for part in chain(act.phrases[0].words, act.more) if isinstance(part, String)]
    if not strings:
        return None
    source, start = strings[0].span.source, strings[0].span.start
    written = "".join(_bare(string, before) for before, string in zip([None, *strings], strings, strict=False))
    found = find(written, word, nth)
    return Span(source, start + found[0], start + found[1]) if found is not None else None


def _bare(string: String, before: String | None) -> str:
    """The text of a string, what is not spoken blank, behind blanks for all since the string before it."""
    gap = string.span.start - before.span.end if before is not None else 0
    return " " * (gap + 1) + _SILENT.sub(lambda match: " " * len(match[0]), string.value) + " "
