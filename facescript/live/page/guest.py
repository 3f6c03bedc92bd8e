"""Messages to one page that is open: what it must be told in its turn, and of frames only the newest."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Iterable
from contextlib import suppress

from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from facescript.web.messages import is_text
from facescript.web.sayings import Pace

AHEAD = 6
"""Frames that may be on their way to a page beyond the last that it has drawn; a page in the background draws none."""

BEHIND = 64 << 20
"""Bytes that wait for a page, frames aside, at most; then it has to come again."""

QUICKEST = 150
"""Messages a second from a page, over a few seconds: it says which frames it has drawn."""


class Guest:
    """A page: what waits to be sent to it, which frame it has drawn, and the `pace` at which it speaks."""

    def __init__(self, connection: ServerConnection, waiting: Iterable[bytes]) -> None:
        self.pace = Pace(QUICKEST)
        self.sent = self.dropped = 0
        self._connection = connection
        self._waiting = deque[bytes]()
        self._size = 0
        self._frame: bytes | None = None
        self._under_way = deque[int]()
        self._some = asyncio.Event()
        for message in waiting:
            self.tell(message)

    @property
    def idle(self) -> bool:
        """Whether the page draws no frames now: so many are on their way that it has not drawn."""
        return len(self._under_way) >= AHEAD

    def tell(self, message: bytes) -> None:
        """Sends a message in its turn; never waits."""
        self._size += len(message)
        if self._size > BEHIND:
            self._connection.transport.abort()
            return
        self._waiting.append(message)
        self._some.set()

    def show(self, number: int, frame: bytes) -> None:
        """Sends a frame unless the page is idle; one that still waits is dropped for it."""
        self.dropped += self.idle or self._frame is not None
        if self.idle:
            return
        if self._frame is None:
            self._under_way.append(number)
        self._frame = frame
        self._some.set()

    def drew(self, number: int) -> None:
        """The page has drawn this frame, and will draw none before it."""
        while self._under_way and self._under_way[0] <= number:
            self._under_way.popleft()

    async def send(self) -> None:
        """Sends what waits, until the page is gone."""
        with suppress(ConnectionClosed):
            while True:
                await self._some.wait()
                self._some.clear()
                await self._send()

    async def _send(self) -> None:
        while self._waiting:
            message = self._waiting.popleft()
            await self._connection.send(message, text=is_text(message))
            self._size -= len(message)
        if self._frame is not None:
            frame, self._frame = self._frame, None
            await self._connection.send(frame, text=False)
            self.sent += 1
