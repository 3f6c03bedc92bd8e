"""A datagram of Open Sound Control 1.0 to the messages in it, each with its time; all is bounded."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass

from facescript.live.messages import Nonsense

DEEPEST = 4
"""Bundles within bundles."""

MOST = 256
"""Messages of a datagram, and values of a message."""

EPOCH = 2_208_988_800
"""Seconds from 1900, from which time tags count, to the Unix epoch."""

BUNDLE = b"#bundle\0"

NUMBERS = {"i": (">i", 4), "f": (">f", 4), "d": (">d", 8), "h": (">q", 8)}
"""The types of numbers: how they are packed, and their bytes."""


@dataclass(frozen=True, slots=True)
class Message:
    """`time` is seconds of the Unix epoch, None for at once."""

    address: str
    values: tuple[object, ...]
    time: float | None = None


def messages(packet: bytes) -> list[Message]:
    """Raises `Nonsense`."""
    try:
        found = []
        for message in _messages(packet, None, 0):
            found.append(message)
            if len(found) > MOST:
                raise Nonsense(f"a datagram has at most {MOST} messages")
        return found
    except (struct.error, UnicodeDecodeError, IndexError):
        raise Nonsense("it is no OSC packet") from None


def _messages(packet: bytes, time: float | None, depth: int) -> Iterator[Message]:
    if not packet.startswith(BUNDLE):
        yield _message(packet, time)
        return
    if depth == DEEPEST:
        raise Nonsense("it has bundles within bundles")
    time, at = _time(packet[8:16]), 16
    while at < len(packet):
        (size,) = struct.unpack_from(">i", packet, at)
        if size <= 0 or at + 4 + size > len(packet):
            raise Nonsense("a bundle is cut off")
        yield from _messages(packet[at + 4 : at + 4 + size], time, depth + 1)
        at += 4 + size


def _time(tag: bytes) -> float | None:
    whole, part = struct.unpack(">II", tag)
    return None if (whole, part) == (0, 1) else whole - EPOCH + part / 2**32


def _message(packet: bytes, time: float | None) -> Message:
    address, at = _text(packet, 0)
    types, at = _text(packet, at)
    if not address.startswith("/") or not types.startswith(",") or len(types) > MOST:
        raise Nonsense("it is no OSC message")
    values: list[object] = []
    for kind in types[1:]:
        if kind in NUMBERS:
            form, size = NUMBERS[kind]
            values += struct.unpack_from(form, packet, at)
            at += size
        elif kind == "s":
            text, at = _text(packet, at)
            values.append(text)
        else:
            raise Nonsense(f"values of the type `{kind[:1]}` are not read")
    return Message(address, tuple(values), time)


def _text(packet: bytes, at: int) -> tuple[str, int]:
    """A text that ends in a zero and is filled up to a multiple of four bytes, and where the next thing begins."""
    end = packet.find(b"\0", at)
    if end < 0:
        raise Nonsense("a text does not end")
    return packet[at:end].decode("utf-8"), (end // 4 + 1) * 4
