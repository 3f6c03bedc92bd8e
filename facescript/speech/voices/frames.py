"""Questions and answers between programs, to frames of bytes in a pipe and back.

A frame is a length (4 bytes, big-endian) and that many bytes. A request is a frame of JSON; an answer is one or more
parts, each a frame of JSON and a frame of bytes; a part whose JSON has `more` is not the last.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from typing import IO, Any

LONGEST = 1 << 28
"""Bytes of a frame: 100 minutes of sound."""


def framed(*bodies: bytes) -> bytes:
    """Frames, one after another."""
    return b"".join(struct.pack(">I", len(body)) + body for body in bodies)


def read_part(stream: IO[bytes]) -> tuple[dict[str, Any], bytes]:
    """The next part of an answer. Raises `EOFError` where the stream ends in it, `ValueError` where it is none."""
    head = json.loads(_frame(stream))
    if not isinstance(head, dict):
        raise ValueError("no head of an answer")
    return head, _frame(stream)


def requests(stream: IO[bytes]) -> Iterator[dict[str, Any]]:
    """The requests of a stream, to its end."""
    while True:
        try:
            yield json.loads(_frame(stream))
        except EOFError:
            return


def _frame(stream: IO[bytes]) -> bytes:
    size = struct.unpack(">I", _exactly(stream, 4))[0]
    if size > LONGEST:
        raise ValueError("a frame too long")
    return _exactly(stream, size)


def _exactly(stream: IO[bytes], size: int) -> bytes:
    data = stream.read(size)
    if len(data) < size:
        raise EOFError
    return data
