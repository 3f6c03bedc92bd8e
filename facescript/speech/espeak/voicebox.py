"""Lines to speech by espeak-ng: cut into pieces, each spoken, and put together again."""

from __future__ import annotations

from functools import cache

from facescript.ir.acts import Say
from facescript.speech.espeak import alphabetic, mandarin
from facescript.speech.espeak.client import Espeak
from facescript.speech.espeak.engine import EspeakEngine
from facescript.speech.espeak.manner import MANDARIN, Voices, voices
from facescript.speech.espeak.parts import Part, Take, joined, spoken, unheard
from facescript.speech.lines import Piece, pieces
from facescript.speech.model import Spoken
from facescript.speech.readings import check_readings
from facescript.speech.voices.kept import KeptVoice


class EspeakVoice:
    """A `VoiceBox` that speaks with espeak-ng. `Voice.volume` is not in the sound: the mix applies it."""

    def __init__(self, espeak: Espeak) -> None:
        self._espeak = espeak
        self._voices: Voices | None = None

    def speak(self, line: Say, take: Take = unheard) -> Spoken:
        """The line spoken; `take` gets its sound while it is made."""
        found = pieces(line)
        check_readings(line)
        self.voices().manner(line.voice)
        return spoken(joined([self._part(line, part, take) for part in found]))

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

    def _part(self, line: Say, part: Piece | float, take: Take) -> Part:
        if isinstance(part, float):
            pause = joined([part])
            take(pause.pcm)
            return pause
        if line.voice.language.lower() in MANDARIN:
            return mandarin.speak(self._espeak, part, line.text, self.voices(), line.voice, take)
        return alphabetic.speak(self._espeak, part, self.voices().manner(line.voice), take)


@cache
def process_voice() -> EspeakVoice:
    """The synthesiser of this process; it starts with the first line."""
    return EspeakVoice(Espeak())


@cache
def open_voice() -> KeptVoice:
    """The usual voice: espeak-ng, and what it has spoken before."""
    return KeptVoice(EspeakEngine())
