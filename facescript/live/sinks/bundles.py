"""Messages of Open Sound Control to datagrams: all that stays is laid out once, and a frame only puts its numbers in.

A bundle is `#bundle`, a time tag, and for each message its length and itself; a message is its address, the types of
its arguments, and they, each filled up to four bytes, big-endian (the specification of OSC 1.0).
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

LARGEST = 1400
"""Bytes of a datagram, so that no network has to cut it."""

LONGEST_TEXT = 800
"""Bytes of a text in a message."""

HEAD = b"#bundle\0" + struct.pack(">Q", 1)
"""The time tag 1 means at once: clocks of two machines differ by more than a frame."""

CODES = {str: "s", int: "i", float: "f"}


def message(address: str, *arguments: str | float) -> bytes:
    """A message: texts, whole numbers (int32) and others (float32)."""
    types = "," + "".join(CODES[type(one)] for one in arguments)
    return b"".join([_padded(address), _padded(types), *map(_argument, arguments)])


def bundle(*messages: bytes) -> bytes:
    return HEAD + b"".join(struct.pack(">i", len(one)) + one for one in messages)


@dataclass(frozen=True, slots=True)
class Part:
    """A datagram: its bytes, where in them numbers go, and which of a frame's they are."""

    template: NDArray[np.uint8]
    places: NDArray[np.intp]
    numbers: slice


class Bundles:
    """Messages whose last arguments are numbers of each frame. `forms` are pairs of a message, with any numbers in
    it, and how many of its last ones a frame gives."""

    def __init__(self, forms: Sequence[tuple[bytes, int]]) -> None:
        self._parts: list[Part] = []
        held: list[tuple[bytes, int]] = []
        for form in forms:
            if held and len(bundle(*(one for one, _ in held), form[0])) > LARGEST:
                self._close(held)
                held = []
            held.append(form)
        if held:
            self._close(held)

    def packets(self, values: NDArray[np.float64]) -> list[bytes]:
        """The datagrams of a frame; `values` are the numbers of all messages in their order."""
        raw = values.astype(">f4").view(np.uint8)
        return [_filled(part, raw) for part in self._parts]

    def _close(self, held: list[tuple[bytes, int]]) -> None:
        first = self._parts[-1].numbers.stop // 4 if self._parts else 0
        template = np.frombuffer(bundle(*(one for one, _ in held)), dtype=np.uint8)
        places: list[int] = []
        end = len(HEAD)
        for one, count in held:
            end += 4 + len(one)
            places += range(end - 4 * count, end)
        numbers = slice(4 * first, 4 * first + len(places))
        self._parts.append(Part(template, np.array(places, dtype=np.intp), numbers))


def _filled(part: Part, raw: NDArray[np.uint8]) -> bytes:
    packet = part.template.copy()
    packet[part.places] = raw[part.numbers]
    return packet.tobytes()


def _argument(value: str | float) -> bytes:
    if isinstance(value, str):
        return _padded(value)
    return struct.pack(">i" if isinstance(value, int) else ">f", value)


def _padded(text: str) -> bytes:
    data = text.replace("\0", "").encode()[:LONGEST_TEXT].decode(errors="ignore").encode() + b"\0"
    return data + b"\0" * (-len(data) % 4)
