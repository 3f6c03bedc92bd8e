"""espeak-ng as an engine of speech: known without being started, started with the first line."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from facescript.ir.acts import Say, Voice
from facescript.speech.espeak.manner import MANDARIN
from facescript.speech.model import Spoken
from facescript.speech.voices.engine import stamp_of_package
from facescript.world import World


class EspeakEngine:
    """The engine of every voice that names none."""

    def speak(self, line: Say) -> Spoken:
        from facescript.speech.espeak.voicebox import process_voice  # `check` makes this engine and never speaks

        return process_voice().speak(line)

    def speak_aloud(self, line: Say, take: Callable[[bytes], None]) -> Spoken:
        from facescript.speech.espeak.voicebox import process_voice

        return process_voice().speak(line, take)

    def identity(self, voice: Voice) -> str:
        packages = ("espeakng_loader", "pypinyin") if voice.language.lower() in MANDARIN else ("espeakng_loader",)
        return " ".join(map(stamp_of_package, packages)).strip()

    def voices(self) -> Iterable[tuple[str, str]]:
        from facescript.speech.espeak.voicebox import process_voice

        return process_voice().listed()


def open_espeak(world: World) -> EspeakEngine:
    """The engine; it reads nothing of a project."""
    return EspeakEngine()
