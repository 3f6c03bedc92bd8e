"""A recording of the project to what is heard in it, in its own time, as a microphone would take it up."""

from __future__ import annotations

import asyncio

import numpy as np

from facescript.live.address import AddressFault
from facescript.live.hearing.activity import RATE
from facescript.live.hearing.flow import Flow
from facescript.live.hearing.listening import Listening, open_listening
from facescript.live.model import Source, Teller
from facescript.live.sources.setting import Setting
from facescript.speech.model import VoiceFailure
from facescript.speech.sound.recording import Recording, read_recording
from facescript.world import WorldFailure

BLOCK = 0.032
"""Seconds of sound that come at once."""

QUIET = np.zeros(RATE, np.int16)
"""What stands behind it, so that its last word is over."""


def opened(address: str, setting: Setting) -> Source:
    """`wav:FILE?options`. Raises `AddressFault`."""
    name, _, options = address.removeprefix("wav:").partition("?")
    try:
        recording = read_recording(setting.world.path(name))
    except (WorldFailure, VoiceFailure) as fault:
        raise AddressFault("FS971", address=address[:100], reason=str(fault.args[0])) from None
    listening = open_listening(address, setting.play, options, setting.own.sounds, setting.tell)
    return Played(recording, listening, setting)


class Played:
    """Plays a recording to an ear, from when that is ready."""

    def __init__(self, recording: Recording, listening: Listening, setting: Setting) -> None:
        self._recording, self._listening, self._setting = recording, listening, setting

    async def run(self, teller: Teller) -> None:
        listening = asyncio.create_task(self._listening.run(teller))
        try:
            await self._listening.ready()
            await self._play()
            self._listening.end()
            await listening
        finally:
            listening.cancel()
            await asyncio.gather(listening, return_exceptions=True)
        await asyncio.Event().wait()

    def counts(self) -> dict[str, int]:
        return self._listening.counts()

    async def _play(self) -> None:
        clock, recording = self._setting.clock, self._recording
        flow, size = Flow(recording.rate), round(BLOCK * recording.rate)
        began = clock.now()
        for first in range(0, len(recording.samples), size):
            block = recording.samples[first : first + size]
            due = began + (first + len(block)) / recording.rate
            await asyncio.sleep(max(0.0, due - clock.now()))
            self._listening.take(flow.take(block), due)
        self._listening.take(QUIET, clock.now())
