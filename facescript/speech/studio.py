"""Lines of a project to speech: by its voice, or by the recordings and the files of times that lines name."""

from __future__ import annotations

from dataclasses import replace

from facescript.ir.acts import Say
from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.model import Spoken, VoiceBox
from facescript.speech.spool import Spool
from facescript.speech.voices.ensemble import Ensemble
from facescript.world import World


class Studio:
    """A `VoiceBox` for a project: what a line names is read from `world`, all else is spoken by `voice`. The sound of
    a long script is kept in a file; that of one without end is not kept."""

    def __init__(self, world: World, voice: VoiceBox, *, endless: bool = False) -> None:
        self._world, self._voice, self._spool = world, voice, None if endless else Spool()

    def speak(self, line: Say) -> Spoken:
        spoken = _stressed(self._spoken(line), line)
        return spoken if self._spool is None else replace(spoken, sound=self._spool.keep(spoken.pcm))

    def _spoken(self, line: Say) -> Spoken:
        if line.recording is None and line.times is None:
            return self._voice.speak(line)
        from facescript.speech.recorded import recorded  # numpy: only lines with files pay it

        return recorded(line, self._world, self._voice)


def _stressed(spoken: Spoken, line: Say) -> Spoken:
    """The line with the words marked that its text stresses, whatever has spoken it."""
    marks = [(mark.start, mark.end) for mark in line.stretches if mark.kind == "stress"]
    if not marks:
        return spoken
    words = (
        replace(word, stress=any(word.first < end and start < word.last for start, end in marks))
        for word in spoken.words
    )
    return replace(spoken, words=tuple(words))


def open_studio(world: World, *, endless: bool = False) -> VoiceBox:
    """The voices of all engines, and the files of a project; `endless` for what goes on saying new lines."""
    return Studio(world, Ensemble(world, open_voice()), endless=endless)
