"""Lines to estimated times, for `check` and the language server: no voice is started, no numpy loaded."""

from __future__ import annotations

import unicodedata

from facescript.ir.acts import Say
from facescript.speech.ipa import letters, mnemonics
from facescript.speech.lines import Piece, Word, is_han, is_unspaced, pieces, words
from facescript.speech.model import PhoneTime, Spoken, WordTime
from facescript.speech.parts import LEAD, RATE, TAIL
from facescript.speech.voices import MANDARIN, pitch, rate

LETTER = 0.062
WORD = 0.06
"""Seconds a letter, and a word beside its letters, take in a language written with letters."""

SYLLABLE = 0.235
"""Seconds of a Chinese character, and of a figure in any language."""

FIGURE = 0.33
CLAUSE, SENTENCE = 0.16, 0.31
"""Seconds of silence after a comma, and after a sentence inside a piece."""


class EstimatedVoice:
    """A `VoiceBox` without a voice. Raises `VoiceFailure` for what the text alone shows to be at fault: nothing to
    say, readings that no voice could speak, a rate or pitch beyond every voice."""

    def speak(self, line: Say) -> Spoken:
        factor = 175 / rate(line.voice.rate)
        pitch(line.voice.pitch)
        mandarin = line.voice.language.lower() in MANDARIN
        at, times = 0.0, []
        for part in pieces(line):
            if isinstance(part, float):
                at += part
                continue
            found, at = _timed(part, at, factor)
            times += found
        return Spoken(b"", RATE, at, tuple(times), (PhoneTime("", 0.0, at),), estimated=True)
