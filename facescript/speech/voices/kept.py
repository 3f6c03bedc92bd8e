"""Lines to speech by an engine, each spoken once: kept in memory, and in the user's cache for the next program."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import replace
from threading import Lock

from facescript.ir.acts import Say
from facescript.speech.model import Spoken
from facescript.speech.voices import store
from facescript.speech.voices.engine import Engine

LARGEST = 64 * 1024 * 1024
"""Bytes of sound kept in memory; what was used longest ago goes first."""


class KeptVoice:
    """A `VoiceBox` over an engine. Threads may share it: a line that two of them ask for is spoken once."""

    def __init__(self, engine: Engine) -> None:
        self._engine = engine
        self._kept: OrderedDict[object, Spoken] = OrderedDict()
        self._size = 0
        self._lock = Lock()

    def speak(self, line: Say) -> Spoken:
        asked = (line.text, line.stretches, replace(line.voice, volume=1.0))
        with self._lock:
            if asked in self._kept:
                self._kept.move_to_end(asked)
                return self._kept[asked]
            return self._remember(asked, self._loaded(line))

    def _loaded(self, line: Say) -> Spoken:
        """The line out of the user's cache, else spoken and put there."""
        identity = self._engine.identity(line.voice)
        if not identity:
            return self._engine.speak(line)
        key = store.key_of(line, identity)
        found = store.load(key)
        if found is None:
            found = self._engine.speak(line)
            store.save(key, found)
        return found

    def _remember(self, asked: object, line: Spoken) -> Spoken:
        self._kept[asked] = line
        self._size += len(line.pcm)
        while self._size > LARGEST and len(self._kept) > 1:
            self._size -= len(self._kept.popitem(last=False)[1].pcm)
        return line
