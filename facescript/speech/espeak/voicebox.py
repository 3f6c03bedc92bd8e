"""Lines to speech by espeak-ng: cut into pieces, each spoken, and put together again."""

from __future__ import annotations

from functools import cache

from facescript.ir.acts import Say
from facescript.speech.espeak import alphabetic, mandarin
from facescript.speech.espeak.client import Espeak
from facescript.speech.espeak.engine import EspeakEngine
from facescript.speech.espeak.manner import MANDARIN, Voices, voices
from facescript.speech.espeak.parts import Part, joined, spoken
from facescript.speech.lines import Piece, pieces
from facescript.speech.model import Spoken, VoiceBox
from facescript.speech.readings import check_readings
from facescript.speech.voices.kept import KeptVoice


class EspeakVoice:
    """A `VoiceBox` that speaks with espeak-ng. `Voice.volume` is not in the sound: the mix applies it."""

    def __init__(self, espeak: Espeak) -> None:
        self._espeak = espeak
        self._voices: Voices | None = None

    def speak(self, line: Say) -> Spoken:
        found = pieces(line)
        check_readings(line)
        self.voices().manner(line.voice)
        return spoken(joined([part if isinstance(part, float) else self._piece(line, part) for part in found]))

    def voices(self) -> Voices:
        """All voices. Raises `VoiceFailure` where the synthesiser cannot run."""
        if self._voices is None:
            self._voices = voices(self._espeak.voices())
        return self._voices

    def listed(self) -> tuple[tuple[str, str], ...]:
        """Codes of languages with their full names, then variants, as `voice CODE VARIANT` takes them."""
        found = self.voices()
        variants = sorted(set(found.variants.values()), key=str.lower)
        return (*sorted(found.titles.items()), *((name, "variant") for name in ("female", "male", *variants)))

    def _piece(self, line: Say, piece: Piece) -> Part:
        manner = self.voices().manner(line.voice)
        if line.voice.language.lower() in MANDARIN:
            return mandarin.speak(self._espeak, piece, line.text, self.voices(), line.voice)
        return alphabetic.speak(self._espeak, piece, manner)


@cache
def process_voice() -> EspeakVoice:
    """The synthesiser of this process; it starts with the first line."""
    return EspeakVoice(Espeak())


@cache
def open_voice() -> VoiceBox:
    """The usual voice: espeak-ng, and what it has spoken before."""
    return KeptVoice(EspeakEngine())


def list_voices() -> tuple[tuple[str, str], ...]:
    """What `voice CODE VARIANT` takes, each with what it is."""
    return process_voice().listed()
