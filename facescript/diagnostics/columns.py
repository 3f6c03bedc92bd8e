"""Text to the number of columns that it takes on a terminal."""

from __future__ import annotations

import unicodedata


def columns(text: str) -> int:
    """Columns in a fixed-width font: wide signs (UAX 11) take two, marks on the sign before none."""
    if text.isascii():
        return len(text)
    return sum(_column(sign) for sign in text)


def _column(sign: str) -> int:
    if unicodedata.category(sign) in ("Mn", "Me", "Cf"):
        return 0
    return 2 if unicodedata.east_asian_width(sign) in "WF" else 1
