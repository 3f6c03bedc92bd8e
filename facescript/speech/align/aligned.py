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
from facescript.speech.align.piece import Heard, heard
from facescript.speech.align.reference import HOP, Reference, joined, reference
from facescript.speech.align.segments import fitting, pauses_between
from facescript.speech.align.sentences import sentences
from facescript.speech.model import PhoneTime, VoiceBox, WordTime
from facescript.speech.sound.recording import Recording

VOICES = ("", "f3")
"""The variants that say the text: the median of their times is taken."""

LEAD, TAIL = 0.03, 0.03
"""Seconds of quiet around a stretch of speech, as the voices have it."""


@dataclass(frozen=True, slots=True)
class Alignment:
    """Words by characters of the line with a confidence (0..1) each; phones as a `Spoken` has them, and when each
    begins as people label it (a plosive with its closure). Seconds of the recording."""

    words: tuple[WordTime, ...]
    confidences: tuple[float, ...]
    phones: tuple[PhoneTime, ...]
    labelled: tuple[float, ...]
    likeness: float


@dataclass(frozen=True, slots=True)
class Task:
    """Sentences `first` to `last` of the text, said in a stretch of the recording."""

    first: int
    last: int
    stretch: Stretch


def aligned(recording: Recording, line: Say, voice: VoiceBox) -> Alignment:
    bands = spectrum(recording.samples, recording.rate, HOP)
    spoken = speaking(bands, HOP)
    spans = sentences(line.text)
    voices = [reference(line, span, VOICES[0], voice) for span in spans]
    way = course(bands, spoken, voices)
    tasks = list(_tasks(way, voices, spoken))
    found = []
    labelled = []
    offsets = np.cumsum([0] + [len(each.bands) for each in voices])
    for task in tasks:
        first = max(round((task.stretch.start - LEAD) / HOP), 0)
        last = round((task.stretch.end + TAIL) / HOP) + 1
        refs = [joined(voices[task.first : task.last])]
        for v in VOICES[1:]:
            refs.append(joined([reference(line, span, v, voice) for span in spans[task.first : task.last]]))
        part = bands[first:last]
        h = heard(part, first, way.between(first, len(part)) - offsets[task.first], refs)
        a, b = round(first * HOP * recording.rate), round(last * HOP * recording.rate)
        labelled += Edges(recording.samples[a:b], recording.rate, a / recording.rate).labelled(h.phones)
        found.append(h)
    words = tuple(w for h in found for w in h.words)
    phones = tuple(p for h in found for p in h.phones)
    like = np.concatenate([h.likeness for h in found])
    return Alignment(words, (1.0,) * len(words), phones, tuple(labelled), float(like.mean()))


def _tasks(way: Course, voices: Sequence[Reference], spoken: Sequence[Stretch]) -> Iterator[Task]:
    places = np.cumsum([len(each.bands) for each in voices])
    starts = [way.moment(float(place)) for place in places[:-1]]
    cuts = fitting(starts, pauses_between(spoken))
    firsts = [0, *(n for n, cut in enumerate(cuts, 1) if cut), len(voices)]
    begins = [spoken[0].start, *(cut.end for cut in cuts if cut)]
    ends = [*(cut.start for cut in cuts if cut), spoken[-1].end]
    for (first, last), begin, end in zip(pairwise(firsts), begins, ends, strict=True):
        yield Task(first, last, Stretch(begin, end))
