"""Turns the times of a file into those of a line: its words in the line's text, its phones as a line speaks them."""

from __future__ import annotations

import unicodedata
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from difflib import SequenceMatcher
from itertools import pairwise

from facescript.ir.acts import Say
from facescript.speech.lines import Word, is_letter, words
from facescript.speech.model import Doubt, PhoneTime, Spoken, WordTime
from facescript.speech.timing.matching import matches
from facescript.speech.timing.spreading import DRAWN_OUT, LEAST, spread
from facescript.speech.timing.times import NEAR, TimedWord, Times, filled, released

DIFFERS = "FS516"

PAUSE = 0.2
"""Seconds of a silence in which no word is."""

ALIKE = 0.6
"""How alike two words are that are the same, spelt differently (0 to 1, `difflib`)."""


@dataclass(frozen=True, slots=True)
class Fitted:
    """A line's words and phones (none where the file has none), and what the author should know."""

    words: tuple[WordTime, ...]
    phones: tuple[PhoneTime, ...]
    doubts: tuple[Doubt, ...] = ()


@dataclass(frozen=True, slots=True)
class _Run:
    """Words of the line, and of the file, that stand between two pairs of equal words."""

    ours: range
    theirs: range


def fitted(times: Times, line: Say) -> Fitted:
    """The words of a line at the times of the file's, which may be written a little differently."""
    ours = words(line.text)
    theirs = list(_single(times))
    texts = [line.text[word.first : word.last] for word in ours]
    phones = filled(released(times.phones), times.duration) if any(p.symbol for p in times.phones) else ()
    if not ours:
        return Fitted((), phones)
    if not theirs:
        return Fitted(_over_sounds(line.text, ours, phones, times.duration), phones)
    pairs = matches([bare(text) for text in texts], [bare(word.text) for word in theirs])
    runs = list(_runs(pairs, len(ours), len(theirs)))
    placed = _placed(line.text, ours, theirs, pairs, runs, times.duration)
    return Fitted(placed, phones, tuple(_doubts(texts, theirs, runs, bool(pairs))))


def bare(text: str) -> str:
    """A word without case, marks of width, punctuation."""
    return "".join(filter(is_letter, unicodedata.normalize("NFKC", text).casefold()))


def _single(times: Times) -> Iterator[TimedWord]:
    """The file's words, such as are several words for us as so many."""
    for word in times.words:
        parts = words(word.text)
        if len(parts) < 2:
            yield word
            continue
        for part, span in zip(parts, spread(word.text, parts, word.start, word.end), strict=True):
            yield TimedWord(word.text[part.first : part.last], *span, word.confidence)


def _runs(pairs: Sequence[tuple[int, int]], ours: int, theirs: int) -> Iterator[_Run]:
    for (a, c), (b, d) in pairwise([(-1, -1), *pairs, (ours, theirs)]):
        if b - a > 1 or d - c > 1:
            yield _Run(range(a + 1, b), range(c + 1, d))


def _placed(
    text: str,
    ours: Sequence[Word],
    theirs: Sequence[TimedWord],
    pairs: Sequence[tuple[int, int]],
    runs: Sequence[_Run],
    duration: float,
) -> tuple[WordTime, ...]:
    """Every word of the line at its pair's time; a run of others over the time of the file's words that stand there,
    or else between its neighbours."""
    spans: list[tuple[float, float]] = [(0.0, 0.0)] * len(ours)
    for i, j in pairs:
        spans[i] = theirs[j].start, theirs[j].end
    for run in runs:
        if len(run.ours) == len(run.theirs):
            for i, j in zip(run.ours, run.theirs, strict=True):
                spans[i] = theirs[j].start, theirs[j].end
        elif run.ours and run.theirs:
            start, end = theirs[run.theirs[0]].start, theirs[run.theirs[-1]].end
            spans[run.ours.start : run.ours.stop] = spread(text, [ours[i] for i in run.ours], start, end)
        elif run.ours:
            _interpolated(text, ours, spans, run.ours, duration)
    return tuple(
        WordTime(text[word.first : word.last], word.first, word.last, *span)
        for word, span in zip(ours, spans, strict=True)
    )


def _interpolated(
    text: str, ours: Sequence[Word], spans: list[tuple[float, float]], run: range, duration: float
) -> None:
    """Words that the file lacks stand in the gap between their neighbours, which give way where it is too narrow."""
    before, after = run.start - 1, run.stop
    start = spans[before][1] if before >= 0 else 0.0
    end = spans[after][0] if after < len(ours) else max(duration, start)
    if end - start >= LEAST * len(run):
        spans[run.start : run.stop] = spread(text, [ours[i] for i in run], start, end, DRAWN_OUT)
        return
    first, last = max(before, 0), min(after, len(ours) - 1)
    start, end = spans[first][0] if before >= 0 else 0.0, spans[last][1] if after == last else end
    spans[first : last + 1] = spread(text, ours[first : last + 1], start, end)


def _over_sounds(text: str, ours: Sequence[Word], phones: Sequence[PhoneTime], duration: float) -> tuple[WordTime, ...]:
    """The words of a line by their lengths over the time in which there is sound, long silences left out."""
    sounds = [(phone.start, phone.end) for phone in phones if phone.symbol or phone.end - phone.start < PAUSE]
    sounds = sounds or [(0.0, duration)]
    spans = spread(text, ours, 0.0, sum(end - start for start, end in sounds))
    clock = [0.0]
    for start, end in sounds:
        clock.append(clock[-1] + end - start)

    def real(time: float, margin: float) -> float:
        index = min(max(bisect_right(clock, time + margin) - 1, 0), len(sounds) - 1)
        return sounds[index][0] + time - clock[index]

    return tuple(
        WordTime(text[word.first : word.last], word.first, word.last, real(start, NEAR), real(end, -NEAR))
        for word, (start, end) in zip(ours, spans, strict=True)
    )


# ------------------------------------------------------------------------------------ what differs


def _doubts(texts: Sequence[str], theirs: Sequence[TimedWord], runs: Sequence[_Run], any_same: bool) -> Iterator[Doubt]:
    if not any(word.text for word in theirs):
        return
    if not any_same and len(texts) > 1:
        yield Doubt(DIFFERS, f"none of the line's {len(texts)} words is in it")
        return
    lacking = [i for run in runs for i in run.ours if not _close(run, i, texts, theirs)]
    extra = [j for run in runs if not run.ours for j in run.theirs]
    if lacking:
        rest = f", and {len(lacking) - 1} more of the line's words" if len(lacking) > 1 else ""
        yield Doubt(DIFFERS, f"it does not have `{texts[lacking[0]]}`{rest}")
    if extra:
        rest = f", and {len(extra) - 1} more words that the line lacks" if len(extra) > 1 else ", which the line lacks"
        word = theirs[extra[0]]
        yield Doubt(DIFFERS, f"it has `{word.text}` at {word.start:.2f} s{rest}")


def _close(run: _Run, number: int, texts: Sequence[str], theirs: Sequence[TimedWord]) -> bool:
    """Whether a word of the line stands in the file too, only spelt differently: `colour` and `color`, 24 and
    twenty-four."""
    if not run.theirs:
        return False
    mine, other = ("".join(bare(text) for text in part) for part in (
        [texts[i] for i in run.ours], [theirs[j].text for j in run.theirs]
    ))  # fmt: skip
    if any(map(str.isdigit, mine + other)):
        return True
    if len(run.ours) == len(run.theirs):
        mine, other = bare(texts[number]), bare(theirs[run.theirs[number - run.ours.start]].text)
    return mine == other or SequenceMatcher(None, mine[:200], other[:200], autojunk=False).ratio() >= ALIKE


# ------------------------------------------------------------------------------------ the voice's phones


def voiced(spoken: Spoken, placed: Sequence[WordTime], duration: float) -> tuple[PhoneTime, ...]:
    """The phones with which a voice speaks a line, each word's moved and stretched into the time of that word."""
    knots = [(0.0, 0.0)]
    starts = {word.first: word for word in spoken.words}
    for word in placed:
        theirs = starts.get(word.first)
        if theirs is not None and theirs.end > theirs.start and theirs.start >= knots[-1][0]:
            knots += [(theirs.start, max(word.start, knots[-1][1])), (theirs.end, max(word.end, knots[-1][1]))]
    knots.append((max(spoken.duration, knots[-1][0]), max(duration, knots[-1][1])))
    times = [time for time, _ in knots]

    def moved(time: float) -> float:
        at = min(max(bisect_right(times, time) - 1, 0), len(knots) - 2)
        (a, x), (b, y) = knots[at], knots[at + 1]
        return x + (y - x) * min((time - a) / (b - a), 1.0) if b > a else y

    return filled([replace(phone, start=moved(phone.start), end=moved(phone.end)) for phone in spoken.phones], duration)
