"""A script's name on the command line to its source and the project it stands in, and these to a score."""

from __future__ import annotations

import sys
from pathlib import Path

from facescript.compile import Compiled, Settings, compile_source
from facescript.speech.model import VoiceBox
from facescript.text import Source
from facescript.world import LARGEST_SCRIPT, World, WorldFailure, decode

STANDARD = "-"
PLAY = ".json"
"""The suffix of a play."""

LARGEST_PLAY = 32 * 1024 * 1024
"""Bytes of a play: in JSON a statement takes up many times what it takes in a script."""


def is_play(source: Source) -> bool:
    """Whether a file is a play in JSON: by its name, and of standard input by how it begins."""
    return source.name.endswith(PLAY) or (source.name == "<stdin>" and source.text.lstrip().startswith("{"))


def compile_any(source: Source, world: World, voice: VoiceBox, settings: Settings) -> Compiled:
    """A script, or a play in JSON, as far as its score."""
    if is_play(source):
        from facescript.plays import compile_play  # pydantic: only plays pay it

        return compile_play(source, world, voice, settings)
    return compile_source(source, world, voice, settings)


def open_script(name: str) -> tuple[Source, World]:
    """The script and its world: the working folder where the script lies in it, else the script's own folder.

    Raises `WorldFailure`.
    """
    here = Path.cwd()
    if name == STANDARD:
        return Source("<stdin>", decode(_standard_input())), World(here)
    path = Path(name)
    try:
        inside = path.absolute().parent.resolve() / path.name
        world = World(here) if inside.is_relative_to(here.resolve()) else World(inside.parent)
        place = inside.relative_to(world.root.resolve()).as_posix()
        largest = LARGEST_PLAY if place.endswith(PLAY) else LARGEST_SCRIPT
        return Source(place, decode(world.read(place, largest))), world
    except (OSError, ValueError, RuntimeError):
        raise WorldFailure("its path cannot be followed") from None


def _standard_input() -> bytes:
    data = sys.stdin.buffer.read(LARGEST_SCRIPT + 1)
    if len(data) > LARGEST_SCRIPT:
        raise WorldFailure(f"it is larger than {LARGEST_SCRIPT // 1024 // 1024} MiB")
    return data
