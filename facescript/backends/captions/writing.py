"""What is said in a film to files of captions: WebVTT, with or without the time of each word, and SRT."""

from __future__ import annotations

from itertools import chain
from pathlib import Path

from facescript.backends.captions.cues import Cue, cues, joined, named
from facescript.backends.captions.said import Token, said
from facescript.backends.job import Job
from facescript.speech.timing.subtitles import clock, escaped


def write_vtt(job: Job, path: Path) -> None:
    """WebVTT; several faces are named, and with `--captions words` each word has its time."""
    by_words = job.captions == "words"
    blocks = [
        f"{_arrow(job, cue.start, cue.end, '.')}\n{_voiced(cue, _inline(job, cue) if by_words else _plain(cue))}\n"
        for cue in cues(said(job.score, job.start, job.end))
    ]
    path.write_text("\n".join(["WEBVTT\n", *blocks]), "utf-8")


def write_srt(job: Job, path: Path) -> None:
    """SRT; a face is named where it speaks after another; with `--captions words` each word is a caption."""
    lines = said(job.score, job.start, job.end)
    if job.captions == "words":
        rows = [(token.start, token.end, token.text) for line in lines for token in line.tokens]
    else:
        rows = [(cue.start, cue.end, _with_name(cue)) for cue in named(cues(lines))]
    blocks = [
        f"{number}\n{_arrow(job, first, last, ',')}\n{text}\n" for number, (first, last, text) in enumerate(rows, 1)
    ]
    path.write_text("\n".join(blocks), "utf-8")


def _with_name(cue: Cue) -> str:
    return (f"{cue.face}: " if cue.face else "") + "\n".join(cue.texts)


def _arrow(job: Job, start: float, end: float, mark: str) -> str:
    """Times from the beginning of the output, inside it."""
    first, last = (min(max(time, job.start), job.end) - job.start for time in (start, end))
    return f"{clock(first, mark)} --> {clock(last, mark)}"


def _plain(cue: Cue) -> str:
    return "\n".join(map(escaped, cue.texts))


def _voiced(cue: Cue, text: str) -> str:
    return f"<v {escaped(cue.face)}>{text}" if cue.face else text


def _inline(job: Job, cue: Cue) -> str:
    """The lines, each word but the first with the time at which it is said."""
    first = next(chain.from_iterable(cue.lines))
    return "\n".join(
        "".join(_timed(job, token, token is first, n > 0) for n, token in enumerate(line)) for line in cue.lines
    )


def _timed(job: Job, token: Token, first: bool, inside: bool) -> str:
    time = "" if first else f"<{clock(max(token.start - job.start, 0.0))}>"
    return " " * (token.spaced and inside) + time + escaped(joined([token]))
