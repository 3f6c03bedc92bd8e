"""Lines of one speaker to how loud and how stressed each sound of theirs is: how far jaw and vowels go."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass
from math import log10, tanh
from statistics import median
from weakref import WeakKeyDictionary

import numpy as np

from facescript.speech.model import PhoneTime, Spoken
from facescript.speech.mouth.visemes import visemes
from facescript.speech.sound.accents import Accent, heard
from facescript.speech.sound.prosody import HOP, Floats, Prosody

DOUBLED = 18.0
"""dB that speech is louder by where the jaw goes twice as far (ours: shouted vowels, some 12 to 15 dB above the usual,
open it by about a half more, Schulman 1989)."""

LIMIT = 10.5
"""dB to which that is limited softly: the jaw goes between two thirds and one and a half times its usual way."""

USUAL = 3.0
"""dB by which the lines of one speaker differ without being loud or soft."""

INSIDE = 0.5
"""How much of what one vowel of a line is louder than the others is effort; the rest is the vowel's own loudness."""

WHISPER, VOICELESS, VOICED = -20.0, 0.15, 0.4
"""dB that a whisper counts for: vowels of which less than the first share is voiced, and not wholly from the second."""

SILENT = -60.0
"""dB of a volume of 0."""


class Effort:
    """How one line is spoken: `line` is how far the jaw goes in it as a whole, 1 as usual."""

    def __init__(self, spoken: Spoken | None = None, normal: float = 0.0, volume: float = 1.0) -> None:
        """`normal` is the level of the speaker's vowels in dB, `volume` the factor at which the line is played."""
        level = _level(spoken) if spoken else None
        self._sound = heard(spoken).prosody if spoken and level else None
        self._accents: tuple[Accent, ...] = heard(spoken).accents if spoken and level else ()
        self._level = level.decibels if level else 0.0
        above = self._level - normal if level else 0.0
        self._above = above - max(-USUAL, min(USUAL, above)) + (level.whispered * WHISPER if level else 0.0)
        self._above += max(20.0 * log10(volume), SILENT) if volume > 0.0 else SILENT
        self.line = _way(self._above)

    def jaw(self, phone: PhoneTime) -> float:
        """How far the jaw goes in a vowel, 1 as usual."""
        found = _decibels(self._sound, phone) if self._sound else None
        return self.line if found is None else _way(self._above + INSIDE * (found - self._level))

    def stress(self, phone: PhoneTime) -> float:
        """How much a phone stands out by pitch and loudness, 0..1."""
        low, high = (bisect_left(self._accents, time, key=lambda one: one.time) for time in (phone.start, phone.end))
        return max((one.strength for one in self._accents[low:high]), default=0.0)


def normal_level(lines: Sequence[Spoken]) -> float:
    """The level at which a speaker's vowels usually are, dB: the median of the lines with sound."""
    found = [level.decibels for level in map(_level, lines) if level]
    return median(found) if found else 0.0


@dataclass(frozen=True, slots=True)
class _Level:
    """How loud the vowels of a line are in the median, dB, and how far (0..1) it is whispered."""

    decibels: float
    whispered: float


_LEVELS: WeakKeyDictionary[Spoken, _Level | None] = WeakKeyDictionary()


def _level(spoken: Spoken) -> _Level | None:
    """None where there is no vowel, or no sound; kept as long as the line itself is."""
    if spoken not in _LEVELS:
        _LEVELS[spoken] = _measured(spoken)
    return _LEVELS[spoken]


def _measured(spoken: Spoken) -> _Level | None:
    sound = heard(spoken).prosody
    vowels = [phone for phone in spoken.phones if _is_vowel(phone)]
    found = [level for level in (_decibels(sound, phone) for phone in vowels) if level is not None]
    if not found:
        return None
    voiced = float(np.concatenate([_part(sound.f0, phone) > 0.0 for phone in vowels]).mean())
    whispered = (VOICED - voiced) / (VOICED - VOICELESS)
    return _Level(median(found), max(0.0, min(1.0, whispered)))


def _is_vowel(phone: PhoneTime) -> bool:
    found = visemes(phone.symbol) if phone.symbol else ()
    return any(each.kind == "vowel" and each.shape not in ("m", "f") for each in found)


def _decibels(sound: Prosody, phone: PhoneTime) -> float | None:
    """The mean energy of a phone; None where it lies beyond the sound."""
    part = _part(sound.energy, phone)
    return float(part.mean()) if len(part) else None


def _part(values: Floats, phone: PhoneTime) -> Floats:
    """The frames of a phone, one at least."""
    first = round(phone.start / HOP)
    return values[first : max(round(phone.end / HOP), first + 1)]


def _way(decibels: float) -> float:
    """How far the jaw goes in speech that is so much louder than usual."""
    limited = LIMIT * tanh(decibels / LIMIT)
    way: float = 2.0 ** (limited / DOUBLED)
    return way


EVEN = Effort()
"""Speech of which nothing is heard."""
