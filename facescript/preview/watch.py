"""Files on a disk to the moments at which they change."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Iterable
from pathlib import Path

EVERY = 0.025
"""Seconds between two looks: a look is a few calls of the system."""

MOST = 200
"""Files that are looked at."""

State = tuple[int, int, int] | None


async def changes(files: Callable[[], Iterable[Path]]) -> AsyncIterator[set[Path]]:
    """The files that have changed, whenever one of those that `files` gives at the time has changed, came or went."""
    before: dict[Path, State] = {}
    while True:
        now = {path: _state(path) for path in list(files())[:MOST]}
        if changed := {path for path, state in now.items() if before.get(path, state) != state}:
            if any((now[path] or (0, 1))[1] == 0 for path in changed):
                await asyncio.sleep(EVERY)  # an editor that empties a file is about to write it
            yield changed
        before = now
        await asyncio.sleep(EVERY)


def _state(path: Path) -> State:
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino
