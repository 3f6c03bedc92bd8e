"""A script's text to one self-contained page: the `.html` output, with the script readable beside the face.

It is made in a process of its own, so that a long film neither holds up the preview nor what others write meanwhile.
"""

from __future__ import annotations

import asyncio
import sys
from asyncio.subprocess import DEVNULL, PIPE
from collections.abc import Callable
from pathlib import Path

from facescript.backends.job import Job, JobFailure
from facescript.backends.page.wish import PageWish
from facescript.compile import Settings
from facescript.diagnostics.model import Severity
from facescript.pictures import PictureFailure
from facescript.project import compile_any
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.web.messages import text
from facescript.world import World

Tell = Callable[[bytes], None]
"""Takes a message for a page."""

PATIENCE = 180.0
"""Seconds after which a page that is not made is given up."""

REFUSED = 3
"""The exit code of one that cannot be made; why is on standard output."""


class Sharing:
    """Pages of the script `name` of the project in `root`, made one at a time into `folder`; the last one stays."""

    def __init__(self, root: Path, name: str, folder: Path) -> None:
        self._root, self._name, self._folder = root, name, folder
        self._number = 0
        self._task: asyncio.Task[None] | None = None

    def share(self, script: str, tell: Tell) -> None:
        """Makes the page of a script's text; `tell` gets what is to be said of it."""
        if self._task is not None and not self._task.done():
            tell(text("refused", what="share", why="a page is being made already"))
            return
        self._task = asyncio.create_task(self._share(script, tell))

    async def _share(self, script: str, tell: Tell) -> None:
        target = self._folder / f"{self._number + 1}.html"
        if why := await _made(self._root, self._name, script, target):
            tell(text("refused", what="share", why=why))
            return
        self._number += 1
        (self._folder / f"{self._number - 1}.html").unlink(missing_ok=True)
        tell(text("shared", url=f"shared/{target.name}"))


async def _made(root: Path, name: str, script: str, target: Path) -> str:
    """Makes the page in a process; why it is not made, or ""."""
    command = (sys.executable, "-m", __name__, str(root), name, str(target))
    process = await asyncio.create_subprocess_exec(*command, stdin=PIPE, stdout=PIPE, stderr=DEVNULL)
    try:
        said, _ = await asyncio.wait_for(process.communicate(script.encode()), PATIENCE)
    except TimeoutError:
        return f"it was not made within {PATIENCE:.0f} s; `facescript build` takes its time"
    finally:
        if process.returncode is None:
            process.kill()
    if process.returncode == REFUSED:
        return said.decode()
    return "" if process.returncode == 0 else "what makes it failed"


def shared(world: World, source: Source) -> str:
    """The page. Raises `JobFailure`, `PictureFailure`."""
    from facescript.backends.page.document import page

    compiled = compile_any(source, world, open_studio(world), Settings())
    if compiled.score is None or compiled.play is None:
        first = next(item for item in compiled.diagnostics if item.severity is Severity.ERROR)
        raise JobFailure(f"the script has an error, {first.code}: {first.message}")
    if compiled.score.duration <= 0:
        raise JobFailure("nothing is played in it")
    wish = PageWish("script", script=source.text)
    return page(Job(compiled.play, compiled.score, world.read, 0.0, compiled.score.duration, page=wish)).text


def _main(root: str, name: str, target: str) -> int:
    source = Source(name, sys.stdin.buffer.read().decode())
    try:
        Path(target).write_text(shared(World(Path(root)), source), "utf-8", newline="\n")
    except (JobFailure, PictureFailure) as fault:
        print(fault.args[0], end="")
        return REFUSED
    return 0


if __name__ == "__main__":
    sys.exit(_main(*sys.argv[1:]))
