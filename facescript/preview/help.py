"""A page's WebSocket `/lsp` to a language server of its own, which runs as a process and ends with the connection."""

from __future__ import annotations

import asyncio
import json
import sys
from asyncio.subprocess import DEVNULL, PIPE, Process
from importlib.util import find_spec

from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed
from websockets.frames import CloseCode

COMMAND = (sys.executable, "-m", "facescript.cli.main", "lsp")

MOST = 4
"""Language servers at one time."""

LARGEST = 64 * 1024 * 1024
"""Bytes of an answer."""

PATIENCE = 2.0
"""Seconds that a language server has to end by itself."""

ABSENT = 4404
"""What a connection is closed with where the extra `lsp` is not installed."""


class Helpers:
    """The language servers of all pages."""

    def __init__(self) -> None:
        self._running = 0

    async def help(self, connection: ServerConnection) -> None:
        """Talk for a connection until it ends."""
        if find_spec("pygls") is None:
            await connection.close(ABSENT, 'for help while you write: pip install "facescript[lsp]"')
        elif self._running >= MOST:
            await connection.close(CloseCode.TRY_AGAIN_LATER, f"{MOST} pages are helped already")
        else:
            self._running += 1
            try:
                await _served(connection)
            finally:
                self._running -= 1


async def _served(connection: ServerConnection) -> None:
    process = await asyncio.create_subprocess_exec(*COMMAND, stdin=PIPE, stdout=PIPE, stderr=DEVNULL)
    ways = [asyncio.create_task(_asked(connection, process)), asyncio.create_task(_answered(connection, process))]
    try:
        await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for way in ways:
            way.cancel()
        await asyncio.gather(*ways, return_exceptions=True)
        await _ended(process)
    await connection.close()


async def _asked(connection: ServerConnection, process: Process) -> None:
    """Pass on what the page sends. What is no message of the protocol ends the connection."""
    assert process.stdin is not None
    async for message in connection:
        if not _is_call(message):
            await connection.close(CloseCode.UNSUPPORTED_DATA, "no message of the language server protocol")
            return
        data = message.encode() if isinstance(message, str) else message
        process.stdin.write(b"Content-Length: %d\r\n\r\n%b" % (len(data), data))
        await process.stdin.drain()


def _is_call(message: str | bytes) -> bool:
    try:
        return isinstance(message, str) and isinstance(json.loads(message), dict)
    except (ValueError, RecursionError):
        return False


async def _answered(connection: ServerConnection, process: Process) -> None:
    """Pass on what the language server sends, until it ends or the connection does."""
    assert process.stdout is not None
    try:
        while size := _size(await process.stdout.readuntil(b"\r\n\r\n")):
            await connection.send((await process.stdout.readexactly(size)).decode())
    except (asyncio.IncompleteReadError, ConnectionClosed):
        return


def _size(head: bytes) -> int:
    """The length that a head tells of; 0 where it tells of none, or of too much."""
    for line in head.split(b"\r\n"):
        name, _, value = line.partition(b":")
        if name.lower() == b"content-length" and value.strip().isdigit():
            size = int(value)
            return size if size <= LARGEST else 0
    return 0


async def _ended(process: Process) -> None:
    """Let it see the end of its input; what does not end by that is ended."""
    assert process.stdin is not None
    process.stdin.close()
    try:
        await asyncio.wait_for(process.wait(), PATIENCE)
    except TimeoutError:
        pass
    finally:
        if process.returncode is None:
            process.kill()
            await process.wait()
