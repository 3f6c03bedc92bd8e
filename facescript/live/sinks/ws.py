"""A run to all who come to a WebSocket: the layout, then frames as JSON or packed, marks and lines."""

from __future__ import annotations

import errno
import json
import logging
import socket
from collections.abc import Callable
from contextlib import suppress
from http import HTTPStatus
from typing import Literal

from websockets.asyncio.server import Server, ServerConnection, broadcast, serve
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response
from websockets.protocol import State

from facescript.live.address import Address, AddressFault
from facescript.live.callers import LOOPBACK, Callers
from facescript.live.model import Frame, Layout, Mark, Utterance
from facescript.live.sinks.counting import Counting
from facescript.live.sinks.messages import frame_bytes, frame_text, layout_text, mark_text, utterance_text
from facescript.live.sinks.setting import Setting

Format = Literal["json", "binary"]

MOST_CLIENTS = 256

LARGEST_MESSAGE = 1024
"""Bytes of what a client may say."""

MOST_SAID = 20
"""What a client may say in its time here; it has one thing to say."""

SENDING = 1 << 16
"""Bytes that the system keeps on their way to a client; when they are full, frames for it are dropped."""

BEHIND = 1 << 18
"""Bytes of marks and lines that wait for a client, at most; then it has to come again."""

PING, LOST, CLOSING = 5.0, 15.0, 1.0
"""Seconds between two pings, until a client that answers none is taken as gone, and for its last word."""

MADE: dict[Format, Callable[[Frame], str | bytes]] = {"json": frame_text, "binary": frame_bytes}
PATHS: dict[str, Format] = {"/": "json", "/json": "json", "/binary": "binary"}

QUIET = logging.getLogger("facescript.live.ws")
"""What a broken client does is counted, not told."""
QUIET.addHandler(logging.NullHandler())
QUIET.propagate = False


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
    """Listens at its address. To a client that does not read no frame is sent until it does again, and then the
    newest; nobody else waits for it."""

    def __init__(self, address: Address, setting: Setting) -> None:
        super().__init__(address.rate)
        self._address, self._setting = address, setting
        self._callers = Callers(setting.token)
        self._clients: set[Client] = set()
        self._newest: Frame | None = None
        self._server: Server | None = None
        self._counts.update(clients=0, refused=0)

    async def open(self, layout: Layout) -> None:
        host, port = self._address.host, self._address.port
        if host not in LOOPBACK and not self._setting.token:
            raise AddressFault("FS983", address=self._address.text)
        self._layout = layout_text(layout)
        try:
            self._server = await self._serve("127.0.0.1" if host == "localhost" else host, port)
        except OSError as fault:
            raise AddressFault("FS982", address=self._address.text, reason=_reason(fault)) from None
        self.port: int = next(iter(self._server.sockets)).getsockname()[1]
        shown = f"[{host}]" if ":" in host else host
        self._setting.tell(f"The stream is at ws://{shown}:{self.port}/json and /binary.")

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
        if self._server is not None:
            self._server.close(code=1001)
            await self._server.wait_closed()

    def _tell(self, text: str) -> None:
        """Sends to all what is not said twice; who is too far behind for it is sent away."""
        for client in list(self._clients):
            if client.waiting + len(text) > BEHIND:
                client.connection.transport.abort()
                self._counts["dropped"] += 1
        broadcast((client.connection for client in self._clients), text)

    async def _serve(self, host: str, port: int) -> Server:
        return await serve(
            self._attend,
            host,
            port,
            process_request=self._admit,
            compression=None,
            max_size=LARGEST_MESSAGE,
            max_queue=4,
            ping_interval=PING,
            ping_timeout=LOST,
            open_timeout=5.0,
            close_timeout=CLOSING,
            server_header=None,
            logger=QUIET,
        )

    def _admit(self, connection: ServerConnection, request: Request) -> Response | None:
        """None for who may come in; else the answer."""
        status = None
        if not self._callers.welcome(request):
            status = HTTPStatus.FORBIDDEN
        elif request.path.partition("?")[0] not in PATHS:
            status = HTTPStatus.NOT_FOUND
        elif len(self._clients) >= MOST_CLIENTS:
            status = HTTPStatus.SERVICE_UNAVAILABLE
        if status is None:
            return None
        self._counts["refused"] += 1
        return connection.respond(status, f"{status.phrase}\n")

    async def _attend(self, connection: ServerConnection) -> None:
        """One client, from its first word to its last."""
        assert connection.request is not None
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


def _reason(fault: OSError) -> str:
    known = {errno.EADDRINUSE: "another program listens there", errno.EACCES: "the system keeps that port for itself"}
    known[errno.EADDRNOTAVAIL] = "this machine has no such address"
    return known.get(fault.errno or 0, (fault.strerror or "it does not work").lower())
