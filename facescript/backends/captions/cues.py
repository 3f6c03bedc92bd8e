"""Words as they are said to captions that can be read: two lines at most, long enough, and ended where the sense is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from facescript.backends.captions.said import Said, Token

WIDEST, LINES = 42, 2
"""Columns of a line, and lines of a caption."""

SHORTEST, LONGEST = 1.0, 7.0
"""Seconds that a caption stays at least, where nothing follows, and at most."""

LINGER, BETWEEN = 0.3, 0.08
"""Seconds that it stays after its last word, and between it and the next."""

PAUSE = 0.6
"""A silence that ends a caption."""

NEAR = 8
"""Captions among which the next one is looked for: others may be said at the same time."""

BRIEF = 24
"""Columns of a sentence so short that the next may stand beside it."""

CUT, UNEVEN, ONE_MORE, HALVED = 2.0, 1.5, 0.6, 0.35
"""What it costs to end a caption inside a clause, to leave it empty, to make another, and to end a line in a clause."""


@dataclass(frozen=True, slots=True)
class Cue:
    """A caption: seconds of the film, whose it is ("" where one face alone speaks, or the same goes on), its lines, and
    the language of the voice."""

    face: str
    start: float
    end: float
    lines: tuple[tuple[Token, ...], ...]
    language: str

    @property
    def texts(self) -> tuple[str, ...]:
        return tuple(joined(line) for line in self.lines)


def joined(tokens: Sequence[Token]) -> str:
    return "".join(" " * (token.spaced and number > 0) + token.text for number, token in enumerate(tokens))


def cues(lines: Sequence[Said], widest: int = WIDEST) -> list[Cue]:
    """The captions of what is said, in time order, each `widest` columns wide at most."""
    several = len({line.face for line in lines}) > 1
    found = [
        Cue(line.face if several else "", part[0].start, part[-1].end, wrapped(part, widest), line.language)
        for line in lines
        for part in captions(line.tokens, widest)
    ]
    found.sort(key=lambda cue: cue.start)
    return [_timed(cue, found[number + 1 : number + NEAR]) for number, cue in enumerate(found)]


def _timed(cue: Cue, after: Sequence[Cue]) -> Cue:
    """A caption that stays as long as it takes to read, but not into the next."""
    end = max(cue.end + LINGER, cue.start + SHORTEST)
    following = next((other.start for other in after if other.start >= cue.end - 1e-6), math.inf)
    return replace(cue, end=max(min(end, following - BETWEEN), min(cue.end, following)))


def captions(tokens: Sequence[Token], widest: int) -> list[Sequence[Token]]:
    """What each caption of a line holds: a sentence, a part of one, or a short sentence beside another."""
    kept: list[Sequence[Token]] = []
    for sentence in _sentences(tokens):
        parts = _parts(sentence, widest)
        if kept and len(parts) == 1 and _goes_with(kept[-1], sentence, widest):
            kept[-1] = [*kept[-1], *sentence]
        else:
            kept += parts
    return kept


def _sentences(tokens: Sequence[Token]) -> list[list[Token]]:
    """Sentences; a pause ends one too."""
    found: list[list[Token]] = []
    for token in tokens:
        if found and not (found[-1][-1].ends == 2 or token.start - found[-1][-1].end >= PAUSE):
            found[-1].append(token)
        else:
            found.append([token])
    return found


def _goes_with(before: Sequence[Token], sentence: Sequence[Token], widest: int) -> bool:
    short = min(_width(before), _width(sentence)) <= BRIEF
    return short and sentence[0].start - before[-1].end < PAUSE and _fits([*before, *sentence], widest)


def _width(tokens: Sequence[Token]) -> int:
    return sum(token.columns for token in tokens) - tokens[0].spaced


def _fits(tokens: Sequence[Token], widest: int) -> bool:
    return tokens[-1].end - tokens[0].start <= LONGEST and len(_filled(tokens, widest)) <= LINES


def _filled(tokens: Sequence[Token], widest: int) -> list[int]:
    """Where lines begin that each hold as much as they can."""
    begins, width = [0], 0
    for number, token in enumerate(tokens):
        if number > begins[-1] and width + token.columns > widest:
            begins.append(number)
        width = token.columns - token.spaced if number == begins[-1] else width + token.columns
    return begins


def _parts(tokens: Sequence[Token], widest: int) -> list[Sequence[Token]]:
    """A sentence in as few captions as hold it, cut where it costs least (dynamic programming over its words)."""
    if _fits(tokens, widest):
        return [tokens]
    best = [0.0] + [math.inf] * len(tokens)
    cut = [0] * (len(tokens) + 1)
    for start in range(len(tokens)):
        for end in range(start + 1, _reach(tokens, start, widest) + 1):
            cost = best[start] + _cost(tokens[start:end], widest, end == len(tokens))
            if cost < best[end]:
                best[end], cut[end] = cost, start
    edges = [len(tokens)]
    while edges[-1]:
        edges.append(cut[edges[-1]])
    return [tokens[first:last] for first, last in pairwise(reversed(edges))]


def _reach(tokens: Sequence[Token], start: int, widest: int) -> int:
    """The last word, one past it, of the longest caption from a word on; it has at least one."""
    near = tokens[start : start + LINES * widest]
    begins = _filled(near, widest)
    end = start + (begins[LINES] if len(begins) > LINES else len(near))
    while end - start > 1 and tokens[end - 1].end - tokens[start].start > LONGEST:
        end -= 1
    return end


def _cost(part: Sequence[Token], widest: int, last: bool) -> float:
    full = min(_width(part) / (LINES * widest), 1.0)
    inside = 0.0 if last or part[-1].ends else CUT
    return ONE_MORE + inside + UNEVEN * (1 - full) ** 2


def wrapped(tokens: Sequence[Token], widest: int) -> tuple[tuple[Token, ...], ...]:
    """The lines of a caption: one where it fits, else two as even as can be, cut behind a sign rather than not; more
    where the words are too wide."""
    begins = _filled(tokens, widest)
    if len(begins) == LINES:
        places = [at for at in range(1, len(tokens)) if max(map(_width, (tokens[:at], tokens[at:]))) <= widest]
        begins = [0, min(places, key=lambda at: _unevenness(tokens[:at], tokens[at:], widest), default=begins[1])]
    return tuple(tuple(tokens[first:last]) for first, last in pairwise([*begins, len(tokens)]))


def _unevenness(first: Sequence[Token], second: Sequence[Token], widest: int) -> float:
    return abs(_width(first) - _width(second)) / widest + (0.0 if first[-1].ends else HALVED)


def named(found: Sequence[Cue]) -> list[Cue]:
    """Captions of which only those name a face that speaks after another."""
    before = ""
    kept = []
    for cue in found:
        kept.append(replace(cue, face=cue.face if cue.face != before else ""))
        before = cue.face
    return kept
