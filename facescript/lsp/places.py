"""Places in a source to an editor's lines and UTF-16 columns, and back."""

from __future__ import annotations

from lsprotocol.types import Position, Range

from facescript.text import Source, Span


def units(text: str) -> int:
    """The length of a text in UTF-16 units."""
    return len(text) if text.isascii() else len(text.encode("utf-16-le", "surrogatepass")) // 2


def position(source: Source, offset: int) -> Position:
    """Line and column (both from 0, columns in UTF-16 units) of an offset in characters."""
    line, column = source.position(offset)
    before = source.text[offset - column + 1 : offset]
    return Position(line - 1, units(before))


def range_of(span: Span) -> Range:
    return Range(position(span.source, span.start), position(span.source, span.end))


def offset(source: Source, place: Position) -> int:
    """The offset of a position; one beyond its line's end is the end, one in the middle of a character is before it."""
    if place.line < 0:
        return 0
    start = source.offset(place.line + 1)
    if start is None:
        return len(source.text)
    return start + column(source.line(place.line + 1), place.character)


def column(line: str, count: int) -> int:
    """The characters of a line, or of any text, that its first UTF-16 units are; of one cut in the middle, none."""
    if line.isascii():
        return min(max(count, 0), len(line))
    units = 0
    for index, sign in enumerate(line):
        units += 2 if ord(sign) > 0xFFFF else 1
        if units > count:
            return index
    return len(line)
