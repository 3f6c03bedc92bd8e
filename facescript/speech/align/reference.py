"""Stretches of a line to how voices say them: sounds to compare a recording with, and when their words are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from facescript.ir.acts import Say
from facescript.speech.align.features import Floats, spectrum
from facescript.speech.align.sentences import part_of
from facescript.speech.model import PhoneTime, VoiceBox, WordTime

HOP = 0.01
"""Seconds from frame to frame, of voices and recordings."""


@dataclass(frozen=True, slots=True)
class Reference:
    """What a voice said: log power in bands, a frame each `HOP` seconds; words by characters of the whole line."""

    bands: Floats
    words: tuple[WordTime, ...]
    phones: tuple[PhoneTime, ...]
    duration: float


def reference(line: Say, span: tuple[int, int], variant: str, voice: VoiceBox, count: int) -> Reference:
    """How a voice says the characters `span` of a line, in the lowest `count` bands. Raises `VoiceFailure`."""
    part = part_of(line, *span)
    manner = replace(part.voice, variant=variant, rate=1.0, pitch=1.0, volume=1.0)
    spoken = voice.speak(replace(part, voice=manner))
    bands = spectrum(np.frombuffer(spoken.pcm, "<i2"), spoken.rate, HOP)[:, :count]
    words = tuple(replace(word, first=word.first + span[0], last=word.last + span[0]) for word in spoken.words)
    return Reference(bands, words, spoken.phones, spoken.duration)


def joined(references: Sequence[Reference]) -> Reference:
    """References one after another."""
    words: list[WordTime] = []
    phones: list[PhoneTime] = []
    at = 0
    for each in references:
        by = at * HOP
        words += [replace(word, start=word.start + by, end=word.end + by) for word in each.words]
        phones += [replace(phone, start=phone.start + by, end=phone.end + by) for phone in each.phones]
        at += len(each.bands)
    return Reference(np.concatenate([each.bands for each in references]), tuple(words), tuple(phones), at * HOP)
