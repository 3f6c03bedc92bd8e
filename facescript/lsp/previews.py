"""A document to the page that shows it: a process of `facescript preview`, which hears the text as it is typed.

The process speaks lines of JSON (`facescript/preview/editor.py`). It ends when its standard input does, so that none
outlives the server, however that ends.
"""

from __future__ import annotations

import asyncio
import json
import sys
from asyncio.subprocess import PIPE, Process
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

Message = dict[str, object]
Hear = Callable[[Message], None]

LONGEST = 32 * 1024 * 1024
"""Bytes of a message, and of what may wait for a process that does not read."""

PATIENCE = 30.0
"""Seconds until the page has an address."""


class NoPreview(Exception):
    """A page that cannot be had; `args[0]` says why."""


class Preview:
    """The page of one script. `hear` gets what the process says besides its `address`, `ended` the reason when it ends
    by itself."""

    def __init__(self, process: Process, hear: Hear, ended: Callable[[str], None]) -> None:
        assert process.stdin is not None and process.stdout is not None and process.stderr is not None
        self._process, self._in, self._out, self._errors = process, process.stdin, process.stdout, process.stderr
        self._hear, self._ended = hear, ended
        self._said, self._closed = "", False
        self.address = asyncio.get_running_loop().create_future()
        self._tasks = [asyncio.create_task(self._listen()), asyncio.create_task(self._gather())]

    def tell(self, kind: str, **values: object) -> None:
        """Sends a message; never waits."""
        if not self._in.is_closing() and self._in.transport.get_write_buffer_size() < LONGEST:
            self._in.write(json.dumps({"kind": kind, **values}).encode() + b"\n")

    def close(self) -> None:
        """Ends the process."""
        self._closed = True
        self._in.close()
        with suppress(ProcessLookupError):
            self._process.terminate()

    async def _listen(self) -> None:
        with suppress(ValueError, OSError):
            while line := await self._out.readline():
                message = json.loads(line)
                if message["kind"] == "address":
                    self.address.set_result(str(message["url"]))
                else:
                    self._hear(message)
        code = await self._process.wait()
        await self._tasks[1]
        if not self.address.done():
            self.address.set_exception(NoPreview(self._said or f"it ended with {code}"))
        elif not self._closed:
            self._ended(f"it ended with {code}{': ' if self._said else ''}{self._said}" if code else "")

    async def _gather(self) -> None:
        """Keeps the last line of what the process complains of."""
        with suppress(ValueError, OSError):
            while line := await self._errors.readline():
                self._said = line.decode("utf-8", "replace").strip() or self._said


async def preview(script: Path, root: Path, hear: Hear, ended: Callable[[str], None]) -> Preview:
    """The page of a script of the project in `root`, once it has its address. Raises `NoPreview`."""
    command = [sys.executable, "-P", "-m", "facescript.cli.main", "preview", str(script), "--editor"]
    try:
        process = await asyncio.create_subprocess_exec(
            *command, cwd=root, stdin=PIPE, stdout=PIPE, stderr=PIPE, limit=LONGEST
        )
    except OSError as fault:
        raise NoPreview(fault.strerror or "its process cannot be started") from None
    made = Preview(process, hear, ended)
    try:
        await asyncio.wait_for(asyncio.shield(made.address), PATIENCE)
    except TimeoutError:
        made.close()
        raise NoPreview("it takes too long to start") from None
    return made
