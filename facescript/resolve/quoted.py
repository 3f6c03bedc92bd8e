"""A text in quotes, as a line has it, or a name or a cell of a table that stands for one."""

from __future__ import annotations

from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader
from facescript.resolve.scope import expand, inside
from facescript.resolve.sums import left_over
from facescript.resolve.texts import bare_text
from facescript.syntax.tree import Dotted, Name, String
from facescript.text import Span


def quoted_text(project: Project, reader: Reader, advice: str) -> tuple[str, Span]:
    """A text in quotes, or the one that a name or a cell stands for, and where it is written. Raises `Refused`."""
    word = reader.next()
    if isinstance(word, String):
        return bare_text(word), word.span
    expansion = expand(project, word, reader.scope) if isinstance(word, Name | Dotted) else None
    if word is None or expansion is None:
        raise _no_text(project, word.span if word is not None else reader.span, advice)
    if expansion.cell is not None:
        return expansion.cell.text.strip(), word.span
    with inside(project, expansion, word.span):
        inner = Reader(expansion.words, expansion.scope, word.span)
        found = quoted_text(project, inner, advice)
        left_over(project, inner)
        return found[0], word.span


def _no_text(project: Project, span: Span, advice: str) -> Refused:
    return project.refuse("FS312", span, text=span.text, advice=advice)
