"""Text inside a string, a table's cell or an option to words, as the grammar would read them in a line."""

from __future__ import annotations

import re

from facescript.syntax.tree import (
    Argument,
    Bracket,
    Call,
    Colour,
    Dotted,
    Integer,
    Name,
    Operator,
    Phrase,
    Point,
    Quantity,
    Size,
    String,
    Word,
)
from facescript.text import Source, Span

_NAME = r"[^\W\d]\w*(?:-[^\W\d]\w*)*"
_TOKEN = re.compile(
    rf"""(?P<space>[ \t]+)
    |(?P<colour>\#[0-9a-fA-F]{{6}}(?:[0-9a-fA-F]{{2}})?\b)
    |(?P<size>\d+x\d+\b)
    |(?P<quantity>(?:(?<![\w.%)\]])-)?\d+(?:\.\d+)?(?:[^\W\d_]+|%|/min\b))
    |(?P<integer>\d+(?![\w.]))
    |(?P<string>"(?:\\.|[^"\\\n])*")
    |(?P<call>{_NAME}\()
    |(?P<dotted>{_NAME}(?:\.(?:{_NAME}|\d+|"[^"\n]*"))+)
    |(?P<name>{_NAME})
    |(?P<open>\()|(?P<close>\))|(?P<comma>,)|(?P<equals>=)|(?P<operator>[-+*/])""",
    re.VERBOSE,
)
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
_PART = re.compile(rf'\.(?:({_NAME})|(\d+)|"([^"\n]*)")')


class Unreadable(Exception):
    """Text that is no words of the language; `args[0]` is the span of what cannot be read."""


def phrases_of(source: Source, start: int, end: int) -> tuple[Phrase, ...]:
    """The phrases that stand between two offsets of a source, spans exact. Raises `Unreadable`."""
    lexer = _Lexer(source, start, end)
    phrases = [lexer.phrase()]
    while lexer.take("comma"):
        phrases.append(lexer.phrase())
    if lexer.kind:
        raise Unreadable(lexer.span)
    return tuple(phrases)


class _Lexer:
    def __init__(self, source: Source, start: int, end: int) -> None:
        self.source = source
        self.at = start
        self.end = end
        self.kind = ""
        self.span = Span(source, start, start)
        self.advance()

    def advance(self) -> None:
        """Moves to the next token; `kind` is empty at the end."""
        while self.at < self.end:
            found = _TOKEN.match(self.source.text, self.at, self.end)
            if found is None:
                raise Unreadable(Span(self.source, self.at, self.at + 1))
            self.at = found.end()
            if found.lastgroup != "space":
                self.kind = str(found.lastgroup)
                self.span = Span(self.source, found.start(), found.end())
                return
        self.kind = ""
        self.span = Span(self.source, self.end, self.end)

    def take(self, kind: str) -> bool:
        if self.kind != kind:
            return False
        self.advance()
        return True

    def phrase(self) -> Phrase:
        start = self.span.start
        words = []
        while self.kind not in ("", "comma", "close", "equals"):
            words.append(self.word())
        last = words[-1].span.end if words else start
        return Phrase(tuple(words), Span(self.source, start, last))

    def word(self) -> Word:
        kind, span = self.kind, self.span
        self.advance()
        if kind == "call":
            return self.call(span)
        if kind == "open":
            return self.bracket(span)
        return _simple(kind, span)

    def call(self, opening: Span) -> Call:
        name = Name(opening.text[:-1], Span(self.source, opening.start, opening.end - 1))
        arguments = []
        while self.kind != "close":
            arguments.append(self.argument())
            if not self.take("comma"):
                break
        return Call(name, tuple(arguments), self.closed(opening))

    def argument(self) -> Argument:
        value = self.phrase()
        name = None
        if self.kind == "equals" and len(value.words) == 1 and isinstance(value.words[0], Name):
            name = value.words[0]
            self.advance()
            value = self.phrase()
        span = name.span.to(value.span) if name else value.span
        return Argument(name, value, span)

    def bracket(self, opening: Span) -> Bracket | Point:
        inner = self.phrase()
        span = self.closed(opening)
        numbers = tuple(word for word in inner.words if isinstance(word, Quantity))
        if len(numbers) == len(inner.words) and len(numbers) in (2, 3):
            return Point(numbers, span)
        return Bracket(inner, span)

    def closed(self, opening: Span) -> Span:
        span = opening.to(self.span)
        if not self.take("close"):
            raise Unreadable(opening)
        return span


def _simple(kind: str, span: Span) -> Word:
    text = span.text
    if kind == "quantity":
        number = _NUMBER.match(text)
        assert number is not None
        return Quantity(float(number[0]), text[number.end() :], span)
    if kind == "integer":
        return Integer(int(text), span)
    if kind == "name":
        return Name(text, span)
    if kind == "dotted":
        return _dotted(text, span)
    if kind == "string":
        return String(text[1:-1], span)
    if kind == "colour":
        return Colour(text, span)
    if kind == "size":
        width, height = text.split("x")
        return Size(int(width), int(height), span)
    if kind == "operator":
        return Operator(text, span)
    raise Unreadable(span)


def _dotted(text: str, span: Span) -> Dotted:
    first = text.index(".")
    parts: list[str | int] = [text[:first]]
    quoted = [False]
    for name, number, word in _PART.findall(text[first:]):
        parts.append(int(number) if number else name or word)
        quoted.append(not number and not name)
    return Dotted(tuple(parts), tuple(quoted), span)
