"""Lines of standard input to events: words (`heard no`) or JSON (`{"heard": "no"}`)."""

from __future__ import annotations

import asyncio
import os
import sys
from contextlib import suppress
from threading import Thread

from facescript.live.address import AddressFault
from facescript.live.messages import LARGEST
from facescript.live.model import Source, Teller
from facescript.live.sources.intake import Intake
from facescript.live.sources.setting import Setting

PIECE = 4096
"""Bytes that are read at once: while they are, no frame is made."""

MOST_SHOWN = 20
"""Lines that are none of which it is told why."""


def opened(address: str, setting: Setting) -> Source:
    """Raises `AddressFault`."""
    if address != "stdin:":
        raise AddressFault("FS981", address=address, reason="nothing stands behind `stdin:`", example="stdin:")
    return Stdin(setting)


class Stdin:
    """Reads in a thread of its own: a terminal or a pipe may say nothing for ever."""

    def __init__(self, setting: Setting) -> None:
        self._setting, self._intake = setting, Intake()
        self._rest, self._skips, self._shown = b"", False, 0

    async def run(self, teller: Teller) -> None:
        ended, loop = asyncio.Event(), asyncio.get_running_loop()

        def reads() -> None:
            self._read(teller)
            with suppress(RuntimeError):  # the run has ended
                loop.call_soon_threadsafe(ended.set)

        Thread(target=reads, daemon=True, name="stdin").start()
        await ended.wait()

    def counts(self) -> dict[str, int]:
        return self._intake.counts()

    def _read(self, teller: Teller) -> None:
        """All lines, to the end. By its number: the buffer of a stream is locked while a thread waits in it."""
        try:
            number = sys.stdin.fileno()
            while piece := os.read(number, PIECE):
                self._take(teller, piece)
        except (OSError, ValueError, AttributeError):
            pass  # it was closed, or there is none
        if self._rest:
            self._line(teller, self._rest)

    def _take(self, teller: Teller, piece: bytes) -> None:
        *lines, self._rest = (self._rest + piece).split(b"\n")
        for line in lines:
            if not self._skips:
                self._line(teller, line)
            self._skips = False
        if len(self._rest) > LARGEST:
            if not self._skips:
                self._line(teller, self._rest)
            self._rest, self._skips = b"", True

    def _line(self, teller: Teller, line: bytes) -> None:
        if not line.strip():
            return
        why = self._intake.take(teller, line)
        if why is not None and self._shown < MOST_SHOWN:
            self._shown += 1
            self._setting.tell(f"A line of standard input is refused: {why}.")
