"""The words of a `fill` to what a shape is filled with: a tone, or a gradient of tones."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from facescript.ir.kind import Fill, Tone, TonedStop
from facescript.resolve.kinds.row import Row, Words, inside, spelled
from facescript.syntax.tree import Bracket, Colour, Name, Word
from facescript.text import Span

LINES: dict[str, tuple[float, ...]] = {
    "down": (0.0, 0.0, 0.0, 1.0),
    "across": (0.0, 0.0, 1.0, 0.0),
    "outward": (0.0, 0.0, 1.0, 0.0),
}


def fill(row: Row, words: Words, palette: Collection[str], span: Span) -> Fill:
    """A fill; colours are names of the palette or `#rrggbb`. Raises `Refused`."""
    first = words[0] if words else None
    way = first.text if isinstance(first, Name) else ""
    if way in LINES:
        return Fill("line", _stops(row, words[1:], palette, span), LINES[way], way == "outward")
    if way == "line":
        return Fill("line", _stops(row, words[5:], palette, span), row.numbers(words[1:5], 4, span))
    if way == "round":
        return Fill("round", _stops(row, words[4:], palette, span), row.numbers(words[1:4], 3, span))
    if not words:
        raise row.refuse(span)
    return Fill("plain", (TonedStop(tone(row, words, palette, span), 0.0),))


def tone(row: Row, words: Sequence[Word], palette: Collection[str], span: Span) -> Tone:
    """A tone, or a mixture of two: `skin.base 45% skin.shade`."""
    if len(words) not in (1, 3):
        raise row.refuse(span)
    first = _colour(row, words[0], palette)
    if len(words) == 1:
        return Tone(first)
    return Tone(first, _colour(row, words[2], palette), row.share(words[1]))


def _colour(row: Row, word: Word, palette: Collection[str]) -> str:
    if isinstance(word, Colour):
        return word.text.lower()[:7]
    return row.name(word, "colour of this kind", palette)


def _stops(row: Row, words: Words, palette: Collection[str], span: Span) -> tuple[TonedStop, ...]:
    stops = tuple(_stop(row, word, palette) for word in words)
    if len(stops) < 2:
        raise row.refuse(span)
    return stops


def _stop(row: Row, word: Word, palette: Collection[str]) -> TonedStop:
    """`(skin.base 45% skin.shade at 30% opacity 80%)`."""
    words = list(inside(word)) if isinstance(word, Bracket) else []
    found: dict[str, float] = {}
    while len(words) > 2 and spelled(words[-2]) in ("at", "opacity"):
        found[spelled(words[-2])] = row.share(words[-1])
        del words[-2:]
    if "at" not in found or not words:
        raise row.refuse(word.span)
    return TonedStop(tone(row, words, palette, word.span), found["at"], found.get("opacity", 1.0))
