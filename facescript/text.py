"""Source text and the places in it: offsets to lines and columns, spans that diagnostics point at."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field
from typing import ClassVar


@dataclass(frozen=True, slots=True, eq=False)
class Source:
    """One file of the language as text. `name` is what messages call it, relative to the project."""

    begin: ClassVar[int] = 0
    name: str
    text: str
    _starts: list[int] = field(default_factory=list, repr=False)

    @property
    def source(self) -> Source:
        return self

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column of an offset, both from 1, columns in characters."""
        starts = self._line_starts()
        line = bisect_right(starts, offset)
        return line, offset - starts[line - 1] + 1

    def offset(self, number: int) -> int | None:
        """The offset at which a line (from 1) begins; None where there is no such line."""
        starts = self._line_starts()
        return starts[number - 1] if 1 <= number <= len(starts) else None

    def line(self, number: int) -> str:
        """The text of a line (from 1) without its end."""
        starts = self._line_starts()
        end = starts[number] if number < len(starts) else len(self.text)
        return self.text[starts[number - 1] : end].rstrip("\r\n")

    def _line_starts(self) -> list[int]:
        if not self._starts:
            self._starts.append(0)
            at = self.text.find("\n")
            while at >= 0:
                self._starts.append(at + 1)
                at = self.text.find("\n", at + 1)
        return self._starts


@dataclass(slots=True, eq=False)
class Piece:
    """Lines of a source that is edited: `begin` is where they stand in it now. All spans in them move with them."""

    source: Source
    begin: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class Span:
    """A half-open stretch of a source, offsets in characters; `first` and `last` count from where its place begins."""

    place: Source | Piece
    first: int
    last: int

    @property
    def source(self) -> Source:
        return self.place.source

    @property
    def start(self) -> int:
        return self.place.begin + self.first

    @property
    def end(self) -> int:
        return self.place.begin + self.last

    @property
    def text(self) -> str:
        return self.source.text[self.start : self.end]

    def part(self, start: int, end: int) -> Span:
        """The stretch of the same place between two offsets in the source."""
        begin = self.place.begin
        return Span(self.place, start - begin, end - begin)

    def to(self, other: Span) -> Span:
        """From the start of this span to the end of another in the same source."""
        if other.place is self.place:
            return Span(self.place, self.first, other.last)
        return Span(self.source, self.start, other.end)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Span) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[Source, int, int]:
        begin = self.place.begin
        return self.place.source, begin + self.first, begin + self.last
