"""A chapter to its media overlay: SMIL that says which stretch of the sound each word is."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from facescript.backends.chapters import Chapter
from facescript.backends.epub.chapter import TITLE, line_id, word_id
from facescript.backends.epub.names import HEAD

LEAST = 0.01
"""Seconds of the shortest stretch: players make nothing of a shorter one."""


@dataclass(frozen=True, slots=True)
class Clip:
    """The element `target` of a page is read from `start` to `end` (seconds of the chapter's sound); `line` is the
    number of its line, 0 for the heading."""

    target: str
    line: int
    start: float
    end: float


def clips(chapter: Chapter) -> list[Clip]:
    """What is read when. Each clip ends where the next begins, as players play one after another: the heading stands
    for the silence before the first word, a word for the pause behind it."""
    marks = list(_marks(chapter))
    ends = [*(start for _, _, start in marks[1:]), round(chapter.duration, 3)]
    return [Clip(target, line, start, end) for (target, line, start), end in zip(marks, ends, strict=True)]


def _marks(chapter: Chapter) -> Iterator[tuple[str, int, float]]:
    """What begins when; a word that begins with another or at the chapter's end is left to that other."""
    last = 0.0
    yield TITLE, 0, last
    for number, line in enumerate(chapter.lines, start=1):
        for place, word in enumerate(line.words, start=1):
            start = word.start - chapter.start
            if last + LEAST <= start <= chapter.duration - LEAST:
                last = round(start, 3)
                yield word_id(number, place), number, last


def overlay_document(chapter: Chapter, page: str, sound: str) -> str:
    """The overlay of a chapter whose text is the file `page` and whose sound is the file `sound`."""
    parts, line = [], 0
    for number, clip in enumerate(clips(chapter), start=1):
        if clip.line != line:
            parts += ["</seq>"] if line else []
            parts.append(f'<seq id="s{clip.line}" epub:textref="{page}#{line_id(clip.line)}">')
            line = clip.line
        parts.append(
            f'<par id="p{number}"><text src="{page}#{clip.target}"/>'
            f'<audio src="{sound}" clipBegin="{clip.start:.3f}s" clipEnd="{clip.end:.3f}s"/></par>'
        )
    parts += ["</seq>"] if line else []
    body = "\n".join(parts)
    return (
        f'{HEAD}<smil xmlns="http://www.w3.org/ns/SMIL" xmlns:epub="http://www.idpf.org/2007/ops" version="3.0">\n'
        f'<body epub:textref="{page}">\n{body}\n</body>\n</smil>\n'
    )
