"""A run to VTube Studio: its own tracking parameters, over its plug-in interface.

VTube Studio asks its user once whether the plug-in may; what it gives then is kept, for the next run, where only this
user can read it.
"""

from __future__ import annotations

import asyncio
import hashlib
import json
from contextlib import suppress
from typing import Any

from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import WebSocketException

from facescript.cache import Room
from facescript.live.address import Address
from facescript.live.model import Frame, Layout
from facescript.live.sinks.counting import Counting, pauses
from facescript.live.sinks.faces import chosen
from facescript.live.sinks.setting import Setting
from facescript.live.sinks.vts_parameters import NAMES, parameters

PLUGIN = {"pluginName": "FaceScript", "pluginDeveloper": "FaceScript"}

TOKENS = Room("vts", largest=4096, bound=65_536)

AGAIN = 0.5
"""Seconds after which the newest frame is sent again: without any for a second, the parameters would be let go."""

DECISION = 300.0
"""Seconds that who sits before VTube Studio has to allow it."""

ANSWER = 5.0
"""Seconds that VTube Studio has for all other answers."""

CONNECTION: dict[str, Any] = {"compression": None, "open_timeout": ANSWER, "max_size": 1 << 16, "proxy": None}


class Refused(Exception):
    """VTube Studio will not have it; `args[0]` is what it says."""


class VTubeStudioSink(Counting):
    """The newest frame each time that VTube Studio has taken the one before."""

    def __init__(self, address: Address, setting: Setting) -> None:
        super().__init__(address.rate)
        self._address, self._setting = address, setting
        self._newest: Frame | None = None
        self._fresh = asyncio.Event()
        self._taken = True
        self._told: set[str] = set()
        self._task: asyncio.Task[None] | None = None

    async def open(self, layout: Layout) -> None:
        self._face = chosen(layout, self._address)
        self._task = asyncio.create_task(self._keep())

    def frame(self, frame: Frame) -> None:
        if not self.due(frame):
            return
        if not self._taken:
            self._counts["dropped"] += 1
        self._newest, self._taken = frame, False
        self._fresh.set()

    async def close(self) -> None:
        if self._task is not None:
            self._task.cancel()
            with suppress(asyncio.CancelledError):
                await self._task

    async def _keep(self) -> None:
        """Comes again whenever the connection is gone, until VTube Studio refuses."""
        host = f"[{self._address.host}]" if ":" in self._address.host else self._address.host
        place = f"ws://{host}:{self._address.port}"
        waits = pauses()
        while True:
            try:
                async with connect(place, **CONNECTION) as peer:
                    await self._enter(peer)
                    waits = pauses()
                    await self._feed(peer)
            except Refused as fault:
                self._tell(f"VTube Studio refuses: {fault}")
                return
            except (OSError, WebSocketException, ValueError, RecursionError):
                self._tell(f"VTube Studio is not at {place} yet; it is tried again. Is its plug-in API switched on?")
            await asyncio.sleep(next(waits))

    async def _enter(self, peer: ClientConnection) -> None:
        """Shows the token that is kept, or asks for one. Raises `Refused`."""
        key = hashlib.sha256(f"{self._address.host}:{self._address.port}".encode()).hexdigest()
        kept = TOKENS.head(key)
        if isinstance(kept, str) and await _authenticated(peer, kept):
            return
        self._tell("Allow FaceScript in the window of VTube Studio.")
        answer = await _asked(peer, "AuthenticationTokenRequest", PLUGIN, DECISION)
        token = str(answer.get("authenticationToken", ""))
        if not await _authenticated(peer, token):
            raise Refused("it takes back the token that it gave")
        TOKENS.save(key, token)

    async def _feed(self, peer: ClientConnection) -> None:
        """Sends the newest frame, again and again."""
        while True:
            with suppress(TimeoutError):
                await asyncio.wait_for(self._fresh.wait(), AGAIN)
            self._fresh.clear()
            if self._newest is None:
                continue
            self._taken = True
            values = parameters(self._face.pose(self._newest.values))
            listed = [{"id": name, "value": round(value, 4)} for name, value in zip(NAMES, values, strict=True)]
            data = {"faceFound": True, "mode": "set", "parameterValues": listed}
            try:
                await _asked(peer, "InjectParameterDataRequest", data, ANSWER)
                self._counts["sent"] += 1
            except Refused as fault:
                self._counts["refused"] += 1
                self._tell(f"VTube Studio refuses a frame: {fault}")

    def _tell(self, text: str) -> None:
        """Tells what has not been told yet."""
        if text not in self._told:
            self._told.add(text)
            self._setting.tell(text)


async def _authenticated(peer: ClientConnection, token: str) -> bool:
    answer = await _asked(peer, "AuthenticationRequest", {**PLUGIN, "authenticationToken": token}, ANSWER)
    return answer.get("authenticated") is True


async def _asked(peer: ClientConnection, kind: str, data: dict[str, Any], patience: float) -> dict[str, Any]:
    """Asks for something and waits for the answer. Raises `Refused`, and `OSError` where none comes."""
    request = {"apiName": "VTubeStudioPublicAPI", "apiVersion": "1.0", "requestID": kind, "messageType": kind}
    await peer.send(json.dumps({**request, "data": data}))
    async with asyncio.timeout(patience):
        while True:
            answer = json.loads(await peer.recv())
            if not isinstance(answer, dict) or answer.get("requestID") != kind:
                continue
            found = answer.get("data")
            found = found if isinstance(found, dict) else {}
            if answer.get("messageType") == "APIError":
                raise Refused(str(found.get("message", "without a reason"))[:300])
            return found
