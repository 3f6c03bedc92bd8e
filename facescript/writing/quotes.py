"""Texts to what stands between quotes."""

from __future__ import annotations

from facescript.resolve.texts import ESCAPES


def escaped(text: str) -> str:
    """A text in which the signs of the language are themselves."""
    return "".join(f"\\{sign}" if sign in ESCAPES else sign for sign in text)


def quoted(text: str) -> str:
    return f'"{escaped(text)}"'
