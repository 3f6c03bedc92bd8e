"""The phrases of a row of a kind to numbers, points and names; a word in a wrong place is refused with the form."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from facescript.ir.kind import KindPoint
from facescript.resolve.kinds.words import FARTHEST, POINTS
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import over
from facescript.syntax.tree import Bracket, Colour, Dotted, Integer, Name, Phrase, Point, Quantity, Word
from facescript.text import Span

Words = tuple[Word, ...]


class Row:
    """One row: `form` is how it is written."""

    def __init__(self, project: Project, phrases: tuple[Phrase, ...], form: str) -> None:
        self.project, self.phrases, self.form = project, _joined(phrases), form
        self.span = phrases[0].span.to(phrases[-1].span)

    def clauses(self) -> Iterator[tuple[str, Words]]:
        """The phrases after the first: the first word of each, and the words after it."""
        for phrase in self.phrases[1:]:
            first = phrase.words[0]
            yield spelled(first), phrase.words[1:]

    def refuse(self, span: Span) -> Refused:
        """Refuses words that do not belong where they stand."""
        return self.project.refuse("FS241", span, text=span.text, form=self.form)

    def unknown(self, word: Word, what: str, known: Iterable[str]) -> Refused:
        """Refuses a name that is none of the known."""
        clause, fixes = self.project.meant(spelled(word), known, word.span)
        return self.project.refuse("FS242", word.span, fixes=fixes, name=spelled(word), what=what, meant=clause)

    def one(self, words: Words, span: Span) -> Word:
        """The only word of a clause."""
        if len(words) != 1:
            raise self.refuse(over(words) if words else span)
        return words[0]

    def name(self, word: Word, what: str, known: Iterable[str] | None = None) -> str:
        """A name, one of the known."""
        if not isinstance(word, Name | Dotted):
            raise self.refuse(word.span)
        text = spelled(word)
        if known is not None and text not in known:
            raise self.unknown(word, what, known)
        return text

    def number(self, word: Word) -> float:
        """A bare number, or a percentage as a part of 1."""
        if isinstance(word, Integer):
            value = float(word.value)
        elif isinstance(word, Quantity) and word.unit in ("", "%"):
            value = word.value / 100.0 if word.unit else word.value
        else:
            raise self.refuse(word.span)
        if abs(value) > FARTHEST:
            raise self.project.refuse("FS243", word.span, text=word.span.text, most=int(FARTHEST))
        return value

    def numbers(self, words: Words, count: int, span: Span) -> tuple[float, ...]:
        """As many bare numbers as belong here; of `POINTS`, x and y in turn of at least three."""
        fits = len(words) >= 6 and len(words) % 2 == 0 if count == POINTS else len(words) == count
        if not fits:
            raise self.refuse(over(words) if words else span)
        return tuple(self.number(word) for word in words)

    def share(self, word: Word) -> float:
        """A percentage of 0 to 100."""
        value = self.number(word)
        if not isinstance(word, Quantity) or word.unit != "%" or not 0.0 <= value <= 1.0:
            raise self.refuse(word.span)
        return value

    def spots(self, words: Words, count: int, span: Span) -> tuple[KindPoint, ...]:
        """Points in brackets, each of `count` numbers."""
        if not words:
            raise self.refuse(span)
        return tuple(self._spot(word, count) for word in words)

    def pair(self, word: Word) -> tuple[float, float]:
        """Two numbers in brackets."""
        x, y = self._spot(word, 2).numbers
        return x, y

    def _spot(self, word: Word, count: int) -> KindPoint:
        inner = list(inside(word)) if isinstance(word, Bracket | Point) else []
        sharp = bool(inner) and spelled(inner[-1]) == "sharp"
        if sharp:
            inner.pop()
        depth = None
        if len(inner) == count + 2 and spelled(inner[count]) == "z":
            depth = self.number(inner.pop())
            inner.pop()
        if len(inner) != count:
            raise self.refuse(word.span)
        return KindPoint(tuple(self.number(each) for each in inner), sharp, depth)


def _joined(phrases: tuple[Phrase, ...]) -> tuple[Phrase, ...]:
    """Phrases, of which those that begin with a bracket go on with the points of the one before: lists of points may be
    broken after a comma."""
    found: list[Phrase] = []
    for phrase in phrases:
        if found and isinstance(phrase.words[0], Bracket | Point):
            found[-1] = Phrase(found[-1].words + phrase.words, found[-1].span.to(phrase.span))
        else:
            found.append(phrase)
    return tuple(found)


def inside(word: Bracket | Point) -> Words:
    """The words in a bracket."""
    return word.inner.words if isinstance(word, Bracket) else word.coordinates


def spelled(word: Word) -> str:
    """A name as it is written; a colour; nothing for any other word."""
    if isinstance(word, Dotted):
        return ".".join(str(part) for part in word.parts)
    return word.text if isinstance(word, Name | Colour) else ""
