"""OSC messages to events: `/facescript/heard "no"`, `/facescript/arrives "ann" 10.0 0.0 80.0`; this side listens."""

from __future__ import annotations

import asyncio
import time
from hmac import compare_digest
from ipaddress import ip_address

from facescript.live.address import AddressFault, Form, parse
from facescript.live.messages import Nonsense, place, told
from facescript.live.model import Source, Teller, Told
from facescript.live.ports import check_reach
from facescript.live.sources.intake import Intake
from facescript.live.sources.osc_packet import Message, messages
from facescript.live.sources.setting import Setting

FORM = Form("osc://127.0.0.1:9000")

ROOT = "/facescript/"
"""What every address begins with; a token stands behind it, as in `/facescript/TOKEN/heard`."""


def opened(address: str, setting: Setting) -> Source:
    """Raises `AddressFault`."""
    parts = parse(address, FORM)
    check_reach(parts, setting.token)
    return Osc(address, parts.host, parts.port, setting)


class Osc(asyncio.DatagramProtocol):
    """A message an OSC message; a bundle's time tag is the time of its events. Nobody is answered."""

    def __init__(self, address: str, host: str, port: int, setting: Setting) -> None:
        self._address, self._at, self._setting, self._intake = address, (host, port), setting, Intake()
        self._root = ROOT + (f"{setting.token}/" if setting.token else "")
        self._teller: Teller

    async def run(self, teller: Teller) -> None:
        self._teller = teller
        loop = asyncio.get_running_loop()
        try:
            transport, _ = await loop.create_datagram_endpoint(lambda: self, self._at)
        except OSError as fault:
            reason = (fault.strerror or "it cannot be listened at").lower()
            raise AddressFault("FS971", address=self._address, reason=reason) from None
        try:
            host, port = transport.get_extra_info("sockname")[:2]
            shown = f"[{host}]" if ip_address(host).version == 6 else host
            self._setting.tell(f"The run listens at osc://{shown}:{port}.")
            await asyncio.Event().wait()
        finally:
            transport.close()

    def datagram_received(self, data: bytes, peer: object) -> None:
        try:
            found = messages(data)
        except Nonsense:
            self._intake.count("malformed")
            return
        for message in found:
            self._intake.told(self._teller, lambda message=message: self._read(message))  # type: ignore[misc]

    def error_received(self, fault: Exception) -> None:
        self._intake.count("errors")

    def counts(self) -> dict[str, int]:
        return self._intake.counts()

    def _read(self, message: Message) -> tuple[Told, ...]:
        """Raises `Nonsense`."""
        root, kind = message.address[: len(self._root)], message.address[len(self._root) :]
        if not compare_digest(root.encode(), self._root.encode()):
            raise Nonsense("its address is of something else")
        values = message.values
        if len(values) not in (1, 4):
            raise Nonsense("it has a text, or a name and a place")
        when = 0.0 if message.time is None else max(0.0, self._setting.clock.now() + message.time - time.time())
        return told(kind, values[0], when, place(values[1:]) if len(values) == 4 else None)
