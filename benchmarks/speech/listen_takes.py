"""The sentences that the recogniser of mouth shapes is trained on, spoken by many voices and heard in many rooms.

espeak-ng speaks all languages with voices that differ, and Debian's festival a few with the sounds of people
(`apt-get install festival` and the packages of `listen_voices.FESTIVAL`); more people are those of `listen_people`. The
voices of `HELD_OUT` are never used.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from listen_people import PICO, RHVOICE, an4, pico, rhvoice
from listen_texts import MORE, TRAINED
from listen_voices import FESTIVAL, Take, espeak, festival
from numpy.random import Generator, default_rng
from numpy.typing import NDArray

from facescript.speech.listen.bands import bark, features
from facescript.speech.listen.classes import frames
from facescript.speech.listen.network import BANDS
from facescript.speech.model import PhoneTime

Floats = NDArray[np.float64]

HELD_OUT = ("f2", "m7", "Andy", "klatt4", "anika", "Michael", "edward", "linda")
"""espeak-ng's variants that it is measured on."""

VARIANTS = (
    " f1 f3 f4 f5 m1 m2 m3 m4 m5 m6 m8 klatt klatt2 klatt3 klatt5 klatt6 Alex Alicia Andrea Annie adam "
    "aunty belinda benjamin boris caleb david Denis Diogo ed Gene grandma grandpa Henrique Hugo ian iven "
    "Jacky john Lee Marco Mario max michel miguel Mike Nguyen norbert pablo paul pedro quincy Reed rob "
    "robert sandro shelby steph travis victor zac whisper"
).split(" ")
"""Those that it is trained on; the first is the voice as it is."""

MANY, FEW = 14, 8
"""Voices for each sentence of English and Mandarin, and of the other languages."""

PACES = (0.8, 0.9, 1.0, 1.1, 1.25)
"""How many times as long festival's sentences are."""

ROOMS, AN4_ROOMS, MADE_ROOMS = 4, 2, 2
"""How often each sentence of festival, of AN4, and of RHVoice and pico is heard, once as it is."""

BRITISH, PLAIN = 0.3, 0.2
"""The shares of English that is British, and of espeak-ng's takes that are heard as they are."""


@dataclass(frozen=True, slots=True)
class Lesson:
    """A take as features with the sound of each frame, array[frame, column] and array[frame]; `person`: of people."""

    features: NDArray[np.float32]
    sounds: NDArray[np.intp]
    classes: NDArray[np.intp]
    person: bool


def lessons(seed: int) -> Iterator[Lesson]:
    """All takes in order; the same for a seed."""
    for place, language in enumerate(TRAINED):
        rng = default_rng([seed, place])
        for text in TRAINED[language].splitlines():
            for variant in rng.choice(VARIANTS, MANY if language in ("en-us", "cmn") else FEW, replace=False):
                spoken = "en-gb" if language == "en-us" and rng.random() < BRITISH else language
                take = espeak(text, spoken, str(variant), rng.uniform(0.75, 1.4), rng.uniform(0.75, 1.35))
                yield lesson(take, rng, rng.random() >= PLAIN, False)
    for place, (voice, (language, _)) in enumerate(FESTIVAL.items()):
        rng = default_rng([seed, place, 1])
        texts = (TRAINED.get(language, "") + "\n" + MORE.get(language, "")).strip().splitlines()
        for take in festival(texts, voice, [float(pace) for pace in rng.choice(PACES, len(texts))]):
            for room in range(ROOMS):
                yield lesson(take, rng, room > 0, True)
    for place, (found, rooms) in enumerate(((an4(), AN4_ROOMS), (made(seed), MADE_ROOMS))):
        rng = default_rng([seed, place, 2])
        for take in found:
            for room in range(rooms):
                yield lesson(take, rng, room > 0, True)


def made(seed: int) -> Iterator[Take]:
    """The English sentences by RHVoice and pico."""
    rng = default_rng([seed, 77])
    texts = [*TRAINED["en-us"].splitlines(), *MORE["en-us"].splitlines()]
    speakers = [(rhvoice, voice) for voice in RHVOICE] + [(pico, voice) for voice in PICO]
    for speak, voice in speakers:
        for text in texts:
            take = speak(text, voice, rng.uniform(0.75, 1.3), rng.uniform(0.85, 1.2))
            if take:
                yield take


def lesson(take: Take, rng: Generator, changed: bool, person: bool) -> Lesson:
    """A take as it is, or with another throat, in another room and by another microphone."""
    rate = round(take.recording.rate * float(np.exp(rng.uniform(-0.17, 0.17)))) if changed else take.recording.rate
    sound = take.recording.samples / 32_768.0
    if changed:
        sound = heard_elsewhere(sound, rate, rng)
    sound *= 10.0 ** (-rng.uniform(1.0, 25.0) / 20.0) / np.abs(sound).max()
    found = features(np.rint(sound * 32_767.0).astype(np.int16), rate, BANDS)
    shorter = take.recording.rate / rate
    phones = [PhoneTime(phone.symbol, phone.start * shorter, phone.end * shorter) for phone in take.phones]
    return Lesson(found, *frames(phones, len(found)), person)


def heard_elsewhere(sound: Floats, rate: int, rng: Generator) -> Floats:
    """The sound with an echo, a colour, a narrower band and noise, each by chance."""
    size = 1 << (len(sound) + rate // 2 - 1).bit_length()
    hertz = np.fft.rfftfreq(size, 1.0 / rate)
    spectrum = np.fft.rfft(sound, size) * colour(hertz, rng)
    if rng.random() < 0.5:
        spectrum *= np.fft.rfft(echo(rate, rng), size)
    if rng.random() < 0.25:
        spectrum /= 1.0 + (hertz / rng.uniform(3200.0, 7500.0)) ** 16
    if rng.random() < 0.25:
        low = np.square(hertz / rng.uniform(60.0, 250.0))
        spectrum *= low / (1.0 + low)
    heard: Floats = np.fft.irfft(spectrum, size)[: len(sound)]
    return heard + noise(heard, rate, rng) if rng.random() < 0.7 else heard


def colour(hertz: Floats, rng: Generator) -> Floats:
    """A smooth response of a microphone: a walk over the Bark scale, and a tilt."""
    knots = np.linspace(0.0, 22.0, 7)
    gains = np.cumsum(rng.normal(0.0, 2.5, len(knots))) + rng.normal(0.0, 0.35) * knots
    response: Floats = 10.0 ** (np.interp(bark(hertz), knots, gains) / 20.0)
    return response


def echo(rate: int, rng: Generator) -> Floats:
    """The response of a room that dies away within 0.08 to 0.4 s."""
    length = rng.uniform(0.08, 0.4)
    times = np.arange(int(length * rate)) / rate
    tail = rng.standard_normal(len(times)) * np.exp(-6.9 * times / length)
    response: Floats = tail * rng.uniform(0.1, 0.6) / np.sqrt(np.square(tail).sum())
    response[0] = 1.0
    return response


def noise(heard: Floats, rate: int, rng: Generator) -> Floats:
    """Noise between white and pink, 12 to 50 dB below the sound."""
    hertz = np.maximum(np.fft.rfftfreq(len(heard), 1.0 / rate), 30.0)
    hiss = np.fft.irfft(np.fft.rfft(rng.standard_normal(len(heard))) * hertz ** -rng.uniform(0.0, 1.2), len(heard))
    level = np.sqrt(np.square(heard).mean() / np.square(hiss).mean())
    added: Floats = hiss * level * 10.0 ** (-rng.uniform(12.0, 50.0) / 20.0)
    return added
