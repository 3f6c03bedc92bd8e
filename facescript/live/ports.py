"""The ports of a run: parts of it that name the same host and port share a server, and all begin together."""

from __future__ import annotations

from typing import TYPE_CHECKING

from facescript.live.address import Address, AddressFault
from facescript.live.callers import LOOPBACK

if TYPE_CHECKING:
    from facescript.live.port import Port


class Ports:
    """The ports of a run; parts that name the same share it."""

    def __init__(self) -> None:
        self._ports: list[tuple[tuple[str, int], Port]] = []

    def at(self, address: Address, token: str) -> Port:
        """The port of an address; port 0 is one that is free, and nobody else's. Raises `AddressFault`."""
        check_reach(address, token)
        from facescript.live.port import Port  # websockets: only who listens needs it

        name = address.host, address.port
        for other, port in self._ports:
            if other == name and address.port:
                return port
        self._ports.append((name, Port(address, token)))
        return self._ports[-1][1]

    async def open(self) -> list[str]:
        """Begins with all; where they are reached. Raises `AddressFault`."""
        return [place for _, port in self._ports for place in await port.open()]

    async def close(self) -> None:
        for _, port in self._ports:
            await port.close()


def check_reach(address: Address, token: str) -> None:
    """Who listens beyond this machine asks for a token. Raises `AddressFault`."""
    if not token and address.host not in LOOPBACK:
        raise AddressFault("FS983", address=address.text)
