"""WebVTT and SRT to times and back: words where cues have their times, else spread over the cue by their length."""

from __future__ import annotations

import html
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from facescript.speech.lines import is_unspaced, words
from facescript.speech.timing.spreading import DRAWN_OUT, spread
from facescript.speech.timing.times import TimedWord, Times, stretch, times_of, unusable

GAP, LONGEST, WIDEST = 0.6, 6.0, 80
"""A pause that ends a cue, and the most seconds and characters of one, where words are written as cues."""

ROLLED = 0.05
"""Seconds of a cue that only holds what rolls up."""

_TIME = r"(?:(\d+):)?(\d{1,2}):(\d{1,2})[.,](\d{1,3})"
_ARROW = re.compile(rf"\s*{_TIME}\s*-->\s*{_TIME}(?:\s.*)?")
_INLINE = re.compile(rf"<{_TIME}>")
_TAG = re.compile(r"<[^<>]*>|\{\\[^{}]*\}")


@dataclass(frozen=True, slots=True)
class Cue:
    """A cue as written: seconds, its lines, and the number of its line of times in the file."""

    start: float
    end: float
    lines: tuple[str, ...]
    at: int


def is_subtitles(text: str) -> bool:
    return text.lstrip().startswith("WEBVTT") or any(map(_ARROW.fullmatch, text[:4000].split("\n")[:40]))


def read_subtitles(text: str) -> Times:
    """Words of all cues. Raises `VoiceFailure`."""
    cues = list(_cues(text))
    if _INLINE.search(text):
        cues = _unrolled(cues)
    single = len(cues) > 1 and all(len(words(_plain(" ".join(cue.lines)))) < 2 for cue in cues)
    found = [word for cue in cues for word in _words(cue, single)]
    return times_of(found, duration=max((cue.end for cue in cues), default=0.0))


def _cues(text: str) -> Iterator[Cue]:
    lines = text.split("\n")
    if not text.lstrip().startswith("WEBVTT"):
        lines = [line.rstrip() for line in lines]  # in WebVTT a line of one space is a line of the cue
    number = 0
    while number < len(lines):
        line = lines[number]
        if line.startswith(("NOTE", "STYLE", "REGION")) and "-->" not in line:
            number = _block_end(lines, number)
        elif "-->" in line:
            end = _block_end(lines, number)
            yield _cue(lines[number:end], number + 1)
            number = end
        number += 1


def _block_end(lines: Sequence[str], at: int) -> int:
    """The number of the empty line behind a block, or of the next line of times where none stands between."""
    end = at + 1
    while end < len(lines) and lines[end] and "-->" not in lines[end]:
        end += 1
    return end - 1 if end < len(lines) and "-->" in lines[end] else end


def _cue(block: Sequence[str], number: int) -> Cue:
    found = _ARROW.fullmatch(block[0])
    if not found:
        raise unusable("a cue's times are written `00:00:01.000 --> 00:00:02.500`", number)
    first, last = _seconds(*found.groups()[:4]), _seconds(*found.groups()[4:])
    return Cue(*stretch(first, last, number), tuple(line for line in block[1:] if line.strip()), number)


def _seconds(hours: str | None, minutes: str, seconds: str, parts: str) -> float:
    return int((hours or "0")[:6]) * 3600 + int(minutes) * 60 + int(seconds) + int(parts.ljust(3, "0")) / 1000


def _unrolled(cues: Sequence[Cue]) -> list[Cue]:
    """The cues without the line that rolled up from the one before."""
    found: list[Cue] = []
    shown, until = "", 0.0
    for cue in cues:
        lines = cue.lines
        rolling = cue.start <= until and (len(lines) > 1 or cue.end - cue.start < ROLLED)
        if rolling and lines and shown and _plain(lines[0]) == shown:
            lines = lines[1:]
        shown, until = _plain(cue.lines[-1]) if cue.lines else "", cue.end
        if lines:
            found.append(Cue(cue.start, cue.end, lines, cue.at))
    return found


def _plain(text: str) -> str:
    return " ".join(html.unescape(_TAG.sub("", text)).replace("\u200e", "").replace("\u200f", "").split())


def _words(cue: Cue, single: bool) -> Iterator[TimedWord]:
    """The words of a cue, each in the stretch between the inline times around it; in a file where each is a cue of
    its own (`single`), that is its time."""
    text = "\n".join(cue.lines)
    edges = [(cue.start, 0, 0)]
    for found in _INLINE.finditer(text):
        time = min(max(_seconds(*found.groups()), edges[-1][0]), max(cue.end, edges[-1][0]))
        edges.append((time, found.start(), found.end()))
    edges.append((max(cue.end, edges[-1][0]), len(text), len(text)))
    timed = single or len(edges) > 2
    for (start, _, first), (end, last, _) in pairwise(edges):
        plain = _plain(text[first:last])
        inside = words(plain)
        spans = spread(plain, inside, start, end, math.inf if timed else DRAWN_OUT)
        for word, span in zip(inside, spans, strict=True):
            yield TimedWord(plain[word.first : word.last], *span)


# ------------------------------------------------------------------------------------ writing


def write_vtt(times: Times) -> str:
    """WebVTT: a cue for each stretch between pauses, its words with their times inline."""
    cues = [f"{_arrow(cue[0].start, cue[-1].end, '.')}\n{_inline(cue)}\n" for cue in grouped(times.words)]
    return "\n".join(["WEBVTT\n", *cues])


def write_srt(times: Times) -> str:
    """SRT, which knows no times inside a cue: a cue a word."""
    cues = [f"{n}\n{_arrow(word.start, word.end, ',')}\n{word.text}\n" for n, word in enumerate(times.words, 1)]
    return "\n".join(cues)


def grouped(spoken: Sequence[TimedWord]) -> list[list[TimedWord]]:
    """Words in cues: a cue ends at a pause, or where it would be too long."""
    cues: list[list[TimedWord]] = []
    for word in spoken:
        cue = cues[-1] if cues else []
        size = sum(len(each.text) + 1 for each in cue) + len(word.text)
        if not cue or word.start - cue[-1].end >= GAP or word.end - cue[0].start > LONGEST or size > WIDEST:
            cues.append([word])
        else:
            cue.append(word)
    return cues


def _inline(cue: Sequence[TimedWord]) -> str:
    """The words with the time before each but the first, and behind one that ends earlier than the next begins."""
    out = [escaped(cue[0].text)]
    for before, word in pairwise(cue):
        space = "" if is_unspaced(before.text[-1:] or " ") and is_unspaced(word.text[:1] or " ") else " "
        end, start = clock(before.end), clock(word.start)
        out.append(f"{space}<{start}>" if end == start else f"<{end}>{space}<{start}>")
        out.append(escaped(word.text))
    if len(cue) == 1:
        out.append(f"<{clock(cue[0].end)}>")  # else a reader could not know that it is the word that takes so long
    return "".join(out)


def _arrow(start: float, end: float, mark: str) -> str:
    return f"{clock(start, mark)} --> {clock(end, mark)}"


def clock(seconds: float, mark: str = ".") -> str:
    """`00:00:01.000`."""
    whole = round(seconds * 1000)
    return f"{whole // 3_600_000:02}:{whole // 60_000 % 60:02}:{whole // 1000 % 60:02}{mark}{whole % 1000:03}"


def escaped(text: str) -> str:
    """A text inside a cue of WebVTT."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
