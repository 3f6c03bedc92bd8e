"""What an engine of speech is: lines to sound with the times of words and phonemes, and what it has to say with."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Protocol, runtime_checkable

from facescript.ir.acts import Say, Voice
from facescript.speech.model import Spoken


class Engine(Protocol):
    """A `VoiceBox` that knows itself. It is made for each script and must be light to make: `check` makes it too."""

    def speak(self, line: Say) -> Spoken:
        """The line spoken at its voice's rate, pitch and range; the volume is left to the mix. Raises
        `VoiceFailure`: FS507 where the engine is not installed, FS501 where it cannot speak so."""
        ...

    def identity(self, voice: Voice) -> str:
        """What else the sound of a line depends on, such as the engine's version: lines are kept under it. "" where
        that cannot be told: then lines are not kept beyond the program. Starts nothing."""
        ...

    def voices(self) -> Iterable[tuple[str, str]]:
        """What may stand behind the engine's name, each with what it is. Raises `VoiceFailure`."""
        ...


@runtime_checkable
class Prompt(Protocol):
    """An engine that is heard before it has spoken the whole line."""

    def speak_aloud(self, line: Say, take: Callable[[bytes], None]) -> Spoken:
        """The line spoken; `take` gets its sound in stretches while it is made, each byte once."""
        ...


def stamp(*paths: Path) -> str:
    """Names, sizes and times of files: what an engine is made of, told without reading it. Raises OSError."""
    states = ((path.name, path.stat()) for path in paths)
    return " ".join(f"{name}:{state.st_size}:{state.st_mtime_ns}" for name, state in states)


@cache
def stamp_of_package(name: str) -> str:
    """The stamp of an installed package, which is not imported; "" where there is none."""
    found = find_spec(name)
    if found is None or found.origin is None:
        return ""
    try:
        return stamp(*sorted(path for path in Path(found.origin).parent.iterdir() if path.is_file()))
    except OSError:
        return ""
