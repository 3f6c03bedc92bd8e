"""Lines to speech without a wait: what would take long to speak has estimated times until there is time for it."""

from __future__ import annotations

import time
from collections import OrderedDict
from collections.abc import Callable

from facescript.ir.acts import Say
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.model import Spoken, VoiceBox, VoiceFailure
from facescript.world import World

AT_ONCE = 0.15
"""Seconds that a compilation may speak; lines that a voice said before take next to none of it."""

KEPT = 4_096
"""Lines that are kept."""


class Answers:
    """A `VoiceBox` that gives one line one answer as long as it is the same object: what is kept of a script's state
    from one compilation to the next rests on that."""

    def __init__(self, speak: Callable[[Say], Spoken]) -> None:
        self._speak = speak

    def speak(self, line: Say) -> Spoken:
        """The line, spoken or estimated. Raises `VoiceFailure`."""
        return self._speak(line)


class PatientVoice:
    """Speaks by `voice` for a while and then estimates; lines that wait are spoken by `catch_up`. `answers` is what a
    compilation asks."""

    def __init__(self, world: World, voice: VoiceBox) -> None:
        self._voice, self._estimates = voice, EstimatedVoice(world)
        self._kept: OrderedDict[object, Spoken | VoiceFailure] = OrderedDict()
        self._waiting: dict[object, Say] = {}
        self._left = AT_ONCE
        self._guessed = False
        self.answers = Answers(self._speak)

    def begin(self) -> None:
        """A compilation begins: lines that waited for another are forgotten, and may have other answers now."""
        self._waiting.clear()
        self._left = AT_ONCE
        if self._guessed:
            self._guessed, self.answers = False, Answers(self._speak)

    def _speak(self, line: Say) -> Spoken:
        if line.recording is not None or line.times is not None:
            return self._voice.speak(line)  # its file may be another now
        key = _key(line)
        if key not in self._kept:
            if self._left <= 0:
                self._waiting[key], self._guessed = line, True
                return self._estimates.speak(line)
            self._say(key, line)
        self._kept.move_to_end(key)
        found = self._kept[key]
        if isinstance(found, VoiceFailure):
            raise found
        return found

    @property
    def waiting(self) -> bool:
        """Whether lines have estimated times still, and wait to be spoken."""
        return bool(self._waiting)

    def catch_up(self) -> None:
        """Speaks one of the lines that wait."""
        key = next(iter(self._waiting))
        self._say(key, self._waiting.pop(key))

    def _say(self, key: object, line: Say) -> None:
        begun = time.perf_counter()
        try:
            self._kept[key] = self._voice.speak(line)
        except VoiceFailure as fault:
            self._kept[key] = fault
        self._left -= time.perf_counter() - begun
        while len(self._kept) > KEPT:
            self._kept.popitem(last=False)


def _key(line: Say) -> object:
    """What a line's sound depends on."""
    return line.text, line.voice, line.stretches
