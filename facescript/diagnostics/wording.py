"""Quantities to the words of a message."""

from __future__ import annotations


def tell(seconds: float, rough: bool = False) -> str:
    """A time for an author: `1.25 s`; `about 1.25 s` where it rests on a line that no voice has spoken yet."""
    return f"{'about ' if rough else ''}{round(seconds, 3):g} s"
