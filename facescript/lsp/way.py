"""An offset to what the tree has there: the nodes around it, outermost first."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

from facescript.syntax.tree import Script
from facescript.text import Span

LEAVES = (str, int, float, Span, type(None))


def way(script: Script, place: int) -> list[Any]:
    """The item, statements, phrases and words that hold an offset of a script; one at the end of a word is in it."""
    items = script.items
    found: list[Any] = []
    index = bisect_right(items, place, key=lambda item: item.span.start)
    node: Any = items[index - 1] if index else None
    while node is not None and node.span.start <= place <= node.span.end:
        found.append(node)
        node = next((child for child in _children(node) if child.span.start <= place < child.span.end), None) or next(
            (child for child in _children(node) if child.span.end == place), None
        )
    return found


def _children(node: Any) -> Iterator[Any]:
    for part in fields(node):
        value = getattr(node, part.name)
        for each in value if isinstance(value, tuple) else (value,):
            if not isinstance(each, LEAVES) and is_dataclass(each):
                yield each
