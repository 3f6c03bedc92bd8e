"""Frames to datagrams: what the sinks over UDP share."""

from __future__ import annotations

import asyncio
import socket
from abc import ABC, abstractmethod
from collections.abc import Sequence
from contextlib import suppress

from facescript.live.address import Address
from facescript.live.model import Frame, Layout
from facescript.live.sinks.counting import Counting, pauses
from facescript.live.sinks.setting import Setting

PATIENCE = 1.0
"""Seconds for the name of a host at the start; then the run begins without."""


class DatagramSink(Counting, ABC):
    """Sends each frame as `packets` to an address. A host whose name is not known yet is asked for again; nobody need
    be there, and nobody is waited for."""

    def __init__(self, address: Address, setting: Setting) -> None:
        super().__init__(address.rate)
        self._address, self._setting = address, setting
        self._socket: socket.socket | None = None
        self._place: tuple[object, ...] = ()
        self._finding: asyncio.Task[None] | None = None

    @abstractmethod
    def begin(self, layout: Layout) -> None:
        """Learns what frames will be. Raises `AddressFault`."""

    @abstractmethod
    def packets(self, frame: Frame) -> Sequence[bytes]:
        """The datagrams of a frame."""

    async def open(self, layout: Layout) -> None:
        self.begin(layout)
        self._finding = asyncio.create_task(self._find())
        await asyncio.wait({self._finding}, timeout=PATIENCE)

    def frame(self, frame: Frame) -> None:
        if self.due(frame):
            self.send(self.packets(frame))

    def send(self, packets: Sequence[bytes]) -> None:
        """Sends datagrams at once, or drops them."""
        for packet in packets:
            sent = False
            with suppress(OSError):  # its buffer is full, or no way leads there
                sent = self._socket is not None and bool(self._socket.sendto(packet, self._place))
            self._counts["sent" if sent else "dropped"] += 1

    async def close(self) -> None:
        if self._finding is not None:
            self._finding.cancel()
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    async def _find(self) -> None:
        """Asks for the host until it is known."""
        loop = asyncio.get_running_loop()
        for pause in pauses():
            with suppress(OSError):
                found = await loop.getaddrinfo(self._address.host, self._address.port, type=socket.SOCK_DGRAM)
                family, kind, protocol, _, self._place = found[0]
                self._socket = socket.socket(family, kind, protocol)
                self._socket.setblocking(False)
                self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
                return
            await asyncio.sleep(pause)
