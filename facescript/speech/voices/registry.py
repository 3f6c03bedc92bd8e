"""Which engine's name is which program: the engines of this version, and those that plug-ins bring."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import cast

from facescript.speech.model import VoiceFailure
from facescript.speech.voices.engine import Engine
from facescript.world import World

GROUP = "facescript.voices"
"""Entry points of this group add engines: name = as in a script, value = `module:function(world) -> Engine`."""

USUAL = "espeak"


@dataclass(frozen=True, slots=True)
class Row:
    """An engine: its name, where it is made, one line of help, and whether its voices are files of the project."""

    name: str
    target: str
    help: str
    files: bool = False

    def load(self) -> Callable[[World], Engine]:
        module, _, function = self.target.partition(":")
        return cast("Callable[[World], Engine]", getattr(import_module(module), function))


ENGINES = {
    row.name: row
    for row in (
        Row(USUAL, "facescript.speech.espeak.engine:open_espeak", "espeak-ng, the usual voice of a hundred languages"),
        Row("flite", "facescript.speech.flite.engine:open_flite", "English voices of the program flite"),
        Row("piper", "facescript.speech.piper.engine:open_piper", "a voice that you bring, an .onnx file", files=True),
    )
}


def engines() -> dict[str, Row]:
    """All engines by name; a plug-in cannot take the place of one of ours."""
    from importlib.metadata import entry_points  # only who asks for more than ours pays it

    found = dict(ENGINES)
    for entry in entry_points(group=GROUP):
        found.setdefault(entry.name, Row(entry.name, entry.value, f"from {entry.value}"))
    return found


def open_engine(name: str, world: World) -> Engine:
    """The engine of a name. Raises `VoiceFailure` (FS508) where there is none."""
    row = ENGINES.get(name) or engines().get(name)
    if row is None:
        there = ", ".join(f"`{known}`" for known in engines())
        raise VoiceFailure(f"`{name}`; there are {there}", "FS508")
    return row.load()(world)
