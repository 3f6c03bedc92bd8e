"""A script's name on the command line to its source and the project it stands in."""

from __future__ import annotations

import sys
from pathlib import Path

from facescript.text import Source
from facescript.world import LARGEST_SCRIPT, World, WorldFailure, decode

STANDARD = "-"


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
        return world.source(inside.relative_to(world.root.resolve()).as_posix()), world
    except (OSError, ValueError, RuntimeError):
        raise WorldFailure("its path cannot be followed") from None


def _standard_input() -> bytes:
    data = sys.stdin.buffer.read(LARGEST_SCRIPT + 1)
    if len(data) > LARGEST_SCRIPT:
        raise WorldFailure(f"it is larger than {LARGEST_SCRIPT // 1024 // 1024} MiB")
    return data
