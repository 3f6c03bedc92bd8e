"""`facescript preview`: a script to a page on this machine, which shows it as it is edited."""

from __future__ import annotations

import argparse
import asyncio
import errno
import webbrowser
from contextlib import suppress
from importlib.util import find_spec

from facescript.cli.report import OptionFault, refuse
from facescript.project import STANDARD, open_script
from facescript.world import WorldFailure

LARGEST_PORT = 65_535


def run(options: argparse.Namespace) -> int:
    """Serves until it is interrupted. Raises `OptionFault`."""
    if find_spec("websockets") is None:
        raise OptionFault("FS960", command="preview", extra="preview")
    port = _port(options.port)
    try:
        source, world = open_script(options.script)
    except WorldFailure as fault:
        return refuse("FS901", name=options.script, reason=fault.args[0])
    from facescript.preview.borrowed import Borrowed
    from facescript.preview.editor import Editor
    from facescript.preview.paper import Paper
    from facescript.preview.server import USUAL, run

    path = None if options.script == STANDARD else world.path(source.name)
    editor = Editor() if options.editor else None
    paper = Paper(path, source.text) if editor is None else Borrowed(editor, source.text)

    def told(address: str) -> None:
        if editor is not None:
            editor.tell("address", url=address)
            return
        print(f"{options.script} is shown at {address} (Ctrl-C ends it)", flush=True)
        if options.open:
            webbrowser.open(address)

    with suppress(KeyboardInterrupt):
        for tried in (USUAL, 0) if port is None and editor is None else (port or 0,):
            try:
                asyncio.run(run(paper, world, source.name, tried, told, editor))
                break
            except OSError as fault:
                if fault.errno not in (errno.EADDRINUSE, errno.EACCES):
                    raise
                if tried != USUAL or port is not None:
                    raise OptionFault("FS967", port=tried, reason=(fault.strerror or "it is taken").lower()) from None
    return 0


def _port(text: str | None) -> int | None:
    """The port asked for; 0 is any that is free. Raises `OptionFault`."""
    if text is None:
        return None
    if not text.isascii() or not text.isdigit() or int(text[:6]) > LARGEST_PORT:
        raise OptionFault("FS904", option="--port", value=text, example="8080")
    return int(text)
