"""A microphone to what is heard in the room. One that is not there, or goes away, is tried again."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from typing import Any

import numpy as np

from facescript.live.address import AddressFault
from facescript.live.hearing.activity import RATE, Samples
from facescript.live.hearing.flow import Flow
from facescript.live.hearing.listening import Listening, open_listening
from facescript.live.model import Source, Teller
from facescript.live.sources.setting import Setting

AGAIN = 2.0
"""Seconds until a microphone is looked for again, and without sound after which it is thought to be gone."""

BLOCK = 0.032
"""Seconds of sound that come at once."""


def opened(address: str, setting: Setting) -> Source:
    """`microphone:NAME?options`; without a name, the one that the system takes. Raises `AddressFault`."""
    name, _, options = address.removeprefix("microphone:").partition("?")
    try:
        import sounddevice
    except OSError:
        reason = "the library PortAudio is not there; on Debian and Ubuntu: `sudo apt install libportaudio2`"
        raise AddressFault("FS971", address=address[:100], reason=reason) from None
    listening = open_listening(address, setting.play, options, setting.own.sounds, setting.tell)
    return Microphone(sounddevice, int(name) if name.isdigit() else name or None, listening, setting)


class Microphone:
    """Hands what a device takes up to an ear."""

    def __init__(self, library: Any, device: int | str | None, listening: Listening, setting: Setting) -> None:
        self._library, self._device, self._listening, self._setting = library, device, listening, setting
        self._last, self._told = 0.0, False
        self._counts = {"opened": 0, "overruns": 0}

    async def run(self, teller: Teller) -> None:
        listening = asyncio.create_task(self._listening.run(teller))
        try:
            while True:
                await self._taken_up()
                await asyncio.sleep(AGAIN)
                await asyncio.to_thread(self._look_again)
        finally:
            listening.cancel()
            await asyncio.gather(listening, return_exceptions=True)

    def _look_again(self) -> None:
        """The library knows the devices that were there when it began."""
        with suppress(self._library.PortAudioError):
            self._library._terminate()
            self._library._initialize()

    def counts(self) -> dict[str, int]:
        return {**self._counts, **self._listening.counts()}

    async def _taken_up(self) -> None:
        """One device, until it is gone."""
        try:
            stream = await asyncio.to_thread(self._open, asyncio.get_running_loop())
        except (self._library.PortAudioError, ValueError) as fault:
            if not self._told:
                self._setting.tell(f"There is no microphone that can be used ({fault}); it is looked for again.")
            self._told = True
            return
        self._told = False
        self._counts["opened"] += 1
        self._last = self._setting.clock.now()
        try:
            while stream.active and self._setting.clock.now() - self._last < AGAIN:
                await asyncio.sleep(AGAIN / 4)
            self._setting.tell("The microphone is gone; it is looked for again.")
            self._told = True
        finally:
            with suppress(self._library.PortAudioError):
                await asyncio.to_thread(stream.close)

    def _open(self, loop: asyncio.AbstractEventLoop) -> Any:
        """A device that takes up sound, at the ear's rate where it can, else at its own. Raises `PortAudioError`, and
        `ValueError` for a name that no device has."""
        for rate in (RATE, round(self._library.query_devices(self._device, "input")["default_samplerate"])):
            with suppress(self._library.PortAudioError):
                return self._started(rate, loop)
        raise self._library.PortAudioError("it does not begin")

    def _started(self, rate: int, loop: asyncio.AbstractEventLoop) -> Any:
        flow = Flow(rate)

        def soon(block: Any, count: int, time: object, status: Any) -> None:
            with suppress(RuntimeError):  # the run has ended
                samples = np.frombuffer(bytes(block), np.int16)
                loop.call_soon_threadsafe(self._take, flow, samples, bool(status.input_overflow))

        stream = self._library.RawInputStream(
            samplerate=rate,
            blocksize=round(BLOCK * rate),
            device=self._device,
            channels=1,
            dtype="int16",
            callback=soon,
        )
        stream.start()
        return stream

    def _take(self, flow: Flow, samples: Samples, overrun: bool) -> None:
        self._last = self._setting.clock.now()
        self._counts["overruns"] += overrun
        self._listening.take(flow.take(samples), self._last)
