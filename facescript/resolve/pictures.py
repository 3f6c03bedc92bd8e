"""The picture that a script names to its path in the project: it is there, and it can be shown."""

from __future__ import annotations

import re

from facescript.resolve.files import project_path
from facescript.resolve.project import Project
from facescript.text import Span
from facescript.world import LARGEST_FILE, WorldFailure

ADDRESS = re.compile(r"[A-Za-z][A-Za-z0-9+.-]+:|[/\\]{2}")
"""How what is no path begins: `https:`, `file:`, `data:`, `//host`. One letter and a colon are a drive."""


def picture_path(project: Project, path: str, span: Span, largest: int = LARGEST_FILE) -> str:
    """The path in the project of a picture of at most `largest` bytes that can be used. Raises `Refused`."""
    if ADDRESS.match(path):
        reason = "it is an address, and nothing is fetched; keep the picture in the project's folder and name that file"
        raise project.refuse("FS701", span, path=path, reason=reason)
    found = project_path(span, path)
    world = project.world_of(found)
    try:
        if (found, largest) not in project.pictures:
            project.pictures[found, largest] = _fault(world.read(found, largest))
    except WorldFailure as failure:
        raise project.refuse("FS701", span, path=path, reason=failure.args[0]) from None
    if fault := project.pictures[found, largest]:
        raise project.refuse("FS720", span, path=path, reason=fault)
    return found


def _fault(data: bytes) -> str:
    """Why a picture cannot be used, nothing where it can."""
    from facescript.pictures import PictureFailure, opened  # Pillow is loaded by scripts that have pictures alone

    try:
        opened(data)
    except PictureFailure as failure:
        return str(failure.args[0])
    return ""
