"""A run to Live Link, as the app Live Link Face sends it to Unreal: 61 numbers a face and frame.

A packet is its version (uint32, the only little-endian number), the device's id in 37 bytes, the subject's name behind
its length, the frame's number and part of a frame, the rate as a fraction, how many numbers follow, and they, float32.
"""

from __future__ import annotations

import struct
import uuid
from fractions import Fraction

from facescript.live.address import AddressFault
from facescript.live.model import Frame, Layout
from facescript.live.sinks.datagrams import DatagramSink
from facescript.live.sinks.faces import Posed, chosen
from facescript.shapes import arkit

VERSION = 6

NAMESPACE = uuid.UUID("6f9df3d2-6d0b-5a6c-9a3b-1f0e6d5a7c11")
"""Of the ids of faces: the same face of the same script is the same device tomorrow."""

LONGEST_NAME = 100
"""Bytes of a subject's name."""

LARGEST_PART = 1001
"""Of a rate's denominator: 30000/1001 is the rate of television."""


class LiveLinkSink(DatagramSink):
    """Each face is a subject of its own name; the address may choose one."""

    def begin(self, layout: Layout) -> None:
        if not layout.faces:
            raise AddressFault("FS982", address=self._address.text, reason="the script has no face that is seen")
        one = "face" in self._address.options
        faces = [chosen(layout, self._address)] if one else [Posed(layout, face) for face in layout.faces]
        self._heads = [(face, _head(layout.title, face.face)) for face in faces]
        rate = Fraction(layout.fps).limit_denominator(LARGEST_PART)
        self._fraction = struct.pack(">II", rate.numerator, rate.denominator)

    def packets(self, frame: Frame) -> list[bytes]:
        when = struct.pack(">If", frame.number & 0xFFFFFFFF, 0.0) + self._fraction
        return [head + when + _shapes(face, frame) for face, head in self._heads]


def _head(title: str, face: str) -> bytes:
    name = face.encode()[:LONGEST_NAME].decode(errors="ignore").encode()
    device = f"${str(uuid.uuid5(NAMESPACE, f'{title}/{face}')).upper()}".encode("ascii")
    return struct.pack("<I", VERSION) + device + struct.pack(">i", len(name)) + name


def _shapes(face: Posed, frame: Frame) -> bytes:
    shapes = arkit.shapes(face.pose(frame.values)[None, :])[0]
    packed: bytes = shapes.astype(">f4").tobytes()
    return struct.pack(">B", len(shapes)) + packed
