"""Texts to sound and events by the espeak-ng worker: starts the program once, speaks to it by pipe, bounds its time."""

from __future__ import annotations

import atexit
import json
import os
import struct
import subprocess
import sys
import threading
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import IO, Any

from facescript.speech.model import VoiceFailure

WORKER = Path(__file__).with_name("worker.py")
SECONDS = 40.0
"""A request that takes longer ends the worker; the worker's own watchdog is shorter."""

LONGEST_ANSWER = 1 << 28
"""Bytes of one frame: 100 minutes of sound."""

LONGEST_TEXT = 200_000
"""Characters of one utterance, tags included."""


@dataclass(frozen=True, slots=True)
class Utterance:
    """What the worker speaks at once: `rate` in words a minute (80..450), `pitch` and `range` 0..100 (50: as usual).

    `ssml` texts carry tags, `phonemes` texts carry `[[...]]` in the voice's own phoneme names.
    """

    text: str
    voice: str
    rate: int = 175
    pitch: int = 50
    ssml: bool = False
    phonemes: bool = False
    range: int = 50


@dataclass(frozen=True, slots=True)
class Heard:
    """A word or phone begins: `sample` of the sound, `place` in the text (characters, from 0), `symbol` IPA or ""."""

    kind: str
    sample: int
    place: int
    symbol: str


@dataclass(frozen=True, slots=True)
class Sound:
    """An utterance as sound: 16-bit little-endian mono, and what begins where."""

    pcm: bytes
    rate: int
    events: tuple[Heard, ...]


class Espeak:
    """The worker, started when first asked. Every method raises `VoiceFailure` where it cannot answer."""

    def __init__(self, worker: Path = WORKER, seconds: float = SECONDS) -> None:
        self._worker, self._seconds = worker, seconds
        self._process: subprocess.Popen[bytes] | None = None
        self._owner = 0
        self._lock = threading.Lock()

    def speak(self, utterance: Utterance) -> Sound:
        """The sound of a text, the same bytes every time."""
        if len(utterance.text) > LONGEST_TEXT:
            raise VoiceFailure(f"it takes at most {LONGEST_TEXT} characters at a time")
        head, pcm = self._ask({"do": "speak", **asdict(utterance)})
        return Sound(pcm, int(head["rate"]), tuple(Heard(*event) for event in head["events"]))

    def voices(self) -> dict[str, Any]:
        """`voices` (name, identifier, languages with priority) and `variants` (name, identifier, gender)."""
        return self._ask({"do": "voices"})[0]

    def close(self) -> None:
        """End the worker; the next question starts another."""
        process, self._process = self._process, None
        if process is None or self._owner != os.getpid():
            return
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                with suppress(OSError):  # what a dead worker has not read cannot be written any more
                    pipe.close()
        try:
            process.wait(timeout=2)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def _ask(self, request: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        with self._lock:
            process = self._running()
            late = threading.Event()
            clock = threading.Timer(self._seconds, _end, (process, late))
            clock.daemon = True  # an interrupt before it is cancelled must not keep the program waiting
            clock.start()
            try:
                head, pcm = _exchange(process, request)
            except (OSError, ValueError, EOFError):
                self.close()
                raise VoiceFailure(_broken(late.is_set(), self._seconds)) from None
            finally:
                clock.cancel()
        if "failure" in head:
            raise VoiceFailure(head["failure"])
        return head, pcm

    def _running(self) -> subprocess.Popen[bytes]:
        """The worker of this process: a fork's child must not share its parent's pipe."""
        if self._process is not None and self._owner == os.getpid() and self._process.poll() is None:
            return self._process
        self.close()
        try:
            self._process = subprocess.Popen(
                [sys.executable, "-P", str(self._worker)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
            )
        except OSError as fault:
            raise VoiceFailure(f"it cannot be started: {fault.strerror}") from None
        self._owner = os.getpid()
        atexit.unregister(self.close)
        atexit.register(self.close)
        return self._process


def _end(process: subprocess.Popen[bytes], late: threading.Event) -> None:
    late.set()
    process.kill()


def _exchange(process: subprocess.Popen[bytes], request: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
    assert process.stdin is not None
    assert process.stdout is not None
    body = json.dumps(request).encode()
    process.stdin.write(struct.pack(">I", len(body)) + body)
    process.stdin.flush()
    return json.loads(_frame(process.stdout)), _frame(process.stdout)


def _frame(stream: IO[bytes]) -> bytes:
    size = struct.unpack(">I", _exactly(stream, 4))[0]
    if size > LONGEST_ANSWER:
        raise ValueError("a frame too long")
    return _exactly(stream, size)


def _exactly(stream: IO[bytes], size: int) -> bytes:
    data = stream.read(size)
    if len(data) < size:
        raise EOFError
    return data


def _broken(late: bool, seconds: float) -> str:
    if late:
        return f"it did not answer within {seconds:g} s"
    return "it broke off"
