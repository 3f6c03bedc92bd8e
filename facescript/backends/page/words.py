"""The lines of a score to what a page shows of them: text as it was written, each word with its time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from html import escape

from facescript.backends.captions.cues import WIDEST, captions
from facescript.backends.captions.said import heard, tokens
from facescript.ir.acts import Say
from facescript.schedule.score import Score, TimedLine
from facescript.speech.model import WordTime
from facescript.text import Span

LANGUAGES = {"cmn": "zh", "yue": "zh-yue"}
"""espeak-ng's languages that HTML knows by another name."""


@dataclass(frozen=True, slots=True)
class Line:
    """A line as heard from `start` to `end` (seconds from the page's start): its text, and its words with their times
    from the page's start."""

    face: str
    scene: int
    text: str
    language: str
    start: float
    end: float
    words: tuple[WordTime, ...]


def lines(score: Score, start: float, end: float) -> list[Line]:
    """The lines heard between two moments of the film, in time order. Lines without text are left out."""
    found = []
    acts = _acts(score)
    for line in score.lines:
        if line.end <= start or line.start >= end:
            continue
        say, scene = _act(acts, line)
        if not say.text.strip():
            continue
        ends = min(line.end, end)
        words = tuple(
            replace(word, start=word.start - start, end=min(word.end, ends) - start)
            for word in heard(line)
            if start <= word.start < ends
        )
        language = html_language(say.voice.language)
        found.append(Line(line.face, scene, say.text, language, max(line.start, start) - start, ends - start, words))
    return found


def transcript(said: Sequence[Line], names: dict[str, str], scenes: Sequence[str]) -> str:
    """The lines as paragraphs, with the faces' `names` in front where several speak, below the titles of their
    `scenes` where there are any. All text is escaped."""
    several = len({line.face for line in said}) > 1
    parts, scene = [], -1
    for line in said:
        if line.scene != scene and scenes[line.scene]:
            parts.append(f'<h2 class="fs-scene"><bdi>{escape(scenes[line.scene])}</bdi></h2>')
        scene = line.scene
        parts.append(paragraph(line, names.get(line.face, line.face) if several else ""))
    return "\n".join(parts)


def paragraph(line: Line, speaker: str) -> str:
    """A line with a button that plays it, and its `speaker` in front where one is named. All text is escaped."""
    who = f'<span class="fs-who">{escape(speaker)}</span> ' if speaker else ""
    button = (
        f'<button class="fs-from" type="button" data-start="{line.start:.3f}" '
        f'aria-label="Play from {clock(line.start)}">{clock(line.start)}</button>'
    )
    words = "".join(_marked(line))
    return f'<p class="fs-line" lang="{escape(line.language)}">{button}{who}<bdi>{words}</bdi></p>'


def clock(seconds: float) -> str:
    """`1:02`, or `1:01:02` from an hour on."""
    whole = int(seconds)
    hours, minutes = whole // 3600, whole // 60 % 60
    return f"{hours}:{minutes:02d}:{whole % 60:02d}" if hours else f"{minutes}:{whole % 60:02d}"


def html_language(voice: str) -> str:
    """A voice's language (`en-us`, `cmn`) as HTML writes it."""
    first, *rest = voice.split("-")
    return "-".join([LANGUAGES.get(first, first), *(part.upper() if len(part) == 2 else part for part in rest)])


Said = dict[tuple[str, Span], list[tuple[float, Say, int]]]
"""What is said by whom from which place in the script: when, what, and in which scene."""


def _acts(score: Score) -> Said:
    found: Said = {}
    for act in score.acts:
        if isinstance(act.verb, Say) and act.face is not None:
            found.setdefault((act.face, act.span), []).append((act.start, act.verb, act.scene))
    return found


def _act(acts: Said, line: TimedLine) -> tuple[Say, int]:
    """What a line says, and in which scene: its act is the nearest in time of those from its place in the script."""
    _, say, scene = min(acts[line.face, line.span], key=lambda act: abs(act[0] - line.start))
    return say, scene


def _marked(line: Line) -> Iterator[str]:
    """The text with a span around each word, the first of each caption marked."""
    at = 0
    for word, begins in zip(line.words, _begins(line), strict=True):
        yield escape(line.text[at : word.first])
        cue = " data-cue" if begins else ""
        text = escape(line.text[word.first : word.last])
        yield f'<span class="fs-word" data-start="{word.start:.3f}" data-end="{word.end:.3f}"{cue}>{text}</span>'
        at = word.last
    yield escape(line.text[at:])


def _begins(line: Line) -> Iterator[bool]:
    """Whether a caption begins with each word."""
    places = [part[0].place for part in captions(tokens(line.text, line.words), WIDEST)]
    for before, word in zip([None, *line.words], line.words, strict=False):
        yield any((before.last if before else 0) <= place <= word.first for place in places)
