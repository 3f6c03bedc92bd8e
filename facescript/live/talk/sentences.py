"""A text that comes in pieces to its sentences, each as soon as it is complete."""

from __future__ import annotations

import re
from collections.abc import Iterator

from facescript.speech.align.sentences import CLAUSES, ENDS

LONGEST = 300
"""Characters that a sentence waits for its end; then it is cut at a clause, or between two words."""

SHORT = re.compile(r"(?:^|[\s(])(?:[A-Za-z]|Dr|Mr|Mrs|Ms|Prof|St|No|vs|etc|e\.g|i\.e|z\.B|d\.h|usw|bzw|Nr)\.$")
"""What ends in a stop that ends no sentence."""

BREAK = re.compile(r"\n")

UNSPACED_END = re.compile(r"[。！？।][”’」』）]*$")


class Sentences:
    """Takes pieces of a text, of any length, and gives its sentences: each once a space follows it, or at its end in
    scripts without spaces."""

    def __init__(self) -> None:
        self._text = ""

    def take(self, piece: str) -> Iterator[str]:
        self._text += piece
        while (end := self._end()) is not None:
            yield from self._cut(end)

    def rest(self) -> Iterator[str]:
        """What is left when the text is over."""
        yield from self._cut(len(self._text))

    def _cut(self, end: int) -> Iterator[str]:
        sentence, self._text = self._text[:end].strip(), self._text[end:]
        if any(sign.isalnum() for sign in sentence):
            yield sentence

    def _end(self) -> int | None:
        """Where the first sentence ends, if it is there."""
        found = [match.end() for rule in (ENDS, BREAK) for match in rule.finditer(self._text) if self._ends(match)]
        if found:
            return min(found)
        return self._clause() if len(self._text) > LONGEST else None

    def _ends(self, match: re.Match[str]) -> bool:
        text = self._text[: match.end()]
        if match[0].isspace() or UNSPACED_END.search(text):
            return True
        return match.end() < len(self._text) and SHORT.search(text) is None

    def _clause(self) -> int:
        """Where a long sentence is cut: behind its last clause, or its last word."""
        ends = [match.end() for match in CLAUSES.finditer(self._text, LONGEST // 3, LONGEST)]
        space = self._text.rfind(" ", LONGEST // 3, LONGEST)
        return ends[-1] if ends else space if space > 0 else LONGEST
