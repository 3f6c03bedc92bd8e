"""The bytes of a file of times to its text, and lines with their numbers."""

from __future__ import annotations

import codecs

from facescript.speech.timing.times import unusable

LARGEST = 32 * 1024 * 1024
"""Bytes of a file of times."""

_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_BE, "utf-16"),
    (codecs.BOM_UTF16_LE, "utf-16"),
)


def text_of(data: bytes) -> str:
    """UTF-8 or UTF-16 with plain line ends. Raises `VoiceFailure` where it is neither."""
    if len(data) > LARGEST:
        raise unusable(f"it is larger than {LARGEST >> 20} MiB")
    try:
        text = data.decode(_encoding(data))
    except UnicodeDecodeError as fault:
        raise unusable("it is neither UTF-8 nor UTF-16 text", data.count(b"\n", 0, fault.start) + 1) from None
    if "\0" in text:
        raise unusable("it is not text")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _encoding(data: bytes) -> str:
    for mark, encoding in _MARKS:
        if data.startswith(mark):
            return encoding
    if data[:1] == b"\0":
        return "utf-16-be"
    return "utf-16-le" if data[1:2] == b"\0" else "utf-8"


def line_at(text: str, at: int) -> int:
    """The number of the line, from 1, in which a character stands."""
    return text.count("\n", 0, at) + 1
