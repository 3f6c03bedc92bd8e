"""A line's text to plain text and its marks: stress, breaths, pauses, readings, and statements between brackets."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Stretch
from facescript.ir.wording import unspaced
from facescript.resolve.notes import Told
from facescript.resolve.project import Project, Refused
from facescript.resolve.scope import Scope
from facescript.resolve.sums import number
from facescript.resolve.units import TIME
from facescript.syntax.parser import parse_phrases
from facescript.syntax.tree import Phrase, String
from facescript.text import Span

LONGEST = 20_000
"""Characters of one line's text."""

ESCAPES = '[]*|"\\'
_ESCAPED = re.compile(rf"\\([{re.escape(ESCAPES)}])")
_SPECIAL = re.compile(r"[\\\[*|]|\s+")


@dataclass(slots=True)
class Inline:
    """A statement inside a text: its phrases; it starts before the character `at` of the plain text and is ended by
    `[/]` at `until`, None where there is none. `scope` is where its words are read."""

    phrases: tuple[Phrase, ...]
    span: Span
    scope: Scope
    at: int
    until: int | None = None


@dataclass(slots=True)
class _Reading:
    """`[read zhang3]` that waits for its `[/]`."""

    value: str
    span: Span
    at: int


@dataclass(frozen=True, slots=True)
class Text:
    plain: str
    stretches: tuple[Stretch, ...]
    inlines: tuple[Inline, ...]


def bare_text(string: String) -> str:
    """A text that is not spoken, a title or a caption: signs behind `\\` are themselves, white space is one space."""
    return " ".join(_ESCAPED.sub(r"\1", string.value).split())


def pieces_of(strings: tuple[String, ...]) -> tuple[Span, ...]:
    """What stands between the quotes of each string."""
    return tuple(string.span.part(string.span.start + 1, string.span.end - 1) for string in strings)


def read_text(project: Project, pieces: tuple[Span, ...], scope: Scope, span: Span) -> Text:
    """The text of a line, which stands in several pieces. All its faults are reported, each at its place; then raises
    `Refused`."""
    size = sum(piece.end - piece.start for piece in pieces)
    if size > LONGEST:
        raise project.refuse("FS319", span, count=size, most=LONGEST)
    reader = _TextReader(project, scope)
    for piece in pieces:
        reader.read(piece)
    return reader.finished(span)


class Plain:
    """Gathers plain text. White space is one space; where a string or a line ends it is none between characters of
    scripts that are written without."""

    def __init__(self) -> None:
        self.out: list[str] = []
        self.length = 0
        self.gap = ""

    def put(self, text: str) -> None:
        """Text without white space."""
        closed = self.gap == "end" and self.out and unspaced(self.out[-1][-1]) and unspaced(text[0])
        if self.gap and self.out and not closed:
            self.out.append(" ")
            self.length += 1
        self.gap = ""
        self.out.append(text)
        self.length += len(text)

    def space(self, sign: str) -> None:
        """White space."""
        self.gap = "end" if "\n" in sign and self.gap != "space" else "space"


class _TextReader(Plain):
    """Gathers plain text and marks."""

    def __init__(self, project: Project, scope: Scope) -> None:
        super().__init__()
        self.project = project
        self.scope = scope
        self.stretches: list[Stretch] = []
        self.inlines: list[Inline] = []
        self.opened: list[Inline | _Reading] = []
        self.stress: tuple[int, Span] | None = None
        self.failed = False

    def read(self, piece: Span) -> None:
        text, at, end = piece.source.text, piece.start, piece.end
        self.gap = self.gap or "end"
        while at < end:
            special = _SPECIAL.search(text, at, end)
            stop = special.start() if special else end
            if stop > at:
                self.put(text[at:stop])
            if special is None:
                return
            try:
                at = self.special(piece, special)
            except Refused:
                self.failed = True
                at = special.end()
                if special[0] == "[":
                    at = max(at, _closing(text, at, end) + 1)

    def special(self, piece: Span, found: re.Match[str]) -> int:
        """Reads one mark; the offset behind it."""
        sign, at = found[0], found.start()
        if sign[0].isspace():
            self.space(sign)
        elif sign == "|":
            self.stretches.append(Stretch("breath", self.length, self.length))
        elif sign == "*":
            self.star(piece.part(at, at + 1))
        elif sign == "\\":
            return self.escape(piece, at)
        else:
            return self.bracket(piece, at)
        return found.end()

    def star(self, span: Span) -> None:
        if self.stress is None:
            self.stress = (self.length, span)
        else:
            self.stretches.append(Stretch("stress", self.stress[0], self.length))
            self.stress = None

    def escape(self, piece: Span, at: int) -> int:
        sign = piece.source.text[at + 1 : min(at + 2, piece.end)]
        if not sign or sign not in ESCAPES:
            span = piece.part(at, min(at + 2, piece.end))
            raise self.project.refuse("FS318", span, text=span.text)
        self.put(sign)
        return at + 2

    def bracket(self, piece: Span, at: int) -> int:
        close = _closing(piece.source.text, at + 1, piece.end)
        if close < 0:
            raise self.project.refuse("FS315", piece.part(at, at + 1), what="`[` has no `]`")
        span, inner = piece.part(at, close + 1), piece.part(at + 1, close)
        content = inner.text.strip()
        if content == "/":
            self.close(span)
        elif content.startswith("read ") or content == "read":
            self.reading(content[5:].strip(), span)
        elif content.startswith("mark ") and (name := content[5:].strip()):
            self.stretches.append(Stretch("mark", self.length, self.length, name))
        elif content.startswith("wait ") and not content.startswith("wait until "):
            self.pause(inner, span)
        else:
            inline = Inline(self.words(inner), span, self.scope, self.length)
            self.inlines.append(inline)
            self.opened.append(inline)
        return close + 1

    def close(self, span: Span) -> None:
        if not self.opened:
            raise self.project.refuse("FS316", span)
        opened = self.opened.pop()
        if isinstance(opened, Inline):
            opened.until = self.length
        else:
            self.stretches.append(Stretch("reading", opened.at, self.length, opened.value))

    def reading(self, value: str, span: Span) -> None:
        if not value:
            raise self.project.refuse("FS312", span, text=span.text, advice="it is written `[read zhang3]长[/]`")
        self.opened.append(_Reading(value, span, self.length))

    def pause(self, inner: Span, span: Span) -> None:
        phrases = self.words(inner)
        if len(phrases) > 1:
            raise self.project.refuse("FS312", phrases[1].span, text=phrases[1].span.text, advice="a pause is its time")
        seconds = number(self.project, phrases[0].words[1:], self.scope, TIME, span)
        self.stretches.append(Stretch("pause", self.length, self.length, f"{seconds:.10g}"))

    def words(self, inner: Span) -> tuple[Phrase, ...]:
        """The phrases between two brackets; what cannot be read is reported by the parser."""
        faults = Diagnostics()
        phrases = parse_phrases(inner, faults)
        for fault in faults:
            self.project.note(Told(None, fault))
        if phrases is None:
            raise Refused
        return phrases

    def finished(self, span: Span) -> Text:
        for opened in self.opened:
            if isinstance(opened, _Reading):
                self.project.report("FS315", opened.span, what="a reading has no `[/]`")
                self.failed = True
        if self.stress is not None:
            self.project.report("FS317", self.stress[1])
            self.failed = True
        if self.failed:
            raise Refused
        plain = "".join(self.out)
        if not plain:
            raise self.project.refuse("FS320", span)
        for inline in self.inlines:
            inline.at = _next_word(plain, inline.at)
        return Text(plain, tight(plain, self.stretches), tuple(self.inlines))


def _closing(text: str, at: int, end: int) -> int:
    """The offset of the `]` that closes a bracket, -1 where another `[` or the end comes first."""
    close = text.find("]", at, end)
    other = text.find("[", at, close if close >= 0 else end)
    return -1 if other >= 0 else close


def _next_word(plain: str, at: int) -> int:
    while at < len(plain) and plain[at].isspace():
        at += 1
    return at


def tight(plain: str, stretches: Iterable[Stretch]) -> tuple[Stretch, ...]:
    """Stretches in order, those over some text from a character on, not from the space before it."""
    found = (
        stretch if stretch.start == stretch.end else replace(stretch, start=_next_word(plain, stretch.start))
        for stretch in stretches
    )
    return tuple(sorted(found, key=lambda stretch: stretch.start))
