"""A run, its sources and sinks to one evening: all begin together, frames are given, and all end together."""

from __future__ import annotations

import asyncio
import gc
import signal
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from math import inf

from facescript.live.address import AddressFault
from facescript.live.gate import Gate
from facescript.live.loop import Loop
from facescript.live.model import Sink, Source, Teller
from facescript.live.ports import Ports

SWITCHED = 0.001
"""Seconds that a thread of a source may go on while a frame is due."""


class Show:
    """What runs: a loop, the sinks it gives to, and the `sources` that tell its gate, by their addresses. `doubts` are
    the sightings that were not believed and the moments that could not be solved, and why."""

    def __init__(
        self,
        loop: Loop,
        gate: Gate,
        sinks: Mapping[str, Sink],
        ports: Ports,
        doubts: Callable[[], Mapping[str, int]] = dict,
    ) -> None:
        self._loop, self._gate, self._sinks, self._ports, self._doubts = loop, gate, sinks, ports, doubts
        self.sources: Mapping[str, Source] = {}

    async def run(self, seconds: float = inf, tell: Callable[[str], None] = print) -> None:
        """Until its time is over, or the process is told to end. Raises `AddressFault`."""
        try:
            for place in await self._ports.open():
                tell(f"The run listens at {place}.")
            await self._opened()
            await self._play(seconds)
        finally:
            self._loop.close()
            for sink in self._sinks.values():
                await sink.close()
            await self._ports.close()

    async def _opened(self) -> None:
        for address, sink in self._sinks.items():
            try:
                await sink.open(self._loop.layout)
            except AddressFault:
                raise
            except (OSError, ValueError) as fault:
                raise _unusable("FS982", address, fault) from None

    async def _play(self, seconds: float) -> None:
        """The loop to its end, or to the fault of a source that can never work."""
        sys.setswitchinterval(SWITCHED)
        gc.collect()
        gc.freeze()  # what was made by now stays: a look for rubbish would cost a frame
        playing = asyncio.create_task(self._loop.play(seconds))
        telling = {asyncio.create_task(_told(*named, self._gate)) for named in self.sources.items()}
        ends_on_signals(playing)
        try:
            waiting = {playing, *telling}
            while playing in waiting:
                done, waiting = await asyncio.wait(waiting, return_when=asyncio.FIRST_COMPLETED)
                for task in done - {playing}:
                    task.result()
            with suppress(asyncio.CancelledError):
                playing.result()
        finally:
            playing.cancel()
            for task in telling:
                task.cancel()
            await asyncio.gather(playing, *telling, return_exceptions=True)
            gc.unfreeze()

    def status(self) -> dict[str, object]:
        """How it goes, in counts."""
        tally = self._loop.tally
        return {
            "frames": tally.frames,
            "late": tally.late,
            "dropped": tally.dropped,
            "events": self._gate.counts(),
            "passed over": dict(self._doubts()),
            "from": {address: source.counts() for address, source in self.sources.items()},
            "to": {address: sink.counts() for address, sink in self._sinks.items()},
        }

    def summary(self) -> Iterator[str]:
        """The same for people, in lines."""
        tally, fps = self._loop.tally, self._loop.layout.fps
        yield (
            f"{tally.frames} frames in {self._loop.next / fps:.1f} s at {fps:g} a second, {tally.late} late, "
            f"{tally.dropped} dropped; 99 of 100 were given within {tally.lateness(0.01) * 1000:.1f} ms, all "
            f"within {tally.lateness(0.0) * 1000:.1f} ms"
        )
        yield from _counted("events", self._gate.counts())
        if self._doubts():
            yield from _counted("passed over", self._doubts())
        for address, source in self.sources.items():
            yield from _counted(f"from {address}", source.counts())
        for address, sink in self._sinks.items():
            yield from _counted(f"to {address}", sink.counts())


def _counted(what: str, counts: Mapping[str, int]) -> Iterator[str]:
    told = ", ".join(f"{count} {name}" for name, count in counts.items() if count)
    yield f"{what.removesuffix(':')}: {told or 'none'}"


async def _told(address: str, source: Source, teller: Teller) -> None:
    """A source to its end. Raises `AddressFault`."""
    try:
        await source.run(teller)
    except AddressFault:
        raise
    except (OSError, ValueError) as fault:
        raise _unusable("FS971", address, fault) from None


def _unusable(code: str, address: str, fault: OSError | ValueError) -> AddressFault:
    reason = fault.strerror if isinstance(fault, OSError) and fault.strerror else str(fault)
    return AddressFault(code, address=address, reason=reason or "it cannot be used")


def ends_on_signals(task: asyncio.Task[None]) -> None:
    """An interrupt or a termination ends a task in order."""
    with suppress(NotImplementedError):  # on Windows an interrupt comes as an exception
        for number in (signal.SIGINT, signal.SIGTERM):
            asyncio.get_running_loop().add_signal_handler(number, task.cancel)
