"""A run to all who come to a WebSocket: the layout, then frames as JSON or packed, marks and lines."""

from __future__ import annotations

import asyncio
import json
import socket
from collections.abc import Callable
from contextlib import suppress
from typing import Literal

from websockets.asyncio.server import ServerConnection, broadcast
from websockets.exceptions import ConnectionClosed
from websockets.protocol import State

from facescript.live.address import Address
from facescript.live.model import Frame, Layout, Mark, Utterance
from facescript.live.sinks.counting import Counting
from facescript.live.sinks.messages import frame_bytes, frame_text, layout_text, mark_text, utterance_text
from facescript.live.sinks.setting import Setting

Format = Literal["json", "binary"]

MOST_SAID = 20
"""What a client may say in its time here; it has one thing to say."""

SENDING = 1 << 16
"""Bytes that the system keeps on their way to a client; when they are full, frames for it are dropped."""

BEHIND = 1 << 18
"""Bytes of marks and lines that wait for a client, at most; then it has to come again."""

MADE: dict[Format, Callable[[Frame], str | bytes]] = {"json": frame_text, "binary": frame_bytes}
PATHS: dict[str, Format] = {"/": "json", "/json": "json", "/binary": "binary"}


class Client:
    """One who listens: how, and whether it keeps up."""

    def __init__(self, connection: ServerConnection, form: Format) -> None:
        self.connection, self.form = connection, form
        self.said = 0

    @property
    def waiting(self) -> int:
        """Bytes that the system does not take any more, as it does not read."""
        return self.connection.transport.get_write_buffer_size()


class WebSocketSink(Counting):
    """Listens at its address, beside what else of the run is there. To a client that does not read no frame is sent
    until it does again, and then the newest; nobody else waits for it."""

    def __init__(self, address: Address, setting: Setting) -> None:
        super().__init__(address.rate)
        self._port = setting.ports.at(address, setting.token)
        for path in PATHS:
            self._port.connected(path, self._attend)
        self._begun = asyncio.Event()
        self._clients: set[Client] = set()
        self._newest: Frame | None = None
        self._counts.update(clients=0, refused=0)

    async def open(self, layout: Layout) -> None:
        self._layout = layout_text(layout)
        self._begun.set()

    @property
    def port(self) -> int:
        """Where it listens."""
        return self._port.bound

    def frame(self, frame: Frame) -> None:
        if not self.due(frame):
            return
        self._newest = frame
        listening = [one for one in self._clients if one.connection.state is State.OPEN]
        ready = [one for one in listening if not one.waiting]
        for form, made in MADE.items():
            wanting = [one.connection for one in ready if one.form == form]
            if wanting:
                broadcast(wanting, made(frame))
        self._counts["sent"] += len(ready)
        self._counts["dropped"] += len(listening) - len(ready)

    def mark(self, mark: Mark) -> None:
        self._tell(mark_text(mark))

    def utter(self, utterance: Utterance) -> None:
        self._tell(utterance_text(utterance))

    async def close(self) -> None:
        """Nothing: whoever opened the ports of the run closes them."""

    def _tell(self, text: str) -> None:
        """Sends to all what is not said twice; who is too far behind for it is sent away."""
        for client in list(self._clients):
            if client.waiting + len(text) > BEHIND:
                client.connection.transport.abort()
                self._counts["dropped"] += 1
        broadcast((client.connection for client in self._clients), text)

    async def _attend(self, connection: ServerConnection) -> None:
        """One client, from its first word to its last."""
        assert connection.request is not None
        await self._begun.wait()
        client = Client(connection, PATHS[connection.request.path.partition("?")[0]])
        with suppress(OSError):
            connection.transport.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SENDING)
        broadcast([connection], self._layout)
        self._show_newest(client)
        self._clients.add(client)
        self._counts["clients"] += 1
        try:
            async for said in connection:
                if not self._hear(client, said):
                    break
            await connection.close(1008, "the only thing to say is a format")
        except ConnectionClosed:
            pass
        finally:
            self._clients.discard(client)

    def _show_newest(self, client: Client) -> None:
        """What is true now, so that who comes late need not wait for it."""
        if self._newest is not None:
            broadcast([client.connection], MADE[client.form](self._newest))

    def _hear(self, client: Client, said: str | bytes) -> bool:
        """Takes the format that a client asks for; whether it may stay."""
        client.said += 1
        asked = _format(said)
        if asked is None:
            self._counts["refused"] += 1
            refusal = {"type": "refused", "why": 'say {"format": "json"} or {"format": "binary"}'}
            broadcast([client.connection], json.dumps(refusal))
        else:
            client.form = asked
        return client.said < MOST_SAID


def _format(said: str | bytes) -> Format | None:
    """The format that a message asks for, if it is one."""
    try:
        message = json.loads(said) if isinstance(said, str) else None
    except (ValueError, RecursionError):
        return None
    asked = message.get("format") if isinstance(message, dict) else None
    return asked if asked in ("json", "binary") else None
