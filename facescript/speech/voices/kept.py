"""Lines to speech by an engine, each spoken once: kept in memory, and in the user's cache for the next program."""

from __future__ import annotations

import os
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import replace
from threading import Lock

from facescript.ir.acts import Say
from facescript.speech.model import Spoken
from facescript.speech.voices import store
from facescript.speech.voices.engine import Engine, Prompt

LARGEST = 24 * 1024 * 1024
"""Bytes of sound kept in memory; what was used longest ago goes first."""


class KeptVoice:
    """A `VoiceBox` over an engine. Threads may share it: a line that two of them ask for is spoken once."""

    def __init__(self, engine: Engine) -> None:
        self._engine = engine
        self._kept: OrderedDict[object, Spoken] = OrderedDict()
        self._size = 0
        self._locks: dict[int, Lock] = {}

    def speak(self, line: Say) -> Spoken:
        return self._spoken(line, self._engine.speak)[0]

    def speak_aloud(self, line: Say, take: Callable[[bytes], None]) -> Spoken:
        """The line spoken; `take` gets its sound in stretches, the first as soon as there is any: a face that is to
        answer somebody cannot wait for the whole line. `take` must not ask this voice for another line."""
        if isinstance(self._engine, Prompt):
            engine = self._engine
            spoken, new = self._spoken(line, lambda new_line: engine.speak_aloud(new_line, take))
        else:
            spoken, new = self._spoken(line, self._engine.speak)[0], False
        if not new:
            take(spoken.pcm)
        return spoken

    def _spoken(self, line: Say, speak: Callable[[Say], Spoken]) -> tuple[Spoken, bool]:
        """The line, out of memory or the user's cache or else by `speak`; whether it was spoken now."""
        asked = (line.text, line.stretches, replace(line.voice, volume=1.0))
        with self._lock():
            if asked in self._kept:
                self._kept.move_to_end(asked)
                return self._kept[asked], False
            key = self._key(line)
            found = store.load(key) if key else None
            spoken = found or speak(line)
            if key and found is None:
                store.save(key, spoken)
            self._remember(asked, spoken)
            return spoken, found is None

    def _key(self, line: Say) -> str:
        identity = self._engine.identity(line.voice)
        return store.key_of(line, identity) if identity else ""

    def _lock(self) -> Lock:
        """This process's lock: of one that a fork has copied, the holder may not be there."""
        return self._locks.setdefault(os.getpid(), Lock())

    def _remember(self, asked: object, line: Spoken) -> None:
        self._kept[asked] = line
        self._size += len(line.pcm)
        while self._size > LARGEST and len(self._kept) > 1:
            self._size -= len(self._kept.popitem(last=False)[1].pcm)
