"""A text with `^` before the letter that the editor's cursor is at, to the text and the position."""

from __future__ import annotations

from lsprotocol import types


def marked(text: str) -> tuple[str, types.Position]:
    before, _, after = text.partition("^")
    line = before.count("\n")
    return before + after, types.Position(line, len(before.rpartition("\n")[2].encode("utf-16-le")) // 2)
