"""Lines to the times that they had when they were last spoken, else to estimates, for `check`: no voice is started."""

from __future__ import annotations

from facescript.ir.acts import Say
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.model import Spoken
from facescript.speech.voices.registry import open_engine
from facescript.speech.voices.store import ROOM, known
from facescript.world import World


class KnownTimes:
    """A `VoiceBox` without a voice. A line that was spoken before has its own times, every other is `estimated`."""

    def __init__(self, world: World) -> None:
        self._world, self._estimates = world, EstimatedVoice(world)
        self._stamp = ROOM.stamp()

    def turn_to(self, world: World) -> KnownTimes:
        """Itself in another state of the project, where a line without a file has the same times as ever; another
        voice once any line was spoken since."""
        if ROOM.stamp() != self._stamp:
            return KnownTimes(world)
        self._world, self._estimates = world, EstimatedVoice(world)
        return self

    def speak(self, line: Say) -> Spoken:
        estimate = self._estimates.speak(line)
        if line.recording is not None or line.times is not None:
            return estimate
        identity = open_engine(line.voice.engine, self._world).identity(line.voice)
        return known(line, identity) or estimate
