"""A sound file's headers to how long it sounds: nothing of the sound is decoded, no numpy loaded."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

MPEG_RATES = {3: (44_100, 48_000, 32_000), 2: (22_050, 24_000, 16_000), 0: (11_025, 12_000, 8_000)}
"""Samples a second by the version bits of an MPEG frame: 1, 2 and 2.5."""

KILOBITS = {
    3: (0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320),
    2: (0, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160),
}
"""Of a layer III frame by its version bits (2.5 as 2)."""

TAIL = 1 << 17
"""Bytes at an OGG file's end in which its last page begins."""

MOST_CHUNKS = 1000


def seconds_of(path: Path) -> float | None:
    """Seconds of a WAV, FLAC, OGG or MP3 file, or None where its headers do not tell."""
    try:
        with path.open("rb") as file:
            head = file.read(4)
            for sign, read in ((b"RIFF", _wav), (b"RF64", _wav), (b"fLaC", _flac), (b"OggS", _ogg)):
                if head == sign:
                    return read(file)
            return _mp3(file)
    except (OSError, ValueError, IndexError, ZeroDivisionError):
        return None


def _wav(file: BinaryIO) -> float | None:
    """The bytes of the data by the bytes a second; a file that breaks off is as long as it is."""
    size = file.seek(0, os.SEEK_END)
    a_second, at = 0, 12
    for _ in range(MOST_CHUNKS):
        file.seek(at)
        head = file.read(8)
        if len(head) < 8:
            return None
        length = int.from_bytes(head[4:], "little")
        if head[:4] == b"fmt ":
            a_second = int.from_bytes(file.read(12)[8:12], "little")
        if head[:4] == b"data":
            return min(length, size - at - 8) / a_second
        at += 8 + length + length % 2
    return None


def _flac(file: BinaryIO) -> float | None:
    """The first block says how many samples there are, in 36 bits behind 20 bits of their rate; 0 is unknown."""
    block = file.read(4 + 34)[4:]
    bits = int.from_bytes(block[10:18], "big")
    rate, samples = bits >> 44, bits & ((1 << 36) - 1)
    return samples / rate if samples else None


def _ogg(file: BinaryIO) -> float | None:
    """The last page's place by the rate in the first; Opus counts 48,000 a second and skips some at the start."""
    file.seek(0)
    first = file.read(200)
    file.seek(max(file.seek(0, os.SEEK_END) - TAIL, 0))
    tail = file.read(TAIL)
    at = tail.rfind(b"OggS")
    places = int.from_bytes(tail[at + 6 : at + 14], "little")
    if at < 0 or places == (1 << 64) - 1:
        return None
    if (opus := first.find(b"OpusHead")) >= 0:
        return max(places - int.from_bytes(first[opus + 10 : opus + 12], "little"), 0) / 48_000
    if (vorbis := first.find(b"\1vorbis")) >= 0:
        return places / int.from_bytes(first[vorbis + 12 : vorbis + 16], "little")
    return None


def _mp3(file: BinaryIO) -> float | None:
    """The frames that the first one counts (Xing, Info), or else its bit rate for all of the file."""
    file.seek(0)
    head = file.read(10)
    begin = 0
    if head[:3] == b"ID3":
        begin = 10 + sum((byte & 0x7F) << shift for byte, shift in zip(head[6:10], (21, 14, 7, 0), strict=True))
    size = file.seek(0, os.SEEK_END)
    file.seek(begin)
    data = file.read(4096)
    for at, version, rate, kilobits in _frames(data):
        samples = 1152 if version == 3 else 576
        for sign in (b"Xing", b"Info"):
            place = data.find(sign, at, at + 200)
            if place >= 0 and data[place + 7] & 1:
                counted = int.from_bytes(data[place + 8 : place + 12], "big") * samples
                return (counted - _padding(data, place)) / rate
        return (size - begin - at) * 8 / (kilobits * 1000)
    return None


def _padding(data: bytes, place: int) -> int:
    """Samples that the encoder added at both ends, as its tag behind the Xing header tells."""
    tags = [found for name in (b"LAME", b"Lavc", b"Lavf") if (found := data.find(name, place, place + 160)) >= 0]
    if not tags:
        return 0
    both = int.from_bytes(data[tags[0] + 21 : tags[0] + 24], "big")
    return (both >> 12) + (both & 0xFFF)


def _frames(data: bytes) -> Iterator[tuple[int, int, int, int]]:
    """Where a layer III frame may begin: its place, version bits, samples a second and kilobits."""
    for at in range(len(data) - 4):
        version, layer = data[at + 1] >> 3 & 3, data[at + 1] >> 1 & 3
        bits, speed = data[at + 2] >> 4, data[at + 2] >> 2 & 3
        begins = data[at] == 0xFF and data[at + 1] & 0xE0 == 0xE0
        if begins and version != 1 and layer == 1 and 0 < bits < 15 and speed < 3:
            yield at, version, MPEG_RATES[version][speed], KILOBITS[3 if version == 3 else 2][bits]
