"""Lines of a file or a pipe of the project to what was heard, as they are written."""

from __future__ import annotations

import asyncio
import os
import stat
from contextlib import suppress
from pathlib import Path

from facescript.live.address import AddressFault
from facescript.live.messages import LARGEST, plain
from facescript.live.model import Happening, Source, Teller, Told
from facescript.live.sources.intake import Intake
from facescript.live.sources.setting import Setting
from facescript.world import WorldFailure

OFTEN = 0.05
"""Seconds between two looks for more."""

PIECE = 65_536

MOST_SHOWN = 20
"""Lines that are none of which it is told why."""


def opened(address: str, setting: Setting) -> Source:
    """`text:FILE`. Raises `AddressFault`."""
    try:
        path = setting.world.path(address.removeprefix("text:"))
        kind = path.stat().st_mode
    except (WorldFailure, OSError) as fault:
        reason = fault.strerror if isinstance(fault, OSError) and fault.strerror else str(fault.args[0])
        raise AddressFault("FS971", address=address[:100], reason=reason.lower()) from None
    if not (stat.S_ISREG(kind) or stat.S_ISFIFO(kind)):
        raise AddressFault("FS971", address=address[:100], reason="it is no file and no pipe")
    return Text(path, setting)


class Text:
    """Follows a file: its lines, and those that are written to it later. Each is heard as if it were said."""

    def __init__(self, path: Path, setting: Setting) -> None:
        self._path, self._setting, self._intake = path, setting, Intake()
        self._rest, self._skips, self._shown = b"", False, 0

    async def run(self, teller: Teller) -> None:
        number = os.open(self._path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
        try:
            while True:
                with suppress(BlockingIOError):
                    while piece := os.read(number, PIECE):
                        self._take(teller, piece)
                        await asyncio.sleep(0)
                await asyncio.sleep(OFTEN)
        finally:
            os.close(number)

    def counts(self) -> dict[str, int]:
        return self._intake.counts()

    def _take(self, teller: Teller, piece: bytes) -> None:
        *lines, self._rest = (self._rest + piece).split(b"\n")
        for line in lines:
            if not self._skips:
                self._line(teller, line)
            self._skips = False
        if len(self._rest) > LARGEST:
            self._rest, self._skips = b"", True
            self._intake.count("too long")

    def _line(self, teller: Teller, line: bytes) -> None:
        if not line.strip():
            return
        why = self._intake.told(teller, lambda: _heard(line))
        if why is not None and self._shown < MOST_SHOWN:
            self._shown += 1
            self._setting.tell(f"a line of {self._path.name} is refused: {why}")


def _heard(line: bytes) -> tuple[Told, ...]:
    """What a line says was heard. Raises `Nonsense`."""
    return (Happening("heard", 0.0, plain(line.decode("utf-8", "replace").strip())),)
