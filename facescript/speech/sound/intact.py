"""A sound file to whether its end is missing: less is in it than its head promises."""

from __future__ import annotations

from pathlib import Path
from typing import BinaryIO

from facescript.speech.sound.length import MOST_CHUNKS, TAIL, seconds_of

TOLERANCE = 0.1
"""Seconds that may lack: a coder's last block."""

UNKNOWN = (0, 0xFFFFFFFF, 0x7FFFFFFF)
"""What a program writes for the length of sound that it has not ended yet: it promises nothing."""

HEAD = 1 << 16
"""Bytes in which an MP3 file that counts its frames says so."""


def breaks_off(path: Path, form: str, seconds: float) -> bool:
    """Whether a file of a form (ffmpeg's name) is cut short, of which `seconds` could be heard. Raises `OSError`."""
    with path.open("rb") as file:
        size = file.seek(0, 2)
        file.seek(0)
        if form == "wav":
            return _wav_is_short(file, size)
        if form == "ogg":
            return _ogg_is_open(file, size)
        head = file.read(HEAD)
    if form == "mp3" and b"Xing" not in head and b"Info" not in head:
        return False
    return seconds < (seconds_of(path) or 0.0) - TOLERANCE


def _wav_is_short(file: BinaryIO, size: int) -> bool:
    """Whether the chunk of sound goes on behind the end of the file."""
    file.seek(12)
    long = 0
    for _ in range(MOST_CHUNKS):
        head = file.read(8)
        length = int.from_bytes(head[4:], "little")
        if len(head) < 8:
            return True
        if head[:4] == b"data":
            promised = long if length == 0xFFFFFFFF and long else length
            return promised not in UNKNOWN and promised > size - file.tell()
        if head[:4] == b"ds64":
            long = int.from_bytes(file.read(16)[8:], "little")
            length -= 16
        file.seek(length + length % 2, 1)
    return False


def _ogg_is_open(file: BinaryIO, size: int) -> bool:
    """Whether the last page does not say that it is the last, or is not whole."""
    file.seek(max(size - TAIL, 0))
    tail = file.read()
    at = tail.rfind(b"OggS")
    if at < 0 or len(tail) < at + 27:
        return True
    count = tail[at + 26]
    return not tail[at + 5] & 4 or at + 27 + count + sum(tail[at + 27 : at + 27 + count]) > len(tail)
