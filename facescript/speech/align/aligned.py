"""A recording and its words to when each word and phone is said, and how sure that is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from facescript.ir.acts import Say
from facescript.speech.align.activity import Stretch, speaking
from facescript.speech.align.course import Course, course
from facescript.speech.align.edges import Edges
from facescript.speech.align.features import Floats, spectrum
from facescript.speech.align.likeness import Likeness, confidences, doubts
from facescript.speech.align.piece import heard
from facescript.speech.align.reference import HOP, Reference, joined, reference
from facescript.speech.align.segments import fitting, pauses_between
from facescript.speech.align.sentences import sentences
from facescript.speech.model import Doubt, PhoneTime, VoiceBox, WordTime
from facescript.speech.sound.recording import Recording
from facescript.speech.timing.fitting import fitted, voiced
from facescript.speech.timing.times import TimedWord, Times

VOICES = ("", "f3", "m3")
"""The variants that say the text: the median of their times is taken."""

QUIET = 0.03
"""Seconds of quiet kept around a stretch of speech: it is compared with voices that have as much."""

SILENCE = 0.1
"""Seconds between two pieces that are a silence of their own."""

SOMETHING = "ə"
"""A sound of any kind."""


@dataclass(frozen=True, slots=True)
class Alignment:
    """Words by characters of the line, with a confidence (0..1) each; phones as a `Spoken` has them, and when each
    begins as people label it (a plosive with its closure). Seconds of the recording, which has `duration`."""

    words: tuple[WordTime, ...]
    confidences: tuple[float, ...]
    phones: tuple[PhoneTime, ...]
    labelled: tuple[float, ...]
    duration: float
    doubts: tuple[Doubt, ...] = ()

    def times(self) -> Times:
        """What a file of times says of it."""
        words = (
            TimedWord(word.text, word.start, word.end, round(sure, 3))
            for word, sure in zip(self.words, self.confidences, strict=True)
        )
        ends = [*self.labelled[1:], self.phones[-1].end if self.phones else 0.0]
        phones = (
            replace(phone, start=start, end=max(start, min(phone.end, end) if _shape(phone) else end))
            for phone, start, end in zip(self.phones, self.labelled, ends, strict=True)
        )
        return Times(tuple(words), tuple(phones), self.duration)


@dataclass(frozen=True, slots=True)
class _Task:
    """The sentences number `first` and on, before `last`, said in a stretch of the recording."""

    first: int
    last: int
    stretch: Stretch


class _Aligner:
    """A recording and a line on their way to an `Alignment`."""

    def __init__(self, recording: Recording, line: Say, voice: VoiceBox) -> None:
        self.recording, self.line, self.voice = recording, line, voice
        self.bands = spectrum(recording.samples, recording.rate, HOP)
        self.spoken = speaking(self.bands, HOP)
        self.spans = sentences(line)
        self.first = [reference(line, span, VOICES[0], voice) for span in self.spans]

    def aligned(self, pauses: Sequence[Stretch] | None) -> Alignment:
        if not self.spoken:
            return self.spread((Doubt("FS510", "nobody is heard in it"),))
        way = course(self.bands, self.spoken, self.first)
        words: list[WordTime] = []
        phones: list[PhoneTime] = []
        labelled: list[float] = []
        frames: list[Likeness] = []
        for task in self._tasks(way, pauses_between(self.spoken) if pauses is None else pauses):
            heard_words, heard_phones, starts, likeness = self._heard(task, way)
            gap = heard_phones[0].start - (phones[-1].end if phones else 0.0)
            if gap > SILENCE:
                phones.append(PhoneTime("", heard_phones[0].start - gap, heard_phones[0].start))
                labelled.append(phones[-1].start)
            words += heard_words
            phones += heard_phones
            labelled += starts
            frames.append(likeness)
        sure = confidences(words, frames)
        found = doubts(words, sure, frames, self._pace())
        if any(doubt.code == "FS510" for doubt in found):
            return self.spread(found)
        duration = self.recording.duration
        if phones[-1].end < duration - SILENCE:
            labelled.append(phones[-1].end)
            phones.append(PhoneTime("", phones[-1].end, duration))
        return Alignment(tuple(words), sure, tuple(phones), tuple(labelled), duration, found)

    def spread(self, found: tuple[Doubt, ...]) -> Alignment:
        """The words by their usual lengths over the speech that there is, or else over all of it."""
        duration = self.recording.duration
        sounds = tuple(PhoneTime(SOMETHING, each.start, each.end) for each in self.spoken)
        words = fitted(Times((), sounds, duration), self.line).words
        phones = voiced(self.voice.speak(_plain(self.line)), words, duration)
        starts = tuple(phone.start for phone in phones)
        return Alignment(words, (0.0,) * len(words), phones, starts, duration, found)

    def _tasks(self, way: Course, pauses: Sequence[Stretch]) -> Iterator[_Task]:
        """The recording cut at the pauses before sentences."""
        places = np.cumsum([len(each.bands) for each in self.first])
        if len(pauses) == len(self.first) - 1:
            cuts: tuple[Stretch | None, ...] = tuple(pauses)
        else:
            cuts = fitting([way.moment(float(place)) for place in places[:-1]], pauses)
        firsts = [0, *(number for number, cut in enumerate(cuts, 1) if cut), len(self.first)]
        begins = [0.0, *(cut.end for cut in cuts if cut)]
        ends = [*(cut.start for cut in cuts if cut), self.recording.duration]
        for (first, last), begin, end in zip(pairwise(firsts), begins, ends, strict=True):
            yield _Task(first, last, self._within(begin, end))

    def _within(self, begin: float, end: float) -> Stretch:
        """From the first speech to the last between two moments."""
        inside = [each for each in self.spoken if each.end > begin and each.start < end]
        if not inside:
            return Stretch(begin, end)
        return Stretch(max(inside[0].start, begin), min(inside[-1].end, end))

    def _heard(
        self, task: _Task, way: Course
    ) -> tuple[tuple[WordTime, ...], tuple[PhoneTime, ...], list[float], Likeness]:
        first = max(round((task.stretch.start - QUIET) / HOP), 0)
        bands = self.bands[first : max(round((task.stretch.end + QUIET) / HOP), first + 1) + 1]
        before = sum(len(each.bands) for each in self.first[: task.first])
        places = way.between(first, len(bands)) - before
        found = heard(bands, first, places, self._voices(task))
        begin, end = (round(frame * HOP * self.recording.rate) for frame in (first, first + len(bands)))
        samples = self.recording.samples[begin:end]
        edges = Edges(samples, self.recording.rate, begin / self.recording.rate)
        return found.words, found.phones, edges.labelled(found.phones), Likeness(first, found.likeness)

    def _voices(self, task: _Task) -> list[Reference]:
        spans = self.spans[task.first : task.last]
        others = (joined([reference(self.line, span, name, self.voice) for span in spans]) for name in VOICES[1:])
        return [joined(self.first[task.first : task.last]), *others]

    def _pace(self) -> float:
        """How many times as long as the voice the recording speaks."""
        return sum(each.length for each in self.spoken) / sum(each.duration for each in self.first)


def aligned(recording: Recording, line: Say, voice: VoiceBox, pauses: Sequence[Stretch] | None = None) -> Alignment:
    """The words of a line in its recording, cut into sentences at `pauses` or else where it fits best. Raises
    `VoiceFailure` where the voice cannot say the line."""
    return _Aligner(recording, line, voice).aligned(pauses)


def _plain(line: Say) -> Say:
    """The line for a voice to speak."""
    return replace(line, recording=None, times=None, voice=replace(line.voice, rate=1.0, pitch=1.0, volume=1.0))


def _shape(phone: PhoneTime) -> bool:
    """Whether it is a Mandarin mouth shape: between two there may be time to move."""
    return ":" in phone.symbol and phone.symbol.startswith("zh:")
