"""A port that parts of a run share: WebSockets, answers and posts, each at its path, for who may come in."""

from __future__ import annotations

import asyncio
import errno
import logging
import re
import socket
from collections.abc import Awaitable, Callable
from contextlib import suppress
from http import HTTPStatus
from typing import Any

from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.datastructures import Headers
from websockets.http11 import Request, Response

from facescript.live.address import Address, AddressFault
from facescript.live.callers import Callers
from facescript.live.messages import LARGEST
from facescript.web.doors import refused

MOST = 256
"""Connections of WebSockets at once."""

PING, LOST, CLOSING = 5.0, 15.0, 1.0
"""Seconds between two pings, until a client that answers none is taken as gone, and for its last word."""

LARGEST_HEAD = 8192
"""Bytes of a request before its body."""

REASONS = {
    errno.EADDRINUSE: "the port is in use by another program",
    errno.EACCES: "the system keeps that port for itself",
    errno.EADDRNOTAVAIL: "this machine has no such address",
}

AT_ONCE = 8192
"""Bytes of a connection that the system keeps: what is there is read at once, and frames wait for that."""

POST = re.compile(r"POST (/[!-~]{0,2000}) HTTP/1\.[01]", re.ASCII)
HEADER = re.compile(r"([!#$%&'*+.^_`|~0-9A-Za-z-]{1,100}):[ \t]*([^\r\n\0]*?)[ \t]*", re.ASCII)

Handler = Callable[[ServerConnection], Awaitable[None]]
Answer = Callable[[Request], Response]
Posted = Callable[[Request, bytes], Response]

QUIET = logging.getLogger("facescript.live.port")
QUIET.addHandler(logging.NullHandler())
QUIET.propagate = False


class Port:
    """A server at a host and a port, for those whom `callers.py` lets in."""

    def __init__(self, address: Address, token: str) -> None:
        self._address, self._callers = address, Callers(token)
        self._sockets: dict[str, Handler] = {}
        self._answers: dict[str, Answer] = {}
        self._posts: dict[str, Posted] = {}
        self._server: Server | None = None
        self.bound = 0

    def connected(self, path: str, handler: Handler) -> None:
        """WebSockets at a path are given to `handler`. Raises `AddressFault` where another has it."""
        if path in self._sockets:
            raise AddressFault("FS982", address=self._address.text, reason=f"`{path}` is taken already")
        self._sockets[path] = handler

    def answered(self, path: str, answer: Answer) -> None:
        """Who asks for a path gets an answer."""
        self._answers[path] = answer

    def posted(self, path: str, answer: Posted) -> None:
        """What is posted to a path, and to all below it, gets an answer."""
        self._posts[path] = answer

    async def open(self) -> list[str]:
        """Begins; where its parts are reached. Raises `AddressFault`."""
        host = self._address.host

        class Here(Doorway):
            port = self

        try:
            self._server = await serve(
                self._receive,
                host,
                self._address.port,
                process_request=self._ask,
                create_connection=Here,
                max_size=16 * LARGEST,
                max_queue=16,
                compression=None,
                open_timeout=5.0,
                close_timeout=CLOSING,
                ping_interval=PING,
                ping_timeout=LOST,
                logger=QUIET,
            )
        except OSError as fault:
            reason = REASONS.get(fault.errno or 0, (fault.strerror or "it cannot be listened at").lower())
            raise AddressFault("FS982", address=self._address.text, reason=reason) from None
        self.bound = next(iter(self._server.sockets)).getsockname()[1]
        at = f"[{host}]:{self.bound}" if ":" in host else f"{host}:{self.bound}"
        return [f"ws://{at}{path}" for path in self._sockets] + ([f"http://{at}"] if self._posts else [])

    async def close(self) -> None:
        if self._server is not None:
            self._server.close()
            await self._server.wait_closed()

    def post(self, request: Request, body: bytes) -> Response:
        """The answer to what is posted."""
        if not self._callers.welcome(request):
            return refused(HTTPStatus.FORBIDDEN)
        answer = self._posts.get("/" + request.path.split("?")[0].split("/")[1])
        return refused(HTTPStatus.NOT_FOUND) if answer is None else answer(request, body)

    def _ask(self, connection: ServerConnection, request: Request) -> Response | None:
        if not self._callers.welcome(request):
            return refused(HTTPStatus.FORBIDDEN)
        path = request.path.partition("?")[0]
        if path in self._sockets and "Upgrade" in request.headers:
            full = self._server is None or len(self._server.connections) >= MOST
            return refused(HTTPStatus.SERVICE_UNAVAILABLE) if full else None
        answer = self._answers.get(path)
        return refused(HTTPStatus.NOT_FOUND) if answer is None else answer(request)

    async def _receive(self, connection: ServerConnection) -> None:
        assert connection.request is not None
        await self._sockets[connection.request.path.partition("?")[0]](connection)


class Doorway(ServerConnection):
    """A connection that is a WebSocket's, or one post and its answer: the library reads requests without a body."""

    port: Port

    def __init__(self, *values: Any, **named: Any) -> None:
        super().__init__(*values, **named)
        self._gathered, self._decided = b"", False

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        super().connection_made(transport)
        with suppress(OSError):
            transport.get_extra_info("socket").setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, AT_ONCE)

    def data_received(self, data: bytes) -> None:
        if self._decided:
            super().data_received(data)
            return
        self._gathered += data
        if not self._gathered.startswith(b"POST "[: len(self._gathered)]):
            self._decided = True
            super().data_received(self._gathered)
            self._gathered = b""
        elif len(self._gathered) >= 5:
            self._post()

    def _post(self) -> None:
        """Answers when all is there; a connection has one post."""
        head, end, body = self._gathered.partition(b"\r\n\r\n")
        if not end and len(head) <= LARGEST_HEAD:
            return
        try:
            request, size = posted(head)
        except ValueError:
            self._answer(refused(HTTPStatus.BAD_REQUEST))
            return
        if size > LARGEST:
            self._answer(refused(HTTPStatus.REQUEST_ENTITY_TOO_LARGE))
        elif len(body) >= size:
            self._answer(self.port.post(request, body[:size]))

    def _answer(self, response: Response) -> None:
        if not self.transport.is_closing():
            self.transport.write(response.serialize())
            self.transport.close()


def posted(head: bytes) -> tuple[Request, int]:
    """The head of a post to a request and the size of its body, bytes. Raises `ValueError`."""
    first, *lines = head.decode("latin-1").split("\r\n")
    asked, named = POST.fullmatch(first), [HEADER.fullmatch(line) for line in lines]
    if asked is None or len(head) > LARGEST_HEAD or not all(named):
        raise ValueError
    headers = Headers()
    for found in named:
        assert found is not None
        headers[found[1]] = found[2]
    sizes = headers.get_all("Content-Length")
    if "Transfer-Encoding" in headers or len(sizes) != 1 or not re.fullmatch(r"\d{1,9}", sizes[0], re.ASCII):
        raise ValueError
    return Request(asked[1], headers), int(sizes[0])
