"""Lines to estimated times, for `check` and the language server: no voice is started, no numpy loaded."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

from facescript.ir.acts import Say
from facescript.speech.espeak.manner import check_manner
from facescript.speech.lines import Piece, is_han, pieces, words
from facescript.speech.model import PhoneTime, Spoken, WordTime
from facescript.speech.readings import check_readings
from facescript.speech.sound.length import seconds_of
from facescript.speech.voices.registry import USUAL
from facescript.world import World, WorldFailure

EDGE = 0.05
"""Seconds of quiet around a piece."""

FIGURE, HAN, LETTER = 0.36, 0.245, 0.062
"""Seconds that a figure, a Chinese character and any other letter take at 100 %."""

LANGUAGES = {"de": 0.058, "fr": 0.052, "es": 0.067, "it": 0.066, "pt": 0.071, "pl": 0.07, "tr": 0.077, "fi": 0.072}
"""Seconds a letter where a language is far from the common value."""

SCRIPTS = (
    (0x0590, 0x06FF, 0.11),  # Hebrew, Arabic: vowels are not written
    (0x0900, 0x0DFF, 0.127),  # the scripts of India: a letter is a syllable, or most of one
    (0x0E00, 0x0EFF, 0.155),  # Thai, Lao
    (0x3040, 0x30FF, 0.13),  # kana
    (0xAC00, 0xD7A3, 0.177),  # Hangul
)
"""First and last letter of a script, and seconds a letter."""

CLAUSE, SENTENCE = 0.19, 0.3
"""Seconds of silence after a comma or a colon, and after a sentence, inside a piece."""


class EstimatedVoice:
    """A `VoiceBox` without a voice: times from counts of letters, measured against espeak-ng's. Raises
    `VoiceFailure` for what the text alone shows to be at fault: nothing to say, readings that no voice could speak, a
    rate or pitch beyond every voice; and for files of times in `world` that cannot be used."""

    def __init__(self, world: World | None = None) -> None:
        self._world = world

    def speak(self, line: Say) -> Spoken:
        if line.times is not None and self._world is not None:
            from facescript.speech.timing.line import estimated

            return estimated(line, self._world)
        if line.recording is not None:
            return self._recorded(line, line.recording)
        return self._spoken(line)

    def _recorded(self, line: Say, name: str) -> Spoken:
        """As long as the recording's headers tell, with the words spread over it; as said, where they do not."""
        length = None
        if self._world is not None:
            with suppress(WorldFailure):
                length = seconds_of(self._world.path(name))
        if not line.text:
            return Spoken(b"", 22_050, length or 0.0, (), (), estimated=True)
        plain = replace(line, voice=replace(line.voice, rate=1.0, pitch=1.0, engine=USUAL, variant=""))
        spoken = self._spoken(plain)
        return spoken if length is None else _stretched(spoken, length)

    def _spoken(self, line: Say) -> Spoken:
        if line.voice.engine == USUAL:
            check_manner(line.voice)
        pace = 1 / line.voice.rate
        check_readings(line)
        at = 0.0
        times: list[WordTime] = []
        for part in pieces(line):
            if isinstance(part, float):
                at += part
            else:
                found = _timed(part, at, pace, line.voice.language)
                times += found
                at = found[-1].end + EDGE * pace
        return Spoken(b"", 22_050, at, tuple(times), (PhoneTime("", 0.0, at),), estimated=True)


def _stretched(spoken: Spoken, length: float) -> Spoken:
    """A line spoken in `length` seconds."""
    pace = length / spoken.duration if spoken.duration else 0.0
    words = (replace(word, start=word.start * pace, end=word.end * pace) for word in spoken.words)
    return replace(spoken, duration=length, words=tuple(words), phones=(PhoneTime("", 0.0, length),))


def _timed(piece: Piece, at: float, pace: float, language: str) -> list[WordTime]:
    """The words of a piece that begins at `at`, one after another."""
    times: list[WordTime] = []
    before = 0
    for word in words(piece.text):
        at += pace * pause_between(piece.text[before : word.first]) if times else 0.0
        text = piece.text[word.first : word.last]
        end = at + pace * word_length(text, language)
        times.append(WordTime(text, piece.first + word.first, piece.first + word.last, at, end))
        at, before = end, word.last
    return times


def pause_between(between: str) -> float:
    """The silence that the signs between two words make."""
    if any(sign in ".!?…。！？।" for sign in between):
        return SENTENCE
    return CLAUSE if any(sign in ",;:，；：、—" for sign in between) else 0.0


def word_length(word: str, language: str = "en") -> float:
    """Seconds that a word takes at 100 %."""
    return sum(_length(sign, language) for sign in word)


def _length(sign: str, language: str) -> float:
    """Seconds of one character of a word; marks and joiners take none."""
    if sign.isdigit():
        return FIGURE
    if not sign.isalpha():
        return 0.0
    if is_han(sign):
        return HAN
    for first, last, length in SCRIPTS:
        if first <= ord(sign) <= last:
            return length
    return LANGUAGES.get(language.lower().split("-")[0], LETTER)
