"""A line that names a file of times to speech: its sound, if it has one, with the words and phones of the file."""

from __future__ import annotations

from dataclasses import replace

from facescript.ir.acts import Say
from facescript.speech.model import Doubt, PhoneTime, Spoken, VoiceBox, VoiceFailure, WordTime
from facescript.speech.timing.files import read_times
from facescript.speech.timing.fitting import DIFFERS, Fitted, fitted, voiced
from facescript.speech.timing.text import LARGEST
from facescript.speech.timing.times import UNUSABLE, Times, unusable
from facescript.world import World, WorldFailure

RATE = 22_050

LATE = 0.15
"""Seconds by which times may go on after a recording's end without a word."""


def timed(line: Say, world: World, voice: VoiceBox, sound: Spoken | None) -> Spoken:
    """The line at the times of its file: with the `sound` of its recording, or silent, for then it sounds elsewhere.
    Where the file has no phones they are those of `voice`. Raises `VoiceFailure` (FS515)."""
    times = times_named(line, world)
    placed = fitted(times, line)
    base = sound or Spoken(b"", RATE, times.duration, (), ())
    phones = placed.phones or _spoken(line, times, placed, voice)
    doubts = (*base.doubts, *placed.doubts)
    spoken = replace(base, words=placed.words, phones=phones, doubts=doubts, marks=_marks(times))
    return _within(spoken, sound is not None)


def estimated(line: Say, world: World) -> Spoken:
    """As `timed`, as far as the file says it; where the line sounds, its recording may end otherwise."""
    times = times_named(line, world)
    placed = fitted(times, line)
    phones = placed.phones or (PhoneTime("", 0.0, times.duration),)
    guessed = line.recording is not None
    return Spoken(b"", RATE, times.duration, placed.words, phones, guessed, placed.doubts, _marks(times))


def has_mark(line: Say, world: World, name: str, nth: int) -> bool:
    """Whether the line's file of times has the `nth` mark `name`; of a file that cannot be used it is not told here."""
    try:
        return 1 <= nth <= [mark for mark, _ in _marks(times_named(line, world))].count(name)
    except VoiceFailure:
        return True


def _marks(times: Times) -> tuple[tuple[str, float], ...]:
    return tuple((mark.name, mark.time) for mark in times.marks)


def times_named(line: Say, world: World) -> Times:
    """What the line's file of times says. Raises `VoiceFailure` (FS515)."""
    assert line.times is not None
    try:
        times = read_times(line.times, world.read(line.times, LARGEST))
    except WorldFailure as failure:
        raise VoiceFailure(failure.args[0], UNUSABLE) from None
    if not times.words and not times.phones:
        raise unusable("there are no words or phones in it")
    return times


def _spoken(line: Say, times: Times, placed: Fitted, voice: VoiceBox) -> tuple[PhoneTime, ...]:
    """The voice's phones at the times of the words; a line without a text says the words of the file."""
    plain = replace(line, recording=None, times=None)
    if not line.text:
        plain = replace(plain, text=" ".join(word.text for word in times.words), stretches=())
        placed = fitted(times, plain)
    return voiced(voice.speak(plain), placed.words, times.duration)


def _within(spoken: Spoken, sounds: bool) -> Spoken:
    """The line without what lies after the end of its recording."""
    ends = [*(word.end for word in spoken.words[-1:]), *(phone.end for phone in spoken.phones if phone.symbol)]
    last = max(ends, default=0.0)
    if not sounds or last <= spoken.duration:
        return spoken
    end = spoken.duration
    words = tuple(
        WordTime(word.text, word.first, word.last, min(word.start, end), min(word.end, end)) for word in spoken.words
    )
    phones = tuple(replace(phone, end=min(phone.end, end)) for phone in spoken.phones if phone.start < end)
    reason = f"its times go on to {last:.2f} s, and the recording ends at {end:.2f} s"
    doubts = (*spoken.doubts, Doubt(DIFFERS, reason)) if last - end > LATE else spoken.doubts
    return replace(spoken, words=words, phones=phones, doubts=doubts)
