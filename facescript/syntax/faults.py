"""The faults found in one parse, in the order of their places and bounded in number."""

from __future__ import annotations

from typing import Any

from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic, Diagnostics, Edit, Fix
from facescript.text import Piece, Source, Span

MOST = 200
"""How many diagnostics one parse gives; the next one says that there are more."""


class Faults:
    """Collects what is wrong with a source, or a piece of one; places are offsets in it. `most` diagnostics are kept,
    all are counted."""

    def __init__(self, place: Source | Piece, most: int = MOST) -> None:
        self.place, self.source, self.most = place, place.source, most
        self.found = 0
        self._items: list[Diagnostic] = []

    def span(self, start: int, end: int) -> Span:
        return Span(self.place, start, end)

    def add(self, code: str, start: int, end: int, fix: Fix | None = None, **values: Any) -> None:
        """One diagnostic with at most one fix. What comes after `most` of them is not made: it would not be read."""
        self.found += 1
        if self.found <= self.most + 1:
            fixes = (fix,) if fix else ()
            self._items.append(diagnose(code, self.span(start, end), fixes=fixes, **values))

    def text(self, start: int, end: int) -> str:
        """What stands between two offsets."""
        return self.span(start, end).text

    def fix(self, title: str, *edits: tuple[int, int, str]) -> Fix:
        """A fix of edits (start, end, new text)."""
        return Fix(title, tuple(Edit(self.span(start, end), text) for start, end, text in edits))

    @property
    def items(self) -> list[Diagnostic]:
        """Those that are kept, by place."""
        return sorted(self._items[: self.most], key=lambda item: item.span.start if item.span else 0)

    def pour(self, diagnostics: Diagnostics) -> None:
        """All of them, by place, into the list that every pass appends to."""
        for item in self.items:
            diagnostics.add(item)
        if self.found > self.most:
            diagnostics.add(diagnose("FS119", self._items[self.most].span, most=self.most))
