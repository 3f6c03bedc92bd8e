"""What a file of times says: words, phones and marks in seconds; and the two ways to count a plosive."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from facescript.speech.model import PhoneTime, VoiceFailure
from facescript.speech.mouth.visemes import visemes

UNUSABLE = "FS515"

LONGEST = 24 * 3600.0
"""Seconds that a file may speak of."""

MOST = 500_000
"""Words, phones or marks of a file."""

CLOSURE, CLOSED = 0.055, 0.6
"""Seconds from the beginning of a labelled plosive to its burst, and the most of its length that they take."""

NEAR = 1e-4
"""Seconds that are no gap."""


@dataclass(frozen=True, slots=True)
class TimedWord:
    """A word in seconds; `confidence` 0..1 is how sure its maker was."""

    text: str
    start: float
    end: float
    confidence: float = 1.0


@dataclass(frozen=True, slots=True)
class TimedMark:
    """A named moment, in seconds."""

    name: str
    time: float


@dataclass(frozen=True, slots=True)
class Times:
    """Words, phones and marks, each in order, none over the next; seconds from the beginning of the sound.

    Phones are as people label them: a plosive begins with its closure (`released` makes them a `Spoken`'s, `closed`
    goes back). A symbol is IPA, "" silence, or a mouth shape (`PhoneTime`). Any of the three may be empty.
    """

    words: tuple[TimedWord, ...]
    phones: tuple[PhoneTime, ...]
    duration: float
    marks: tuple[TimedMark, ...] = ()


Entry = TypeVar("Entry", TimedWord, PhoneTime)


def unusable(reason: str, line: int | None = None) -> VoiceFailure:
    """The failure of a file of times, at a line of it."""
    return VoiceFailure(reason if line is None else f"{reason} (line {line})", UNUSABLE)


def moment(text: object, line: int | None = None) -> float:
    """A number of seconds. Raises `VoiceFailure` where it is none that sound could have."""
    try:
        seconds = float(text)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        raise unusable(f"`{str(text)[:40]}` is no time in seconds", line) from None
    if not math.isfinite(seconds) or not -NEAR < seconds <= LONGEST:
        raise unusable(f"a time of {seconds:g} s is outside 0 to {LONGEST / 3600:g} hours", line)
    return max(seconds, 0.0)


def stretch(start: object, end: object, line: int | None = None) -> tuple[float, float]:
    """A beginning and an end in seconds. Raises `VoiceFailure` where the end is earlier."""
    first, last = moment(start, line), moment(end, line)
    if last < first - NEAR:
        raise unusable(f"it ends at {last:g} s, before it begins at {first:g} s", line)
    return first, max(first, last)


def times_of(
    words: Iterable[TimedWord],
    phones: Iterable[PhoneTime] = (),
    marks: Iterable[TimedMark] = (),
    duration: float = 0.0,
) -> Times:
    """Times in order: what overlaps ends where the next begins, what lies between phones is silence. Raises
    `VoiceFailure` where there is nothing, or too much."""
    kept_words = in_turn(words)
    kept_phones = in_turn(phones)
    kept_marks = tuple(sorted(marks, key=lambda mark: mark.time))
    if not (kept_words or kept_phones or kept_marks):
        raise unusable("there are no words, phones or marks in it")
    if max(map(len, (kept_words, kept_phones, kept_marks))) > MOST:
        raise unusable(f"it has more than {MOST} entries")
    ends = [*(word.end for word in kept_words[-1:]), *(phone.end for phone in kept_phones[-1:])]
    last = max([duration, *ends, *(mark.time for mark in kept_marks[-1:])])
    return Times(kept_words, filled(kept_phones, last) if kept_phones else (), last, kept_marks)


def in_turn(entries: Iterable[Entry]) -> tuple[Entry, ...]:
    """Words or phones by their time, each at its end where the next begins."""
    found = sorted(entries, key=lambda entry: (entry.start, entry.end))
    for at, after in enumerate(found[1:]):
        found[at] = replace(found[at], end=min(found[at].end, after.start))
    return tuple(found)


def filled(phones: Sequence[PhoneTime], duration: float) -> tuple[PhoneTime, ...]:
    """The phones with silence wherever there is none, silences that follow each other as one."""
    found: list[PhoneTime] = []
    at = 0.0
    for phone in (*phones, PhoneTime("", duration, duration)):
        if phone.start - at > NEAR:
            _append(found, PhoneTime("", at, phone.start))
        if phone.symbol or phone.end > phone.start:
            _append(found, phone)
        at = max(at, phone.end)
    return tuple(found)


def _append(found: list[PhoneTime], phone: PhoneTime) -> None:
    if found and not found[-1].symbol and not phone.symbol:
        found[-1] = replace(found[-1], end=phone.end)
    else:
        found.append(phone)


def released(phones: Sequence[PhoneTime]) -> tuple[PhoneTime, ...]:
    """Labelled phones as a `Spoken` has them: a plosive from its burst, its closure in what is before."""
    found: list[PhoneTime] = []
    for phone in phones:
        if found and is_plosive(phone) and phone.start - found[-1].end < NEAR:
            burst = phone.start + min(CLOSURE, CLOSED * (phone.end - phone.start))
            found[-1] = replace(found[-1], end=burst)
            phone = replace(phone, start=burst)
        found.append(phone)
    return tuple(found)


def closed(phones: Sequence[PhoneTime]) -> tuple[PhoneTime, ...]:
    """The phones of a `Spoken` as people label them: a plosive from its closure, which takes at most half of what is
    before."""
    found: list[PhoneTime] = []
    for phone in phones:
        if found and is_plosive(phone) and phone.start - found[-1].end < NEAR:
            before = found[-1]
            start = before.end - min(CLOSURE, (before.end - before.start) / 2)
            found[-1] = replace(before, end=start)
            phone = replace(phone, start=start)
        found.append(phone)
    return tuple(found)


def is_plosive(phone: PhoneTime) -> bool:
    """Whether a phone begins with a closure."""
    return bool(phone.symbol) and any(viseme.kind == "stop" for viseme in visemes(phone.symbol)[:1])
