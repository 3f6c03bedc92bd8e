"""Turns a spoken line into its accents: when syllables stand out by pitch and loudness, and how far."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from weakref import WeakKeyDictionary

import numpy as np

from facescript.speech.model import PhoneTime, Spoken
from facescript.speech.sound.prosody import HOP, QUIET, Floats, Prosody, prosody

SEMITONES, DECIBELS = 4.0, 8.0
"""How far F0 and energy are above their surroundings where a syllable has a prominence of 1 by each alone (ours)."""

AROUND = 0.4
"""Standard deviation in seconds of the surroundings: a word or two to either side."""

SMOOTHING = 0.02
"""Standard deviation in seconds of what is smoothed away: the periods of the voice and the edges of its sounds."""

RANGE = 35.0
"""dB below the loudest frame where silence begins: it is no quieter than that."""

STRESSED = 0.5
"""What the stress of the word adds to a syllable's prominence (ours)."""

LEAST = 0.5
"""The prominence from which on a syllable is accented (ours); one more makes a strength of 0.63."""

SYLLABLE = 0.12
"""Seconds around an accent in which it stands alone: half a long syllable."""

EMPHASIS = 1.0
"""The prominence that a word stressed in the text has besides: it is an accent, whoever speaks it (ours)."""

BREAK = 0.12
"""Seconds of silence that end a stretch of sound: shorter ones are closures of the consonants."""

UNHEARD = 0.5
"""The strength of a stressed phone in a line without sound."""

TONE = 100.0
"""Hz from which semitones are counted."""


@dataclass(frozen=True, slots=True)
class Accent:
    """The peak of an accented syllable: seconds from the line's start, and its strength in 0..1."""

    time: float
    strength: float


@dataclass(frozen=True, slots=True)
class Heard:
    """What is heard in a spoken line: its prosody, and its accents in time order."""

    prosody: Prosody
    accents: tuple[Accent, ...]


_HEARD: WeakKeyDictionary[Spoken, Heard] = WeakKeyDictionary()


def heard(spoken: Spoken) -> Heard:
    """What is heard in a line: a pure function, kept as long as the line itself is."""
    found = _HEARD.get(spoken)
    if found is None:
        sound = prosody(spoken.pcm, spoken.rate)
        found = _HEARD[spoken] = Heard(sound, accents(spoken, sound))
    return found


def accents(spoken: Spoken, sound: Prosody) -> tuple[Accent, ...]:
    """The accents of a line, at most one a syllable.

    A syllable is accented where F0 and energy rise far enough above their surroundings; the stress of its word helps.
    In Mandarin and wherever phones have no stress, sound alone decides. Without sound, the stress does.
    """
    if not len(sound.f0):
        stressed = (phone for phone in spoken.phones if phone.stress)
        return tuple(Accent((phone.start + phone.end) / 2.0, UNHEARD) for phone in stressed)
    return tuple(_standing_out(tuple(_peaks(spoken, sound))))


def prominence(found: Prosody) -> Floats:
    """How far each frame stands out of the voiced ones around it: array[frame], below 0 where it is less."""
    loud = loudness(found)
    weights = found.voiced if found.voiced.any() else loud > loud.min()
    rise = np.zeros(len(loud))
    for values, unit in ((loud, DECIBELS), (semitones(found), SEMITONES)):
        smooth = smoothed(values, SMOOTHING)
        rise += (smooth - _surroundings(smooth, weights.astype(np.float64))) / unit
    return rise


def loudness(found: Prosody) -> Floats:
    """Energy in dB, at least as much as silence has in this line: array[frame]."""
    loud: Floats = np.maximum(found.energy, found.energy.max() - RANGE)
    return loud


def semitones(found: Prosody) -> Floats:
    """F0 in semitones above `TONE`: array[frame], straight lines through what is unvoiced."""
    voiced = np.flatnonzero(found.voiced)
    if not len(voiced):
        return np.zeros(len(found.f0))
    tones: Floats = np.interp(np.arange(len(found.f0)), voiced, 12.0 * np.log2(found.f0[voiced] / TONE))
    return tones


def smoothed(values: Floats, deviation: float) -> Floats:
    """The values, a frame each, without what is quicker than a normal curve of `deviation` seconds."""
    return _surroundings(values, np.ones(len(values)), deviation)


def _surroundings(values: Floats, weights: Floats, deviation: float = AROUND) -> Floats:
    """The weighted mean around each frame."""
    reach = int(2.5 * deviation / HOP)
    bell = np.exp(-0.5 * np.square(np.arange(-reach, reach + 1) * (HOP / deviation)))
    total, weight = (np.convolve(part, bell)[reach : reach + len(values)] for part in (values * weights, weights))
    mean: Floats = total / np.maximum(weight, 1e-9)
    return mean


def stretches(spoken: Spoken) -> tuple[tuple[float, float], ...]:
    """Where a line sounds, by ear: seconds from its start to and from what is as quiet as silence for `BREAK` s; the
    whole line where there is no sound to be heard."""
    return _loud(heard(spoken).prosody, spoken.duration)


def _loud(sound: Prosody, duration: float) -> tuple[tuple[float, float], ...]:
    level = sound.energy
    loud = np.flatnonzero(level > max(level.max(initial=QUIET) - RANGE, QUIET))
    if not len(loud):
        return ((0.0, duration),)
    parts = np.split(loud, np.flatnonzero(np.diff(loud) > BREAK / HOP) + 1)
    return tuple((float(part[0]) * HOP, min(float(part[-1] + 1) * HOP, duration)) for part in parts)


def _syllables(spoken: Spoken, sound: Prosody) -> Iterator[PhoneTime]:
    """The phones of a line that sound; where nobody knows them, pieces of its sound as long as half a syllable. Silence
    alone, without words, is known to be silence."""
    phones = [phone for phone in spoken.phones if phone.symbol]
    if phones or (spoken.phones and not spoken.words):
        yield from phones
        return
    for start, end in _loud(sound, spoken.duration):
        count = max(round((end - start) / SYLLABLE), 1)
        edges = np.linspace(start, end, count + 1)
        yield from (PhoneTime("?", float(a), float(b)) for a, b in pairwise(edges))


def _peaks(spoken: Spoken, sound: Prosody) -> Iterator[Accent]:
    """The most prominent frame of every phone; its strength is the prominence, and at least `EMPHASIS` once in a word
    that the text stresses."""
    found = list(_phone_peaks(spoken, sound))
    for word in (each for each in spoken.words if each.stress):
        inside = [place for place, one in enumerate(found) if word.start <= one.time < word.end]
        if inside:
            place = max(inside, key=lambda each: found[each].strength)
            found[place] = replace(found[place], strength=max(found[place].strength, 0.0) + EMPHASIS)
    return iter(found)


def _phone_peaks(spoken: Spoken, sound: Prosody) -> Iterator[Accent]:
    rise = prominence(sound)
    for phone in _syllables(spoken, sound):
        first, last = round(phone.start / HOP), max(round(phone.end / HOP), round(phone.start / HOP) + 1)
        part = rise[first:last]
        if len(part):
            place = int(part.argmax())
            yield Accent((first + place) * HOP, float(part[place]) + STRESSED * phone.stress)


def _standing_out(found: tuple[Accent, ...]) -> Iterator[Accent]:
    for place, accent in enumerate(found):
        if accent.strength >= LEAST and not any(_above(other, accent) for other in _near(found, place)):
            yield Accent(accent.time, float(1.0 - np.exp(LEAST - accent.strength)))


def _near(found: tuple[Accent, ...], place: int) -> Iterator[Accent]:
    for step in (-1, 1):
        other = place + step
        while 0 <= other < len(found) and abs(found[other].time - found[place].time) < SYLLABLE:
            yield found[other]
            other += step


def _above(other: Accent, accent: Accent) -> bool:
    """Whether another peak makes an accent none; of two that are the same the first stays."""
    return (other.strength, -other.time) > (accent.strength, -accent.time)
