"""A cursor over the words of a phrase."""

from __future__ import annotations

from facescript.resolve.scope import Scope
from facescript.syntax.tree import Dotted, Name, Operator, Word
from facescript.text import Span


class Reader:
    """Reads `words` from left to right; `span` is where a message about missing words points."""

    __slots__ = ("index", "scope", "span", "words")

    def __init__(self, words: tuple[Word, ...], scope: Scope, span: Span) -> None:
        self.words = words
        self.scope = scope
        self.span = span
        self.index = 0

    def peek(self) -> Word | None:
        return self.words[self.index] if self.index < len(self.words) else None

    def next(self) -> Word | None:
        word = self.peek()
        self.index += 1
        return word

    def word(self, text: str) -> bool:
        """Takes the next word if it is `text`."""
        word = self.peek()
        if isinstance(word, Name) and word.text == text:
            self.index += 1
            return True
        return False

    def operator(self, *texts: str) -> str | None:
        """Takes the next word if it is one of these operators."""
        word = self.peek()
        if isinstance(word, Operator) and word.text in texts:
            self.index += 1
            return word.text
        return None

    def rest(self) -> tuple[Word, ...]:
        return self.words[self.index :]

    def here(self) -> Span:
        """The next word's span, or that of the whole where there is none."""
        word = self.peek()
        return word.span if word is not None else self.span


def spelled(word: Name | Dotted) -> str:
    """A name as it is written: `smile.left`, `crowd.2`."""
    if isinstance(word, Name):
        return word.text
    return ".".join(f'"{part}"' if quoted else str(part) for part, quoted in zip(word.parts, word.quoted, strict=True))


def over(words: tuple[Word, ...]) -> Span:
    """The span from the first word to the last."""
    return words[0].span.to(words[-1].span)
