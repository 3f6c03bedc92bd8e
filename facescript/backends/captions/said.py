"""The lines of a score to their words as they are written, with their signs and their times."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from facescript.schedule.score import Score, TimedLine
from facescript.speech.lines import is_unspaced, words
from facescript.speech.model import Spoken, WordTime
from facescript.speech.timing.spreading import spread

OPENERS = "([{‘“«‹「『（《〈【¿¡\"'"
"""Signs that stand before a word and belong to it."""

SENTENCE, CLAUSE = ".!?…。！？।؟", ",;:，、；：—–،"
"""Signs that end a sentence, and a part of one."""


@dataclass(frozen=True, slots=True)
class Token:
    """A word with the signs around it: seconds of the film, and whether there is a space before it; `ends` is 2 where
    a sentence ends with it, 1 for a part of one; `place` is its first character's in the line's text."""

    text: str
    place: int
    start: float
    end: float
    spaced: bool
    ends: int

    @property
    def columns(self) -> int:
        """How wide it is, its space with it."""
        return columns(self.text) + self.spaced


@dataclass(frozen=True, slots=True)
class Said:
    """A line as it is heard, in the language of its face's voice."""

    face: str
    language: str
    tokens: tuple[Token, ...]


def columns(text: str) -> int:
    """How wide a text is in letters; a Chinese character, and whatever is written without spaces, counts double."""
    return sum(2 if is_unspaced(sign) or "\u3000" <= sign <= "\uffef" else 1 for sign in text)


def said(score: Score, start: float, end: float) -> list[Said]:
    """What is heard between two moments, in time order; lines without a text are left out."""
    found = []
    languages = {face.name: face.voice.language for face in score.faces}
    for line in score.lines:
        kept = tuple(
            token
            for token in tokens(line.text, heard(line))
            if token.start < min(end, line.end) and (token.end > start or not start)
        )
        if kept:
            found.append(Said(line.face, languages.get(line.face, ""), kept))
    return found


def heard(line: TimedLine) -> list[WordTime]:
    """The words of a line in seconds of the film."""
    spoken = timed(line.text, line.spoken)
    return [replace(word, start=line.start + word.start, end=min(line.start + word.end, line.end)) for word in spoken]


def timed(text: str, spoken: Spoken) -> Sequence[WordTime]:
    """The words of a line in seconds from its start; by their lengths where its sound has no words."""
    if spoken.words:
        return spoken.words
    found = words(text)
    times = spread(text, found, 0.0, spoken.duration)
    return [
        WordTime(text[place.first : place.last], place.first, place.last, *at)
        for place, at in zip(found, times, strict=True)
    ]


def tokens(text: str, spoken: Sequence[WordTime]) -> list[Token]:
    """The words of a text, such as no space parts as one: an address is not torn apart."""
    found: list[Token] = []
    for token in _tokens(text, spoken):
        if found and not token.spaced and columns(found[-1].text[-1:]) < 2 and columns(token.text[:1]) < 2:
            found[-1] = replace(found[-1], text=found[-1].text + token.text, end=token.end, ends=token.ends)
        else:
            found.append(token)
    return found


def _tokens(text: str, spoken: Sequence[WordTime]) -> Iterator[Token]:
    edges = [0, *(_edge(text, a.last, b.first) for a, b in pairwise(spoken)), len(text)]
    for word, (first, after) in zip(spoken, pairwise(edges), strict=False):
        piece = text[first:after]
        tail = text[word.last : after]
        ends = 2 if any(sign in SENTENCE for sign in tail) else int(any(sign in CLAUSE for sign in tail))
        spaced = bool(piece[:1].isspace() or (first and text[first - 1].isspace()))
        yield Token(" ".join(piece.split()), first, word.start, word.end, spaced, ends)


def _edge(text: str, last: int, first: int) -> int:
    """Where, between two words, the second's part of the text begins."""
    between = text[last:first]
    for at in range(len(between) - 1, -1, -1):
        if between[at].isspace():
            return last + at + 1
    while first > last and text[first - 1] in OPENERS:
        first -= 1
    return first
