"""A file of times of any kind to `Times`, and `Times` to the bytes of a file."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from facescript.speech.timing.objects import is_json, read_json, write_json
from facescript.speech.timing.rhubarb import is_tsv, read_tsv, write_tsv
from facescript.speech.timing.subtitles import is_subtitles, read_subtitles, write_srt, write_vtt
from facescript.speech.timing.table import is_table, read_table, write_table
from facescript.speech.timing.text import text_of
from facescript.speech.timing.textgrid import is_textgrid, read_textgrid, write_textgrid
from facescript.speech.timing.times import Times, unusable

READERS = (
    (is_textgrid, read_textgrid),
    (is_json, read_json),
    (is_subtitles, read_subtitles),
    (is_tsv, read_tsv),
    (is_table, read_table),
)
"""What tells a kind of file by its text, and what reads it."""

WRITERS: Mapping[str, Callable[[Times], str]] = MappingProxyType(
    {
        ".textgrid": write_textgrid,
        ".json": write_json,
        ".vtt": write_vtt,
        ".srt": write_srt,
        ".csv": write_table,
        ".tsv": write_tsv,
    }
)
"""What writes a file with a suffix (in small letters)."""

BY_SUFFIX = {
    ".textgrid": read_textgrid,
    ".json": read_json,
    ".vtt": read_subtitles,
    ".srt": read_subtitles,
    ".tsv": read_tsv,
    ".csv": read_table,
}
"""What tells of the fault of a file that is of no kind by its text."""


def read_times(name: str, data: bytes) -> Times:
    """The times in a file: its kind is told by what is in it. Raises `VoiceFailure` (FS515)."""
    text = text_of(data)
    if not text.strip():
        raise unusable("it is empty")
    for is_kind, read in READERS:
        if is_kind(text):
            return read(text)
    read_anyway = BY_SUFFIX.get(suffix_of(name))
    if read_anyway is None:
        raise unusable("it is no TextGrid, JSON, WebVTT, SRT, TSV or CSV of times")
    return read_anyway(text)


def write_times(times: Times, suffix: str) -> bytes:
    """The bytes of a file of times; `suffix` is one of `WRITERS`."""
    return WRITERS[suffix.lower()](times).encode()


def suffix_of(name: str) -> str:
    return f".{name.rpartition('.')[2].lower()}"
