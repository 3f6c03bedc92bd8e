"""`facescript preview` as a process of its own, for tests and benchmarks: its address, its script's file, its pages."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any

from websockets.sync.client import ClientConnection, connect

Message = dict[str, Any]

SCRIPT = """\
film 480x270, seed 2
use "parts.face"
face ada = woman, hair still
    life still
scene one:
    wait 500ms
    show smile 40% for 1s
    wait 500ms
    show wry
    wait 2s
"""
PARTS = "expression wry = smile.left 60%\n"
"""What the preview of all tests shows, and the file that it uses."""


WITH_EDITOR = """
from pathlib import Path
from facescript.cli.main import program
from facescript.preview import doors
doors.EDITOR = Path({editor!r})
program()
"""


class Serving:
    """A preview of `text` in a file of `folder`, or without a text the playground, on a port of its own; `editor` is
    the bundle that stands for `editor.js`."""

    def __init__(self, folder: Path, text: str | None, *words: str, editor: Path | None = None) -> None:
        self.script = folder / "script.face"
        program = ["-m", "facescript.cli.main"] if editor is None else ["-c", WITH_EDITOR.format(editor=str(editor))]
        command = [sys.executable, *program, "preview", "--port", "0", *words]
        if text is not None:
            self.script.write_text(text, "utf-8")
            command.append(str(self.script))
        self.process = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, text=True, env=dict(os.environ))
        assert self.process.stdout is not None
        found = re.search(r"http://127\.0\.0\.1:(\d+)/", self.process.stdout.readline())
        assert found is not None
        self.address, self.port = found[0], int(found[1])

    def __enter__(self) -> Serving:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, at: TracebackType | None) -> None:
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        self.process.wait(timeout=20)

    def page(self, **options: Any) -> ClientConnection:
        """A page's WebSocket, as it says that it comes from the server's own page."""
        origin = self.address.rstrip("/")
        address = f"ws://127.0.0.1:{self.port}/live"
        return connect(
            address,
            **{"origin": origin, "max_size": None, "max_queue": None, "compression": None, "legacy": True, **options},
        )


def read(message: str | bytes) -> Message:
    """A message as an object; `numbers` is how many numbers it has besides."""
    if isinstance(message, str):
        return dict(json.loads(message))
    length = int.from_bytes(message[:4], "little")
    return {**json.loads(message[4 : 4 + length]), "numbers": (len(message) - 4 - length) // 4}


def until(page: ClientConnection, is_it: Callable[[Message], bool], seconds: float = 30.0) -> list[Message]:
    """What a page is told, up to the first message that is it."""
    found: list[Message] = []
    while not found or not is_it(found[-1]):
        found.append(read(page.recv(timeout=seconds)))
    return found


def said(page: ClientConnection, kind: str, **values: Any) -> None:
    page.send(json.dumps({"kind": kind, **values}))
