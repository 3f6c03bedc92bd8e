"""What pages were told to what a page that comes later has to be told: the latest of each, in a fitting order."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.web.messages import head_of

KEPT = ("editor", "script", "diagnostics", "score", "figure", "sound")
"""Messages that say how things are until the next of their kind."""

FIGURE = ("mean", "ways", "layer")
"""Messages that add to a figure."""


class Board:
    """The state of all pages."""

    def __init__(self) -> None:
        self._latest: dict[object, bytes] = {}
        self._figure: object = None
        self._parts: list[bytes] = []
        self._chunks: dict[object, bytes] = {}

    def take(self, message: bytes) -> None:
        """Notes a message that pages are told now."""
        head = head_of(message)
        kind = head["kind"]
        if kind == "figure":
            if head["figure"] != self._figure:
                self._figure = head["figure"]
                self._parts.clear()
                self._chunks.clear()
            self._forget([number for number in self._chunks if int(str(number)) >= int(str(head["chunks"]))])
        if kind in KEPT:
            self._latest[kind] = message
        elif kind in FIGURE:
            self._parts.append(message)
        elif kind == "frames":
            self._chunks[head["chunk"]] = message
        elif kind == "forget":
            self._forget(head["chunks"])

    def all(self) -> Iterator[bytes]:
        """What a new page is told."""
        yield from (self._latest[kind] for kind in KEPT if kind in self._latest)
        yield from self._parts
        yield from self._chunks.values()

    def _forget(self, chunks: object) -> None:
        assert isinstance(chunks, list)
        for number in chunks:
            self._chunks.pop(number, None)
