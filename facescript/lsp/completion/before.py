"""A text and a place in it to what stands before the place: its line as tokens, half-written or not, and its blocks.

The compiler's tree says nothing of the line that is being written; this reads it with the compiler's own lexer.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from facescript.syntax.faults import Faults
from facescript.syntax.lexer import GOES_ON, LARGEST, LONGEST_LINE, lex_piece
from facescript.syntax.spacing import Token
from facescript.text import Source

MOST_ROWS = 50
"""Physical lines that one line is read back over."""

_PIECES = re.compile(r'"(?:\\.|[^"\\])*+"|#(?=[ \t])|"')
_WORD = re.compile(r"\w[\w.%/-]*$|#\w*$")
LONGEST_WORD = 200


@dataclass(frozen=True, slots=True)
class Before:
    """What stands before a place.

    `tokens` are those of the statement at hand, without the word that is being written, which begins at `start`;
    `heads` are those before each colon on the line; `openers` those of the lines whose blocks it stands in, the
    innermost first. In a text `text` is what stands in it so far, `label` the name whose dot the text follows, and
    `cue` whether the statement at hand stands in brackets in it.
    """

    source: Source
    place: int
    start: int
    indent: int
    tokens: tuple[Token, ...]
    heads: tuple[tuple[Token, ...], ...]
    openers: tuple[tuple[Token, ...], ...]
    text: str | None = None
    label: str = ""
    cue: bool = False

    @property
    def word(self) -> str:
        return self.source.text[self.start : self.place]

    @property
    def words(self) -> tuple[str, ...]:
        return tuple(token[1] for token in self.tokens)


def before(source: Source, place: int) -> Before | None:
    """What stands before an offset; None in a comment, and where a text is too large to be read."""
    number, column = source.position(place)
    row = source.text[place - column + 1 : place]
    if len(source.text) > LARGEST or len(row) > LONGEST_LINE:
        return None
    quote, comment = _open(row)
    if comment:
        return None
    first, earlier = _earlier(source, number)
    begin = place - len(row)
    cut = _word_start(row) if quote is None else quote
    tokens = [*earlier, *lexed(source, begin, row[:cut])]
    indent = _indent(source.line(first) if first < number else row)
    heads, rest = _cut(tokens)
    found = Before(source, place, begin + cut, indent, rest, heads, _openers(source, first, indent))
    return found if quote is None else _in_text(found, row, quote)


def lexed(source: Source, begin: int, text: str) -> list[Token]:
    """The tokens of a piece of a line; what cannot be read is left out."""
    bare = text.lstrip()
    return lex_piece(bare.rstrip(), begin + len(text) - len(bare), Faults(source)).tokens if bare else []


def _open(row: str) -> tuple[int | None, bool]:
    """Where a text begins that is still open, and whether a comment has begun."""
    for match in _PIECES.finditer(row):
        if match.group() == '"':
            return match.start(), False
        if match.group() == "#":
            return None, True
    return None, False


def _word_start(row: str) -> int:
    match = _WORD.search(row, max(0, len(row) - LONGEST_WORD))
    return match.start() if match else len(row)


def _earlier(source: Source, number: int) -> tuple[int, list[Token]]:
    """The number of the physical line in which a line begins, and its tokens before the physical line `number`."""
    tokens: list[Token] = []
    while number > 1 and len(tokens) < LONGEST_LINE:
        text = source.line(number - 1)
        if not any(sign in text for sign in GOES_ON) or len(text) > LONGEST_LINE:
            break
        above = lexed(source, source.offset(number - 1) or 0, text)
        if not above or above[-1][1] not in GOES_ON:
            break
        tokens = above + tokens
        number -= 1
    return number, tokens


def _cut(tokens: list[Token]) -> tuple[tuple[tuple[Token, ...], ...], tuple[Token, ...]]:
    """The tokens before each colon, and those behind the last."""
    parts: list[list[Token]] = [[]]
    for token in tokens:
        if token[0] == "COLON":
            parts.append([])
        else:
            parts[-1].append(token)
    return tuple(map(tuple, parts[:-1])), tuple(parts[-1])


def _indent(text: str) -> int:
    return len(text) - len(text.lstrip(" "))


def _openers(source: Source, number: int, indent: int) -> tuple[tuple[Token, ...], ...]:
    """The lines above that stand further to the left each than those below them."""
    found = []
    for above in range(number - 1, 0, -1):
        if indent == 0:
            break
        text = source.line(above)
        bare = text.strip()
        if not bare or bare.startswith("# ") or _indent(text) >= indent or len(text) > LONGEST_LINE:
            continue
        indent = _indent(text)
        found.append(tuple(lexed(source, source.offset(above) or 0, text)))
    return tuple(found)


def _in_text(found: Before, row: str, quote: int) -> Before:
    """The same inside a text that begins at `quote` of its row: in its brackets, or at its words."""
    text = row[quote + 1 :]
    begin = found.place - len(text)
    named = re.search(r"([\w-]+)\.$", row[:quote])
    bracket = text.rfind("[")
    if named:
        start = begin - 1 - len(named[0])
        tokens = tuple(token for token in found.tokens if token[2] < start)
        return replace(found, start=start, tokens=tokens, text=text, label=named[1])
    if bracket > text.rfind("]") and found.words[:1] == ("say",):
        piece, at = text[bracket + 1 :], begin + bracket + 1
        cut = _word_start(piece)
        return replace(found, start=at + cut, tokens=tuple(lexed(found.source, at, piece[:cut])), cue=True)
    return replace(found, start=begin, text=text)
