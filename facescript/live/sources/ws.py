"""Messages of WebSocket clients to events: this side listens. What is refused is answered, with the reason."""

from __future__ import annotations

import asyncio
import json
from contextlib import suppress

from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from facescript.live.address import Form, parse
from facescript.live.model import Source, Teller
from facescript.live.sources.intake import Intake
from facescript.live.sources.setting import Setting

FORM = Form("ws://127.0.0.1:8080", path=True)

PATH = "events"
"""Where events are told if the address names no path: the stream of a sink at the same port is at another."""


def opened(address: str, setting: Setting) -> Source:
    """Raises `AddressFault`."""
    parts = parse(address, FORM)
    source = WebSocket()
    port = setting.ports.at(parts, setting.token)
    port.connected(f"/{parts.path or PATH}", source.receive)
    return source


class WebSocket:
    """A message a WebSocket message, in JSON or in words."""

    def __init__(self) -> None:
        self._intake = Intake()
        self._teller: asyncio.Future[Teller] = asyncio.get_running_loop().create_future()

    async def run(self, teller: Teller) -> None:
        self._teller.set_result(teller)
        await asyncio.Event().wait()

    async def receive(self, connection: ServerConnection) -> None:
        """A client, from its first message to its last."""
        teller = await asyncio.shield(self._teller)
        self._intake.count("connections")
        with suppress(ConnectionClosed):
            async for message in connection:
                why = self._intake.take(teller, message)
                if why is not None:
                    await connection.send(json.dumps({"refused": why}))
                await asyncio.sleep(0)  # messages that are there already are read without a pause

    def counts(self) -> dict[str, int]:
        return self._intake.counts()
