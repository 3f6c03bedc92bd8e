"""A line's phrases to its head and its modifiers, by the table of words."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

from facescript.diagnostics.model import Fix
from facescript.ir.values import Amount
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader, over
from facescript.resolve.scope import Scope
from facescript.resolve.suggest import nearest, replace
from facescript.resolve.sums import quantity
from facescript.resolve.words import DIRECT, MODIFIERS, VALUE, Modifier
from facescript.syntax.tree import Name, Phrase, Word
from facescript.text import Span

Words = tuple[Word, ...]

MANY = 13
"""Modifiers of one line beyond which a message has their names only."""


class Line:
    """A line in pieces: `head` are its first words, `parts` the words of each modifier's value by its name.

    `called` is what messages call it (`show`), `rows` the modifiers it takes; `scope` is where its words are read.
    """

    __slots__ = ("called", "head", "parts", "project", "rows", "scope", "span", "spans")

    def __init__(
        self, project: Project, called: str, phrases: tuple[Phrase, ...], rows: Mapping[str, Modifier], scope: Scope
    ) -> None:
        self.project = project
        self.called = called
        self.rows = rows
        self.scope = scope
        self.span = phrases[0].span.to(phrases[-1].span)
        self.parts: dict[str, Words] = {}
        self.spans: dict[str, Span] = {}
        self.head: Words = ()
        self._split(phrases)

    # -------------------------------------------------------------------------------------------- reading

    def _split(self, phrases: tuple[Phrase, ...]) -> None:
        faulty = False
        for number, phrase in enumerate(phrases):
            for place, words in enumerate(segments(phrase.words)):
                if number == place == 0:
                    self.head = words
                    continue
                try:
                    self.take(words)
                except Refused:
                    faulty = True
        if faulty:
            raise Refused

    def take(self, words: Words) -> None:
        """Takes the words of one modifier. Raises `Refused`."""
        row, value = match(words, self.rows)
        span = over(words)
        if row is None:
            raise self._stranger(words, span)
        group = row.group or row.name
        if group in self.spans:
            raise self.project.refuse("FS310", span, name=(row.group and span.text) or row.name)
        self.spans[group] = span
        self.parts[row.name] = value

    def _stranger(self, words: Words, span: Span) -> Refused:
        """Refuses words that are no modifier of this line: another verb's, a misspelt one, or none at all."""
        forms = [row.form if len(self.rows) <= MANY else row.name for row in self.rows.values()]
        taken = ", ".join(f"`{form}`" for form in forms) or "no modifiers"
        row, _ = match(words, MODIFIERS)
        if row is not None:
            return self.project.refuse("FS309", span, called=self.called, form=row.form, taken=taken)
        first = next((word for word in words if isinstance(word, Name)), None)
        fixes: tuple[Fix, ...] = ()
        clause = f"; it takes {taken}."
        if first is not None:
            openers = {word for row in self.rows.values() for word in row.pattern if word != VALUE}
            candidate = nearest(first.text, openers)
            if candidate is not None:
                clause, fixes = f"; did you mean `{candidate}`?", (replace(first.span, candidate),)
        return self.project.refuse("FS308", span, fixes=fixes, text=span.text, called=self.called, meant=clause)

    def finish(self, reader: Reader) -> None:
        """Refuses words in the head behind the verb's own."""
        rest = reader.rest()
        if rest:
            advice = f"nothing more can stand behind `{self.called}` here"
            raise self.project.refuse("FS312", over(rest), text=over(rest).text, advice=advice)

    # -------------------------------------------------------------------------------------------- values

    def reader(self) -> Reader:
        return Reader(self.head, self.scope, over(self.head))

    def amount(self, name: str, kind: str) -> Amount | None:
        """The amount of a modifier, None where it is not written. Raises `Refused`."""
        words = self.parts.get(name)
        if words is None:
            return None
        return quantity(self.project, words, self.scope, kind, self.spans[name])

    def factor(self, name: str, kind: str, least: float = 0.0) -> float | None:
        """As `amount`, where the seed cannot draw."""
        words = self.parts.get(name)
        if words is None:
            return None
        amount = quantity(self.project, words, self.scope, kind, self.spans[name], least=least, draws=False)
        assert isinstance(amount, float)
        return amount

    def name(self, modifier: str) -> Name | None:
        """The single name that a modifier takes. Raises `Refused` for anything else."""
        words = self.parts.get(modifier)
        if words is None:
            return None
        if len(words) == 1 and isinstance(words[0], Name):
            return words[0]
        span = self.spans[modifier]
        raise self.project.refuse("FS312", span, text=span.text, advice=f"write `{self.rows[modifier].form}`")


def segments(words: Words) -> list[Words]:
    """A phrase cut before each word that begins a direct modifier (`over`, `for`, `as`, ...)."""
    cuts = [index for index, word in enumerate(words) if index and isinstance(word, Name) and word.text in DIRECT]
    if not cuts:
        return [words]
    edges = [0, *cuts, len(words)]
    return [words[first:last] for first, last in pairwise(edges)]


def match(words: Words, rows: Mapping[str, Modifier]) -> tuple[Modifier | None, Words]:
    """The modifier that words are, with the words of its value; longer patterns win."""
    texts = [word.text if isinstance(word, Name) else "" for word in words]
    best: Modifier | None = None
    value: Words = ()
    for row in rows.values():
        fits = _fit(texts, row.pattern)
        if fits is not None and (best is None or len(row.pattern) > len(best.pattern)):
            best, value = row, words[fits[0] : fits[1]]
    return best, value


def _fit(texts: list[str], pattern: tuple[str, ...]) -> tuple[int, int] | None:
    """The stretch of the value where the words fit a pattern, else None."""
    if VALUE not in pattern:
        return (0, 0) if texts == list(pattern) else None
    lead = pattern.index(VALUE)
    tail = len(pattern) - lead - 1
    if len(texts) <= lead + tail or texts[:lead] != list(pattern[:lead]):
        return None
    if tail and texts[-tail:] != list(pattern[-tail:]):
        return None
    return lead, len(texts) - tail
