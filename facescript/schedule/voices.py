"""Lines to their sound and their words' times: each line is spoken once, however often it is played."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Collection
from dataclasses import dataclass, field, replace

from facescript.ir.acts import Say
from facescript.ir.wording import marked, occurrences
from facescript.speech.model import Doubt, Spoken, VoiceBox, VoiceFailure, WordTime
from facescript.text import Span

CLOSE = 1e-6
"""Seconds within which two times are one."""

SILENT = Spoken(b"", 22_050, 0.0, (), (), estimated=True)
"""What stands in for a line that cannot be spoken."""


@dataclass(slots=True)
class Voices:
    """A voice box that remembers what it has spoken, what it could not, and where words stand. `alike` are lines that
    were spoken elsewhere, `outside` those that hang on files."""

    box: VoiceBox
    alike: dict[Say, Spoken | VoiceFailure] = field(default_factory=dict)
    failures: list[tuple[Span, VoiceFailure]] = field(default_factory=list)
    doubts: list[tuple[Span, Say, Doubt]] = field(default_factory=list)
    outside: list[tuple[Say, Spoken]] = field(default_factory=list)
    _spoken: dict[int, Spoken] = field(default_factory=dict)
    _places: dict[tuple[str, str], tuple[tuple[int, int], ...]] = field(default_factory=dict)

    def speak(self, line: Say, span: Span) -> Spoken:
        """The line as sound; `span` is where it stands."""
        known = self._spoken.get(id(line))
        if known is None:
            known = self._spoken[id(line)] = self._first(line, span)
        return known

    def _first(self, line: Say, span: Span) -> Spoken:
        bare = replace(line, cues=())
        spoken = self.alike.get(bare)
        if spoken is None:
            spoken = self.alike[bare] = spoken_by(self.box, line)
        if isinstance(spoken, VoiceFailure):
            self.failures.append((span, spoken))
            return SILENT
        if line.recording or line.times:
            self.outside.append((bare, spoken))
        self.doubts += ((span, bare, doubt) for doubt in spoken.doubts)
        return spoken

    def forget(self, kept: Collection[Say]) -> None:
        """Know no lines any more but those `kept`, which have no cues."""
        for line in [line for line in self.alike if line not in kept]:
            del self.alike[line]
        for known in (self._spoken, self._places, self.failures, self.doubts, self.outside):
            known.clear()

    def word(self, line: Say, span: Span, word: str, nth: int) -> tuple[float, float]:
        """Seconds from the line's start to the start and the end of a word. Raises `ValueError` where the play asks
        for a word that the line does not have."""
        marks = marked(line, word)
        if 1 <= nth <= len(marks):
            time = _at_mark(line, marks[nth - 1], self.speak(line, span))
            return time, time
        key = (line.text, word)
        if key not in self._places:
            self._places[key] = occurrences(*key)
        places = self._places[key]
        spoken = self.speak(line, span)
        if not places and line.times is not None:
            return self._in_file(spoken, word, nth)
        if not 1 <= nth <= len(places):
            raise ValueError(f"the play asks for {word!r}, number {nth}, in a line without it")
        first, last = places[nth - 1]
        return starts_at(spoken, first), ends_at(spoken, last)

    def _in_file(self, spoken: Spoken, name: str, nth: int) -> tuple[float, float]:
        """The moment of a mark in the line's file of times; any for a file that could not be read, which is told."""
        times = [time for mark, time in spoken.marks if mark == name]
        if not 1 <= nth <= len(times) and not self.failures:
            raise ValueError(f"the play asks for {name!r}, number {nth}, in a line without it")
        time = times[nth - 1] if times else 0.0
        return time, time


def spoken_by(box: VoiceBox, line: Say) -> Spoken | VoiceFailure:
    """A line as sound, or why there is none."""
    try:
        return box.speak(line)
    except VoiceFailure as failure:
        return failure


def _at_mark(line: Say, number: int, spoken: Spoken) -> float:
    """When a mark is passed: as the next word begins, or as the word before it ends where a pause follows it."""
    mark = line.stretches[number]
    later = (stretch for stretch in line.stretches[number + 1 :] if stretch.start == mark.start)
    if any(stretch.kind in ("breath", "pause") for stretch in later):
        return ends_at(spoken, mark.start)
    return starts_at(spoken, mark.start)


def starts_at(spoken: Spoken, character: int) -> float:
    """When what stands from a character of the text on begins to sound; the line's end after the last word."""
    index = _word(spoken, character)
    if index == len(spoken.words):
        return spoken.duration
    word = spoken.words[index]
    return word.start if character <= word.first else _within(word, character)


def ends_at(spoken: Spoken, character: int) -> float:
    """When what stands before a character of the text has sounded; the line's start before the first word."""
    index = _word(spoken, character)
    if index < len(spoken.words) and spoken.words[index].first < character:
        return _within(spoken.words[index], character)
    return spoken.words[index - 1].end if index else 0.0


def word_end(spoken: Spoken, time: float) -> float:
    """The end of the word that has begun by `time` (from the line's start); `time` itself between words."""
    index = bisect_left(spoken.words, time - CLOSE, key=lambda word: word.start) - 1
    return max(time, spoken.words[index].end) if index >= 0 else time


def whole_words(spoken: Spoken, time: float) -> float:
    """The end of the last word that is over by `time` (from the line's start); `time` where none is."""
    ends = [word.end for word in spoken.words if word.end <= time + CLOSE]
    return max(ends, default=time)


def _word(spoken: Spoken, character: int) -> int:
    """The index of the first word that reaches beyond a character."""
    return bisect_right(spoken.words, character, key=lambda word: word.last)


def _within(word: WordTime, character: int) -> float:
    share = (character - word.first) / (word.last - word.first)
    return word.start + (word.end - word.start) * share
