"""An editor at the other end of standard input and output: the script as it stands there, and edits that it makes.

Each line is a message in JSON. In come `text` (the script, with a number for this state of it), `caret` (an offset in
UTF-16 units) and `play` (seconds); out go `address`, `jump`, and `edit` with the number of the text that it is for.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from io import FileIO
from threading import Thread
from typing import Protocol

from facescript.web.messages import Message, text
from facescript.world import LARGEST_SCRIPT

LONGEST = 8 * LARGEST_SCRIPT
"""Bytes of a message: in JSON a character may take six bytes and more."""

TAKEN: Mapping[str, Mapping[str, tuple[type, ...]]] = {
    "text": {"version": (int,), "text": (str,)},
    "caret": {"offset": (int,)},
    "play": {"time": (int, float)},
}
"""What an editor may say: the kinds, and what belongs to each."""


PIECE = 1 << 16
"""Bytes that are read at once."""


class Reads(Protocol):
    def read(self, size: int, /) -> bytes | None:
        """So many bytes or fewer; none at the end."""


class Writes(Protocol):
    def write(self, data: bytes, /) -> object: ...

    def flush(self) -> None: ...


class Editor:
    """Reads and writes for as long as the editor is there. `version` is the number of the text that it sent last."""

    def __init__(self, reads: Reads | None = None, writes: Writes | None = None) -> None:
        self._reads = reads or FileIO(sys.stdin.fileno(), closefd=False)
        self._writes = writes or sys.stdout.buffer
        self.version = 0

    def listen(self, hear: Callable[[Message], None], ended: Callable[[], None]) -> None:
        """Calls `hear` with each message, and `ended` when no more can come, in a thread of its own."""
        Thread(target=self._listen, args=(hear, ended), daemon=True).start()

    def tell(self, kind: str, **values: object) -> None:
        """Sends a message; to an editor that is gone, none."""
        with suppress(OSError, ValueError):
            self._writes.write(text(kind, **values) + b"\n")
            self._writes.flush()

    def _listen(self, hear: Callable[[Message], None], ended: Callable[[], None]) -> None:
        with suppress(OSError, ValueError):
            for line in self._lines():
                message = understood(line)
                if message is not None:
                    hear(message)
        ended()

    def _lines(self) -> Iterator[bytes]:
        """Reads without a buffer of Python's: one that waits for input would be in the way when the program ends."""
        held = bytearray()
        while (more := self._reads.read(PIECE)) and len(held) < LONGEST:
            held += more
            if b"\n" in more:
                *lines, rest = bytes(held).split(b"\n")
                held = bytearray(rest)
                yield from lines


def understood(line: bytes) -> Message | None:
    """A message of an editor, if it is one."""
    try:
        message = json.loads(line)
    except (ValueError, RecursionError):
        return None
    wanted = TAKEN.get(str(message.get("kind"))) if isinstance(message, dict) else None
    if wanted is None or not all(type(message.get(name)) in types for name, types in wanted.items()):
        return None
    return {name: message[name] for name in ("kind", *wanted)}
