"""Markers of a Lab Streaming Layer stream to events: a marker's text is the name of a signal, or a message in JSON."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from threading import Event, Thread

import pylsl
from pylsl.util import LostError
from pylsl.util import TimeoutError as Overdue

from facescript.live.address import AddressFault
from facescript.live.messages import LARGEST, LATEST, plain, read, told
from facescript.live.model import Source, Teller, Told
from facescript.live.sources.intake import Intake
from facescript.live.sources.setting import Setting

PATIENCE = 0.2
"""Seconds of each look for a marker, or for the stream."""

MEASURING = 3.0
"""Seconds in which another machine's clock must be found; else its markers are of when they come."""

LONGEST = 100
"""Characters of a stream's name."""

EXAMPLE = "lsl://Markers"


def opened(address: str, setting: Setting) -> Source:
    """Raises `AddressFault`."""
    name = address.removeprefix("lsl://")
    if name == address or not 0 < len(name) <= LONGEST or not name.isprintable() or "'" in name:
        reason = "the name of a stream stands behind `lsl://`"
        raise AddressFault("FS981", address=address[:LONGEST], reason=reason, example=EXAMPLE)
    return Lsl(name, setting)


class Lsl:
    """The first stream of a name that has texts, looked for until it is there, and again when it is gone. A marker's
    time is its stream's, carried over to this machine's clock."""

    def __init__(self, name: str, setting: Setting) -> None:
        self._name, self._setting, self._intake = name, setting, Intake()

    async def run(self, teller: Teller) -> None:
        stop = Event()
        thread = Thread(target=self._listen, args=(teller, stop), name="lsl", daemon=True)
        thread.start()
        try:
            await asyncio.Event().wait()
        finally:
            stop.set()
            await asyncio.shield(asyncio.to_thread(thread.join, 2.0))

    def counts(self) -> dict[str, int]:
        return self._intake.counts()

    def _listen(self, teller: Teller, stop: Event) -> None:
        wanted = f"name='{self._name}' and channel_format='string'"
        while not stop.is_set():
            found = pylsl.resolve_bypred(wanted, 1, PATIENCE)
            if found:
                self._intake.count("connections")
                with suppress(LostError):
                    self._follow(pylsl.StreamInlet(found[0], max_buflen=10, recover=False), teller, stop)

    def _follow(self, inlet: pylsl.StreamInlet, teller: Teller, stop: Event) -> None:
        """Raises `LostError` when the stream is gone."""
        offset: float | None = None
        try:
            with suppress(Overdue):
                offset = inlet.time_correction(timeout=MEASURING)
            while not stop.is_set():
                sample, stamp = inlet.pull_sample(timeout=PATIENCE)
                if sample is not None:
                    time = 0.0 if offset is None else self._time(stamp + offset)
                    self._intake.told(teller, lambda text=sample[0], time=time: _read(text, time))  # type: ignore[misc]
        finally:
            inlet.close_stream()

    def _time(self, stamp: float) -> float:
        """A time of LSL's clock as one of the run."""
        past: float = pylsl.local_clock() - stamp
        return min(LATEST, max(0.0, self._setting.clock.now() - past))


def _read(text: str, time: float) -> tuple[Told, ...]:
    """Raises `Nonsense`."""
    return read(text[: LARGEST + 1]) if text.startswith("{") else told("signal", plain(text), time)
