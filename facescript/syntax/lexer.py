"""Text to lines of tokens: indentation, comments and line ends settled, what is no sign of the language reported."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cache

from facescript.syntax import signs, spacing
from facescript.syntax.faults import Faults
from facescript.syntax.signs import HIDDEN, KINDS, Odd
from facescript.syntax.spacing import Token
from facescript.syntax.table import table
from facescript.text import Source

LONGEST_LINE = 10_000
"""Characters of a physical line."""

LARGEST = 4 * 1024 * 1024
"""Characters of a script."""

TAB_WIDTH = 4

BLANKS = " \t" + "".join(sign for sign, meant in signs.MEANT.items() if meant == " ")
"""What authors indent with."""

HARD = frozenset("EXPRESSION ACTION LET FACE TARGET FILM EVENT USE SCENE WHEN REPEAT ON TOGETHER CHOOSE".split())
"""Keywords that always begin something new where a line begins with them."""

GOES_ON = frozenset((",", "+", "="))
"""A line that ends in one of these goes on in the next."""


@dataclass(slots=True)
class Line:
    """What the author wrote as one line, over as many physical lines as it goes on.

    `indent` is its columns, `level` the number of blocks it stands in (`blocks.py` sets it). `faulty`: something in it
    has been reported. `spoilt`: it cannot be read, `tokens` may lack some.
    """

    indent: int
    tokens: list[Token]
    begin: int
    faulty: bool = False
    spoilt: bool = False
    level: int = 0

    @property
    def end(self) -> int:
        return self.tokens[-1][3] if self.tokens else self.begin


@dataclass(slots=True)
class Lexed:
    """The lines of a source, and its comments as (start, end); `open` is whether the last line would go on."""

    lines: list[Line] = field(default_factory=list)
    comments: list[tuple[int, int]] = field(default_factory=list)
    open: bool = False


def lex(source: Source, faults: Faults) -> Lexed:
    """All lines of a source that hold more than a comment."""
    if len(source.text) > LARGEST:
        faults.add("FS117", 0, 0, largest=LARGEST)
        return Lexed()
    return _Lexer(source.text, faults).run()


def lex_piece(text: str, begin: int, faults: Faults) -> Line:
    """One line that stands inside another text, at offset `begin` of its place: a cue."""
    lexer = _Lexer(text, faults)
    line = Line(0, [], begin)
    line.tokens = lexer.read(text, begin, line, fresh=False)
    return line


@cache
def _pattern() -> re.Pattern[str]:
    return re.compile(f" *+(?:{table().pattern}|{signs.PATTERN})")


class _Lexer:
    def __init__(self, text: str, faults: Faults) -> None:
        self.text, self.faults = text, faults
        self.lexed = Lexed()
        self.grammar = table()
        self.pattern = _pattern()
        self.hides = bool(HIDDEN.search(text))
        self.going_on = False
        self.suspect = False
        self.tabbed: list[tuple[int, int, int]] = []

    def run(self) -> Lexed:
        begin = 0
        for text in self.text.split("\n"):
            self._physical(text.rstrip(" \t\r"), begin)
            begin += len(text) + 1
        self.lexed.open = self.going_on
        self._stop()
        self._report_tabs()
        return self.lexed

    def _physical(self, text: str, begin: int) -> None:
        bare = text.lstrip(" ")
        if not bare:
            self._stop()
            return
        indent = len(text) - len(bare)
        if bare[0] == "\t" or not bare[0].isascii():
            indent, bare = self._odd_indent(text, begin)
        if "\t" not in text[: len(text) - len(bare)]:
            self._report_tabs()
        place = begin + len(text) - len(bare)
        if place == 0 and bare.startswith("#!"):
            self.lexed.comments.append((place, begin + len(text)))
            return
        self._content(bare, place, indent)

    def _content(self, bare: str, place: int, indent: int) -> None:
        """Read what stands in a physical line after its indentation."""
        if self.going_on and self._begins_new(bare):
            self._stop()
        line = self.lexed.lines[-1] if self.going_on else Line(indent, [], place)
        tokens = self.read(bare, place, line, fresh=not self.going_on)
        if not tokens and not line.spoilt:
            return
        if not self.going_on:
            self.lexed.lines.append(line)
        line.tokens += tokens
        if line.spoilt:  # an open text takes no further line with it
            self.going_on = bare[-1] in GOES_ON and bare.count('"') % 2 == 0
        else:
            self.going_on = tokens[-1][1] in GOES_ON

    def read(self, text: str, begin: int, line: Line, fresh: bool) -> list[Token]:
        """The tokens of a physical line's content; marks `line` where something is wrong with it."""
        known = self.faults.found
        if len(text) > LONGEST_LINE:
            self.faults.add("FS116", begin, begin + len(text), longest=LONGEST_LINE)
            line.spoilt = line.faulty = True
            return []
        tokens, odd, comment = self._scan(text, begin, fresh)
        if self.hides and signs.report_hidden(text, begin, _texts(tokens, begin), comment, self.faults):
            line.spoilt = True
        if odd:
            mended = signs.mend(text, begin, odd, self.faults)
            tokens, odd, comment = self._scan(text if mended is None else mended, begin, fresh)
            line.spoilt = line.spoilt or mended is None or bool(odd)
        if comment < len(text):
            self.lexed.comments.append((begin + comment, begin + len(text)))
        if self.suspect and not line.spoilt:
            tokens = spacing.settle(tokens, self.faults)
        line.faulty = line.faulty or self.faults.found > known
        return tokens

    def _scan(self, text: str, begin: int, fresh: bool) -> tuple[list[Token], list[Odd], int]:
        """Tokens, what is odd, and where the comment begins (the length where there is none)."""
        tokens: list[Token] = []
        odd: list[Odd] = []
        strange = not text.isascii()
        keywords = self.grammar.keywords
        self.suspect = False
        for match in self.pattern.finditer(text):
            kind = str(match.lastgroup)
            start, end = match.span(kind)
            word = match[kind] if kind != "IN_TURN" else "in turn"
            if kind == "COMMENT":
                return tokens, odd, start
            if kind in KINDS:
                odd.append((kind, start, end))
                continue
            if strange and (kind in ("NAME", "DOTTED")):
                odd += signs.strange_letters(text, start, end)
            if kind == "NAME" and (fresh or word == "with"):
                kind = keywords.get(word, kind)
            elif kind == "_OPEN" and tokens and tokens[-1][0] != "NAME":
                kind = "LPAR"
            token = (kind, word, begin + start, begin + end)
            self.suspect = self.suspect or spacing.suspect(tokens, token)
            tokens.append(token)
            fresh = kind == "COLON"
        return tokens, odd, len(text)

    def _begins_new(self, bare: str) -> bool:
        """Whether a line begins with a word that cannot go on what stands before it."""
        word = re.match(r"[\w.-]*", bare).group()  # type: ignore[union-attr]
        return self.grammar.keywords.get(word) in HARD

    def _stop(self) -> None:
        """End the last line; where it should have gone on, say so."""
        if not self.going_on:
            return
        self.going_on = False
        line = self.lexed.lines[-1]
        if line.faulty:
            return
        _, sign, start, end = line.tokens[-1]
        fix = self.faults.fix("remove the comma", (start, end, "")) if sign == "," else None
        self.faults.add("FS126", start, end, fix, sign=sign)
        line.faulty = True
        line.tokens.pop()
        line.spoilt = sign != "," or not line.tokens

    def _odd_indent(self, text: str, begin: int) -> tuple[int, str]:
        """The columns and the content of a line whose indentation may hold more than spaces."""
        margin = text[: len(text) - len(text.lstrip(BLANKS))]
        width = 0
        for sign in margin:
            width += TAB_WIDTH - width % TAB_WIDTH if sign == "\t" else 1
        if "\t" in margin:
            self.tabbed.append((begin, begin + len(margin), width))
        elif margin.strip(" "):
            fix = self.faults.fix("write spaces", (begin, begin + len(margin), " " * width))
            sign = signs.shown(margin.strip(" ")[0])
            self.faults.add("FS103", begin, begin + len(margin), fix, sign=sign, meant="spaces")
        return width, text[len(margin) :]

    def _report_tabs(self) -> None:
        """One fault for the lines in a row that are indented with tabs."""
        if not self.tabbed:
            return
        edits = [(start, end, " " * width) for start, end, width in self.tabbed]
        start, end, _ = self.tabbed[0]
        self.faults.add("FS101", start, end, self.faults.fix("indent with spaces", *edits))
        self.tabbed = []


def _texts(tokens: list[Token], begin: int) -> list[tuple[int, int]]:
    return [(start - begin, end - begin - 1) for kind, _, start, end in tokens if kind == "STRING"]
