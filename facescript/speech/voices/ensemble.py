"""Lines to speech, each by the engine that its voice names."""

from __future__ import annotations

from facescript.ir.acts import Say
from facescript.speech.model import Spoken, VoiceBox
from facescript.speech.voices.kept import KeptVoice
from facescript.speech.voices.registry import USUAL, open_engine
from facescript.world import World


class Ensemble:
    """A `VoiceBox` of all engines: `usual` is that of voices which name none, the others are made when needed."""

    def __init__(self, world: World, usual: VoiceBox) -> None:
        self._world = world
        self._voices: dict[str, VoiceBox] = {USUAL: usual}

    def speak(self, line: Say) -> Spoken:
        name = line.voice.engine
        if name not in self._voices:
            self._voices[name] = KeptVoice(open_engine(name, self._world))
        return self._voices[name].speak(line)
