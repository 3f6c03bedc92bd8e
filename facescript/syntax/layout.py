"""A script without errors to its text in the one layout; the rules stand in `formatter.py`."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise, takewhile

from facescript.diagnostics.columns import columns
from facescript.syntax.blocks import cut
from facescript.syntax.faults import Faults
from facescript.syntax.lexer import HARD, Line, lex
from facescript.syntax.spacing import Token
from facescript.syntax.table import table
from facescript.text import Source

INDENT = 4
WIDEST = 100
"""Columns of a line, unless it cannot be broken."""

_CLOSE = frozenset(("COMMA", "COLON", "RPAR", "_OPEN", "NTH"))
_OPEN = frozenset(("LPAR", "_OPEN"))


@dataclass(slots=True)
class Row:
    """A physical line of the layout; both texts empty: a blank one."""

    indent: int
    text: str
    comment: str = ""

    @property
    def blank(self) -> bool:
        return not self.text and not self.comment

    @property
    def width(self) -> int:
        return self.indent + columns(self.text)


def lay_out(source: Source) -> str:
    """The text of a source that parses without errors."""
    faults = Faults(source)
    lexed = lex(source, faults)
    lines = [line for block in cut(lexed.lines, faults) for line in block]
    rows = _Rows(source, lines, lexed.comments).make()
    _align_comments(rows)
    return "".join(_drawn(row) + "\n" for row in rows)


class _Rows:
    """Walks the physical lines of a source. `parts` are the tokens in each, with the index of their line."""

    def __init__(self, source: Source, lines: list[Line], comments: list[tuple[int, int]]) -> None:
        self.source, self.lines = source, lines
        self.comments = {source.position(start)[0]: (start, end) for start, end in comments}
        self.parts: dict[int, tuple[int, list[Token]]] = {}
        for index, line in enumerate(lines):
            for token in line.tokens:
                self.parts.setdefault(source.position(token[2])[0], (index, []))[1].append(token)
        self.cells = _cells(lines)
        self.rows: list[Row] = []
        self.waiting: list[tuple[Row, int]] = []
        self.current = -1
        self.margins: list[int] = []

    def make(self) -> list[Row]:
        for number in range(1, self.source.text.count("\n") + 2):
            if number in self.parts:
                self._part(number)
            elif number in self.comments:
                self._own_comment(number)
            elif self.rows and not self.rows[-1].blank:
                self.rows.append(Row(0, ""))
        self._place_comments(len(self.lines))
        if self.rows and self.rows[-1].blank:
            self.rows.pop()
        return self.rows

    def _part(self, number: int) -> None:
        """A physical line with words in it, in more rows if it is too long."""
        index, tokens = self.parts[number]
        self._place_comments(index)
        line = self.lines[index]
        more = self._indent(index) + self._further(index)
        first = more if index == self.current else self._indent(index)
        self.current = index
        self.margins[line.level :] = [line.indent]
        pieces = [self.cells[index]] if index in self.cells else _pieces(tokens, first, more)
        self.rows += [Row(first if count == 0 else more, piece) for count, piece in enumerate(pieces)]
        self.rows[-1].comment = self._comment(number)

    def _own_comment(self, number: int) -> None:
        row = Row(0, "", self._comment(number))
        self.rows.append(row)
        self.waiting.append((row, self.source.position(self.comments[number][0])[1] - 1))

    def _comment(self, number: int) -> str:
        start, end = self.comments.get(number, (0, 0))
        return self.source.text[start:end]

    def _place_comments(self, index: int) -> None:
        """Indent the comments that wait for the line that follows them."""
        for row, margin in self.waiting:
            if index == self.current:
                row.indent = self._indent(index) + self._further(index)
            else:
                row.indent = INDENT * self._level(margin, index)
        self.waiting = []

    def _level(self, margin: int, index: int) -> int:
        """The level of a comment: of the line below, or of a block ending here that it is indented for."""
        below = self.lines[index].level if index < len(self.lines) else 0
        ending = [level for level in range(below + 1, len(self.margins)) if self.margins[level] <= margin]
        return max(ending, default=below)

    def _indent(self, index: int) -> int:
        return INDENT * self.lines[index].level

    def _further(self, index: int) -> int:
        """By how much the rows of a line after its first are indented more."""
        below = self.lines[index + 1].level if index + 1 < len(self.lines) else 0
        return INDENT * (2 if below > self.lines[index].level else 1)


def _pieces(tokens: list[Token], first: int, more: int) -> list[str]:
    """The text of some tokens, broken where it is too long; `first` and `more` are the indentations of its rows."""
    pieces: list[str] = []
    begin = 0
    width, breaks = first, 0
    for index, token in enumerate(tokens):
        width += columns(_gap(tokens[index - 1], token) + token[1]) if index > begin else columns(token[1])
        if width > WIDEST and breaks > begin:
            pieces.append(_text(tokens[begin:breaks]))
            begin = breaks
            width = more + columns(_text(tokens[begin : index + 1]))
        if _breakable(tokens, index):
            breaks = index + 1
    return [*pieces, _text(tokens[begin:])]


def _breakable(tokens: list[Token], index: int) -> bool:
    """Whether a line may be broken after a token: it then goes on, and the next word begins nothing new."""
    after = tokens[index + 1] if index + 1 < len(tokens) else None
    return tokens[index][1] in (",", "+") and after is not None and table().keywords.get(after[1]) not in HARD


def _text(tokens: list[Token]) -> str:
    parts = [tokens[0][1]]
    for before, token in pairwise(tokens):
        parts += _gap(before, token), token[1]
    return "".join(parts)


def _gap(before: Token, token: Token) -> str:
    return "" if token[0] in _CLOSE or before[0] in _OPEN else " "


# ------------------------------------------------------------------------------------------------ columns


def _cells(lines: list[Line]) -> dict[int, str]:
    """The positions of moving targets by the index of their line: times to the left, the rest to the right."""
    cells: dict[int, str] = {}
    for index, line in enumerate(lines):
        if line.tokens[0][0] == "TARGET":
            below = list(takewhile(lambda number: lines[number].level > 0, range(index + 1, len(lines))))
            if below and all(_plain(lines[number], lines[below[0]]) for number in below):
                cells.update(zip(below, _columns([lines[number].tokens for number in below]), strict=True))
    return cells


def _plain(line: Line, first: Line) -> bool:
    """Whether a line has as many words as another and nothing but quantities and names."""
    return len(line.tokens) == len(first.tokens) and all(token[0] in ("QUANTITY", "NAME") for token in line.tokens)


def _columns(rows: list[list[Token]]) -> list[str]:
    widths = [max(columns(row[place][1]) for row in rows) for place in range(len(rows[0]))]
    texts = []
    for row in rows:
        words = [token[1] for token in row]
        padding = [" " * (width - columns(word)) for word, width in zip(words, widths, strict=True)]
        cells = [words[0] + padding[0], *(pad + word for pad, word in zip(padding[1:], words[1:], strict=True))]
        texts.append(" ".join(cells).rstrip())
    return texts


def _align_comments(rows: list[Row]) -> None:
    """Set the column of comments behind lines: below each other in rows that follow each other."""
    run: list[Row] = []
    for row in [*rows, Row(0, "")]:
        if row.text and row.comment:
            run.append(row)
        elif run:
            place = max(row.width for row in run) + 2
            for member in run:
                member.text += " " * (place - member.width)
            run = []


def _drawn(row: Row) -> str:
    return "" if row.blank else " " * row.indent + row.text + row.comment
