"""Places in a script to those of its page, and back: characters to UTF-16 units, which JavaScript counts in."""

from __future__ import annotations

from bisect import bisect_left, bisect_right

from facescript.text import Source


class Places:
    """The places of one text. What is half of a character counts as its start."""

    def __init__(self, source: Source) -> None:
        self.source = source
        text = source.text
        self._wide = [] if text.isascii() else [at for at, sign in enumerate(text) if ord(sign) > 0xFFFF]
        self._units = [at + count for count, at in enumerate(self._wide)]

    def unit(self, offset: int) -> int:
        """The UTF-16 units before an offset in characters."""
        return offset + bisect_left(self._wide, offset)

    def offset(self, unit: int) -> int:
        """The offset in characters of so many UTF-16 units."""
        wide = bisect_right(self._units, unit - 2)
        half = wide < len(self._units) and self._units[wide] == unit - 1
        return unit - wide - (1 if half else 0)
