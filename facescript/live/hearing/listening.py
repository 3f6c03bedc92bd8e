"""Sound, as it comes, to events: handed to the ear in its own process, which is begun again where it breaks off."""

from __future__ import annotations

import asyncio
import json
import sys
from asyncio.subprocess import DEVNULL, PIPE, Process
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from importlib.util import find_spec

from facescript.ir.play import Play
from facescript.live.address import AddressFault
from facescript.live.hearing.activity import RATE, Samples
from facescript.live.hearing.ear import DEAF
from facescript.live.hearing.phrases import awaited, is_english, phrases
from facescript.live.model import Happening, Teller

LEAST = 0.7
"""The confidence at which a phrase is told, where nothing is said."""

BEHIND = 4 * RATE
"""Bytes of sound (two seconds) that wait for the ear, at most: where it is slower, some are passed over."""

AGAIN = 2.0
"""Seconds until an ear that broke off is begun again."""


@dataclass(frozen=True, slots=True)
class Manner:
    """How is listened: the `least` confidence that is told, and whether also while the face speaks itself (`full`)."""

    least: float = LEAST
    full: bool = False


class Listening:
    """Listens for the phrases of a play; `own` says when its faces are heard themselves."""

    def __init__(self, play: Play, manner: Manner, own: Callable[[float], bool], tell: Callable[[str], None]) -> None:
        self._texts = [one.text for one in phrases(awaited(play))]
        self._manner, self._own, self._tell = manner, own, tell
        self._process: Process | None = None
        self._ready, self._ended = False, False
        self._counts = dict.fromkeys(("heard", "passed over", "begun again"), 0)
        self._within: dict[str, int] = {}

    async def run(self, teller: Teller) -> None:
        """Tells what is heard, until `end`."""
        while not self._ended:
            await self._listen(teller)
            if not self._ended:
                self._counts["begun again"] += 1
                await asyncio.sleep(AGAIN)

    def take(self, sound: Samples, time: float) -> None:
        """Sound of 16,000 samples a second that was taken up by a `time` of the run, s."""
        if self._process is None or self._process.stdin is None or not self._ready:
            self._counts["passed over"] += len(sound)
            return
        late = self._process.stdin.transport.get_write_buffer_size() > BEHIND
        if late or (not self._manner.full and self._own(time)):
            self._counts["passed over"] += len(sound)
            self._process.stdin.write((DEAF | len(sound)).to_bytes(4, "big"))
            return
        data = sound.astype("<i2").tobytes()
        self._process.stdin.write(len(data).to_bytes(4, "big") + data)

    async def ready(self) -> None:
        """Waits until it can listen."""
        while not self._ready:
            await asyncio.sleep(0.02)

    def end(self) -> None:
        """No more sound will come; `run` ends when all is heard."""
        self._ended = True
        if self._process is not None and self._process.stdin is not None:
            self._process.stdin.close()

    def counts(self) -> dict[str, int]:
        """Phrases that were heard, samples that were passed over, and what became of utterances."""
        return {**self._counts, **{f"utterances {name}": count for name, count in self._within.items()}}

    async def _listen(self, teller: Teller) -> None:
        """One process, from its beginning to its end."""
        words = [sys.executable, "-P", "-m", "facescript.live.hearing.program"]
        head = json.dumps({"phrases": self._texts, "least": self._manner.least}).encode()
        process = await asyncio.create_subprocess_exec(*words, stdin=PIPE, stdout=PIPE, stderr=DEVNULL)
        try:
            assert process.stdin is not None and process.stdout is not None
            process.stdin.write(len(head).to_bytes(4, "big") + head)
            self._process = process
            async for line in process.stdout:
                self._heard(json.loads(line), teller)
        finally:
            self._process, self._ready = None, False
            with suppress(ProcessLookupError):
                process.kill()
            await process.communicate()  # its pipes are closed with it

    def _heard(self, message: dict[str, dict[str, object]], teller: Teller) -> None:
        if "ready" in message:
            self._ready = True
        elif "counts" in message:
            self._within = {name: int(str(count)) for name, count in message["counts"].items()}
        else:
            self._counts["heard"] += 1
            teller.event(Happening("heard", 0.0, str(message["heard"]["text"])))


def open_listening(
    address: str, play: Play, options: str, own: Callable[[float], bool], tell: Callable[[str], None]
) -> Listening:
    """What listens for an address whose `options` stand behind a question mark. Raises `AddressFault`."""
    manner = _manner(address, options)
    if find_spec("pocketsphinx") is None:
        raise AddressFault("FS960", command=f"live --from {address.partition(':')[0]}:", extra="english")
    if not is_english(play):
        raise AddressFault("FS994", reason="no face of this script has an English voice")
    if not phrases(awaited(play)):
        raise AddressFault("FS994", reason='no `when heard "..."` of this script has words that could be heard')
    return Listening(play, manner, own, tell)


def _manner(address: str, options: str) -> Manner:
    found = dict(part.partition("=")[::2] for part in options.split("&") if part)
    example = f"{address.partition(':')[0]}:?least=0.8&duplex=full"
    with suppress(ValueError):
        least = float(found.pop("least", LEAST))
        duplex = found.pop("duplex", "half")
        if not found and 0.0 <= least <= 1.0 and duplex in ("half", "full"):
            return Manner(least, duplex == "full")
    reason = "behind the question mark stands `least`, a number from 0 to 1, and `duplex`, `half` or `full`"
    raise AddressFault("FS981", address=address[:100], reason=reason, example=example)
