"""What the page is told to bytes: JSON texts, and numbers behind a head of JSON."""

from __future__ import annotations

import json
from collections.abc import Iterable

Message = dict[str, object]

ALIGNED = 8
"""Numbers begin at a multiple of so many bytes, so that a browser may look at them where they are."""


def text(kind: str, **values: object) -> bytes:
    """A message of JSON alone."""
    return json.dumps({"kind": kind, **values}, ensure_ascii=False, separators=(",", ":"), allow_nan=False).encode()


def numbers(kind: str, parts: Iterable[bytes], **values: object) -> bytes:
    """A message with numbers: the length of its head in bytes (32 bits, little-endian), the head, the numbers of all
    parts, 32-bit floats too. Its first byte is none that a JSON text begins with."""
    head = text(kind, **values)
    head += b" " * (-(len(head) + 4) % ALIGNED)
    return b"".join((len(head).to_bytes(4, "little"), head, *parts))


def is_text(message: bytes) -> bool:
    """Whether a message is JSON alone."""
    return message[:1] == b"{"


def head_of(message: bytes) -> Message:
    """What a message says besides its numbers."""
    first, length = (0, len(message)) if is_text(message) else (4, int.from_bytes(message[:4], "little"))
    found: Message = json.loads(message[first : first + length])
    return found
