"""Lines to speech by espeak-ng, each spoken once and kept."""

from __future__ import annotations

from collections import OrderedDict
from functools import cache
from threading import Lock

from facescript.ir.acts import Say
from facescript.speech.espeak import alphabetic, mandarin
from facescript.speech.espeak.client import Espeak
from facescript.speech.espeak.manner import MANDARIN, Voices, voices
from facescript.speech.espeak.parts import Part, joined, spoken
from facescript.speech.lines import Piece, pieces
from facescript.speech.model import Spoken, VoiceBox
from facescript.speech.readings import check_readings

LARGEST_CACHE = 64 * 1024 * 1024
"""Bytes of sound kept; what was used longest ago goes first."""


class EspeakVoice:
    """A `VoiceBox` that speaks with espeak-ng. `Voice.volume` is not in the sound: the mix applies it."""

    def __init__(self, espeak: Espeak) -> None:
        self._espeak = espeak
        self._voices: Voices | None = None
        self._kept: OrderedDict[object, Spoken] = OrderedDict()
        self._size = 0
        self._lock = Lock()

    def speak(self, line: Say) -> Spoken:
        key = (line.text, line.stretches, line.voice.language, line.voice.variant, line.voice.rate, line.voice.pitch)
        with self._lock:
            if key in self._kept:
                self._kept.move_to_end(key)
                return self._kept[key]
            return self._keep(key, self._spoken(line))

    def voices(self) -> Voices:
        """All voices. Raises `VoiceFailure` where the synthesiser cannot run."""
        if self._voices is None:
            self._voices = voices(self._espeak.voices())
        return self._voices

    def _keep(self, key: object, line: Spoken) -> Spoken:
        self._kept[key] = line
        self._size += len(line.pcm)
        while self._size > LARGEST_CACHE and len(self._kept) > 1:
            self._size -= len(self._kept.popitem(last=False)[1].pcm)
        return line

    def _spoken(self, line: Say) -> Spoken:
        found = pieces(line)
        check_readings(line)
        self.voices().manner(line.voice)
        return spoken(joined([part if isinstance(part, float) else self._piece(line, part) for part in found]))

    def _piece(self, line: Say, piece: Piece) -> Part:
        manner = self.voices().manner(line.voice)
        if line.voice.language.lower() in MANDARIN:
            return mandarin.speak(self._espeak, piece, line.text, self.voices(), line.voice)
        return alphabetic.speak(self._espeak, piece, manner)


@cache
def _voice() -> EspeakVoice:
    return EspeakVoice(Espeak())


def open_voice() -> VoiceBox:
    """The voice of this process; the synthesiser starts with the first line."""
    return _voice()


def list_voices() -> tuple[tuple[str, str], ...]:
    """Codes of languages with their full names, then variants, as `voice CODE VARIANT` takes them."""
    found = _voice().voices()
    variants = sorted(set(found.variants.values()), key=str.lower)
    return (*sorted(found.titles.items()), *((name, "variant") for name in ("female", "male", *variants)))
