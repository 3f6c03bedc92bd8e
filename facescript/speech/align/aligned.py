"""A recording and its words to when each word and phone is said, and how sure that is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from facescript.ir.acts import Say
from facescript.speech.align.activity import Stretch, speaking
from facescript.speech.align.alignment import Alignment
from facescript.speech.align.course import Course, course
from facescript.speech.align.edges import Edges
from facescript.speech.align.features import spectrum
from facescript.speech.align.likeness import Likeness, confidences, doubts, unlike
from facescript.speech.align.piece import Heard, heard
from facescript.speech.align.reference import HOP, Reference, joined, reference
from facescript.speech.align.second import Part, better
from facescript.speech.align.segments import fitting, pauses_between
from facescript.speech.align.sentences import sentences
from facescript.speech.align.sphinx import Utterance, starts
from facescript.speech.espeak.parts import RATE
from facescript.speech.listen.loop import installed
from facescript.speech.model import Doubt, PhoneTime, Spoken, VoiceBox, WordTime
from facescript.speech.sound.recording import Recording, Samples
from facescript.speech.timing.fitting import fitted, voiced
from facescript.speech.timing.times import Times

VOICES = ("", "f3")
"""The variants that say the text, one deep, one high: the middle of their times is taken."""

QUIET = 0.03
"""Seconds of quiet kept around a stretch of speech: it is compared with voices that have as much."""

SILENCE = 0.1
"""Seconds between two pieces that are a silence of their own."""

SOMETHING = "ə"
"""A sound of any kind."""


@dataclass(frozen=True, slots=True)
class _Task:
    """The sentences number `first` and on, before `last`, said in a stretch of the recording."""

    first: int
    last: int
    stretch: Stretch


def aligned(
    recording: Recording,
    line: Say,
    voice: VoiceBox,
    pauses: Sequence[Stretch] | None = None,
    by_voice_alone: bool = False,
) -> Alignment:
    """The words of a line in its recording, cut into sentences at `pauses`, or else where it fits best. English is
    looked over by PocketSphinx where it is installed, unless `by_voice_alone`. Raises `VoiceFailure` where the voice
    cannot say the line."""
    english = line.voice.language.lower().split("-")[0] == "en"
    return _Aligner(recording, line, voice).aligned(pauses, english and not by_voice_alone and installed())


class _Aligner:
    """A recording and a line on their way to an `Alignment`."""

    def __init__(self, recording: Recording, line: Say, voice: VoiceBox) -> None:
        self.recording, self.line, self.voice = recording, line, voice
        self.bands = spectrum(recording.samples, recording.rate, HOP)
        self.spoken = speaking(self.bands, HOP)
        self.spans = sentences(line)
        self.first = [self._reference(span, VOICES[0]) for span in self.spans]

    def aligned(self, pauses: Sequence[Stretch] | None, twice: bool) -> Alignment:
        unlikely = unlike(self.spoken, sum(each.duration for each in self.first))
        if unlikely:
            return self._spread(unlikely)
        way = course(self.bands, self.spoken, self.first)
        tasks = self._tasks(self._cuts(way, pauses))
        parts = [self._part(task, way) for task in tasks]
        return self._joined(self._again(parts) if twice else parts)

    def _cuts(self, way: Course, pauses: Sequence[Stretch] | None) -> Sequence[Stretch | None]:
        """For each sentence but the first the pause before it; as many as were chosen are one each."""
        if pauses is not None and len(pauses) == len(self.first) - 1:
            return pauses
        places = np.cumsum([len(each.bands) for each in self.first])
        starts = [way.moment(float(place)) for place in places[:-1]]
        return fitting(starts, pauses_between(self.spoken) if pauses is None else pauses)

    def _tasks(self, cuts: Sequence[Stretch | None]) -> Iterator[_Task]:
        """The recording cut at the pauses before sentences."""
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

    def _part(self, task: _Task, way: Course) -> Part:
        first = max(round((task.stretch.start - QUIET) / HOP), 0)
        bands = self.bands[first : max(round((task.stretch.end + QUIET) / HOP), first) + 1]
        before = sum(len(each.bands) for each in self.first[: task.first])
        found = heard(bands, first, way.between(first, len(bands)) - before, self._voices(task))
        edges = Edges(self._samples(found), self.recording.rate, first * HOP)
        return Part(found, edges.labelled(found.phones))

    def _samples(self, found: Heard) -> Samples:
        """The sound in which something was found."""
        rate = self.recording.rate
        last = found.first + len(found.likeness)
        return self.recording.samples[round(found.first * HOP * rate) : round(last * HOP * rate)]

    def _again(self, parts: Sequence[Part]) -> list[Part]:
        """The parts with the starts that PocketSphinx finds, where they are plausible."""
        rate = self.recording.rate
        asked = [
            Utterance(self._samples(part.heard), rate, part.heard.first * HOP, part.heard.words, part.heard.phones)
            for part in parts
        ]
        return [better(part, begun) for part, begun in zip(parts, starts(asked), strict=True)]

    def _reference(self, span: tuple[int, int], variant: str) -> Reference:
        return reference(self.line, span, variant, self.voice, self.bands.shape[1])

    def _voices(self, task: _Task) -> list[Reference]:
        spans = self.spans[task.first : task.last]
        others = (joined([self._reference(span, name) for span in spans]) for name in VOICES[1:])
        return [joined(self.first[task.first : task.last]), *others]

    def _joined(self, parts: Sequence[Part]) -> Alignment:
        """The parts one after another, with the silences between them."""
        words: list[WordTime] = []
        phones: list[PhoneTime] = []
        labelled: list[float] = []
        for part in parts:
            _be_silent(phones, labelled, part.heard.phones[0].start)
            words += part.heard.words
            phones += part.heard.phones
            labelled += part.labelled
        _be_silent(phones, labelled, self.recording.duration)
        likeness = [Likeness(part.heard.first, part.heard.likeness) for part in parts]
        sure = confidences(words, likeness)
        found = (*doubts(words, sure, likeness), *(doubt for part in parts for doubt in part.doubts))
        return Alignment(tuple(words), sure, tuple(phones), tuple(labelled), self.recording.duration, found)

    def _spread(self, doubt: Doubt) -> Alignment:
        """The words by their usual lengths over the speech that there is, or else over all of it."""
        duration = self.recording.duration
        sounds = tuple(PhoneTime(SOMETHING, each.start, each.end) for each in self.spoken)
        words = fitted(Times((), sounds, duration), self.line).words
        whole = joined(self.first)
        spoken = Spoken(b"", RATE, whole.duration, whole.words, whole.phones)
        phones = voiced(spoken, words, duration)
        return Alignment(words, (0.0,) * len(words), phones, tuple(phone.start for phone in phones), duration, (doubt,))


def _be_silent(phones: list[PhoneTime], labelled: list[float], until: float) -> None:
    """A silence from the last of the phones on, where it is long enough to be one."""
    last = phones[-1].end if phones else 0.0
    if until - last > SILENCE:
        phones.append(PhoneTime("", last, until))
        labelled.append(last)
