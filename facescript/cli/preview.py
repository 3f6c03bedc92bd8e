"""`facescript preview`: a script to a page on this machine, which shows it as it is edited."""

from __future__ import annotations

import argparse
import asyncio
import errno
import webbrowser
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from facescript.cli.report import OptionFault, refuse
from facescript.cli.settings import port
from facescript.project import STANDARD, open_script
from facescript.world import World, WorldFailure

if TYPE_CHECKING:
    from facescript.preview.editor import Editor
    from facescript.preview.paper import Paper

SCRATCH = "scratch.face"
"""What a script of no file is called."""


def run(options: argparse.Namespace) -> int:
    """Serves until it is interrupted. Raises `OptionFault`."""
    if find_spec("websockets") is None:
        raise OptionFault("FS960", command="preview", extra="preview")
    found = port("--port", options.port)
    from facescript.preview.editor import Editor
    from facescript.preview.server import USUAL, run

    editor = Editor() if options.editor else None
    try:
        paper, name, world = _opened(options.script, editor)
    except WorldFailure as fault:
        return refuse("FS901", name=options.script, reason=fault.args[0])

    def told(address: str) -> None:
        if editor is not None:
            editor.tell("address", url=address)
            return
        print(f"{options.script or 'The playground'} is shown at {address} (Ctrl-C ends it)", flush=True)
        if options.open:
            webbrowser.open(address)

    with suppress(KeyboardInterrupt):
        for tried in (USUAL, 0) if found is None and editor is None else (found or 0,):
            try:
                asyncio.run(run(paper, world, name, tried, told, editor))
                break
            except OSError as fault:
                if fault.errno not in (errno.EADDRINUSE, errno.EACCES):
                    raise
                if tried != USUAL or found is not None:
                    raise OptionFault("FS967", port=tried, reason=(fault.strerror or "it is taken").lower()) from None
    return 0


def _opened(script: str | None, editor: Editor | None) -> tuple[Paper, str, World]:
    """The script, its name and its project; without one a scratch in the working folder. Raises `WorldFailure`."""
    from facescript.preview.borrowed import Borrowed
    from facescript.preview.paper import Paper

    if script is None:
        from facescript.preview.examples import first

        return Paper(None, first(), scratch=True), SCRATCH, World(Path.cwd())
    source, world = open_script(script)
    if editor is not None:
        return Borrowed(editor, source.text), source.name, world
    return Paper(None if script == STANDARD else world.path(source.name), source.text), source.name, world
