"""Requests to answers by a worker: a program of its own, started once, spoken to by pipe, with bounds on its time."""

from __future__ import annotations

import atexit
import json
import math
import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from facescript.speech.model import VoiceFailure
from facescript.speech.voices.frames import framed, read_part

Answer = tuple[dict[str, Any], bytes]
"""A part of an answer."""


class Broken(Exception):
    """The worker ended, or said what is no answer; `late` where it was ended for being slow."""

    def __init__(self, late: bool) -> None:
        super().__init__()
        self.late = late


class Worker:
    """A program in Python, started when first asked, and again where it has ended. Threads may share it."""

    def __init__(self, program: Path, seconds: float) -> None:
        self._program, self._seconds = program, seconds
        self._process: subprocess.Popen[bytes] | None = None
        self._owner = 0
        self._locks: dict[int, threading.Lock] = {}

    def ask(self, request: dict[str, Any], take: Callable[[Answer], None]) -> None:
        """Hand on the parts of the answer as they come. Raises `VoiceFailure` where there is none.

        A worker that breaks off is started again, once, and asked again: it says the same, so that what was handed
        on before is passed over.
        """
        with self._lock():
            last = self._last(request, take)
        if "failure" in last:
            raise VoiceFailure(last["failure"], last.get("code", "FS501"))

    def _last(self, request: dict[str, Any], take: Callable[[Answer], None]) -> dict[str, Any]:
        """The head of the last part, when all have been handed on; it may be a failure."""
        given = 0
        again = True
        while True:
            try:
                for number, part in enumerate(self._parts(request)):
                    if number >= given and "failure" not in part[0]:
                        given += 1
                        take(part)
                return part[0]
            except Broken as fault:
                self.close()
                if fault.late:
                    raise VoiceFailure(f"it did not answer within {self._seconds:g} s") from None
                if not again:
                    raise VoiceFailure("it broke off") from None
                again = False
            except BaseException:  # part of the answer is still in the pipe
                self.close()
                raise

    def close(self) -> None:
        """End the worker; the next question starts another."""
        process, self._process = self._process, None
        if process is None or self._owner != os.getpid():
            return
        process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                with suppress(OSError):  # what a dead worker has not read cannot be written any more
                    pipe.close()

    def _lock(self) -> threading.Lock:
        """This process's lock: of one that a fork has copied, the holder may not be there."""
        return self._locks.setdefault(os.getpid(), threading.Lock())

    def _parts(self, request: dict[str, Any]) -> Iterator[Answer]:
        """The parts of the answer, of which there is at least one. Raises `Broken`, `VoiceFailure`."""
        process = self._running()
        assert process.stdin is not None
        assert process.stdout is not None
        question = framed(json.dumps(request).encode())
        more = True
        with _Clock(process, self._seconds) as clock:
            while more:
                try:
                    with clock.running():
                        process.stdin.write(question)
                        process.stdin.flush()
                        question = b""
                        part = read_part(process.stdout)
                except (OSError, ValueError, EOFError):
                    raise Broken(clock.late) from None
                more = bool(part[0].get("more"))
                yield part

    def _running(self) -> subprocess.Popen[bytes]:
        """The worker of this process: a fork's child must not share its parent's pipe."""
        if self._process is not None and self._owner == os.getpid() and self._process.poll() is None:
            return self._process
        self.close()
        try:
            self._process = subprocess.Popen(
                [sys.executable, "-P", str(self._program)],
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


class _Clock:
    """Ends a process that takes too long at once; `late` tells of it. It stands still while nobody waits."""

    def __init__(self, process: subprocess.Popen[bytes], seconds: float) -> None:
        self.late = False
        self._process, self._seconds = process, seconds
        self._end = math.inf
        self._over = threading.Event()

    def __enter__(self) -> _Clock:
        # an interrupt before it is stopped must not keep the program waiting
        threading.Thread(target=self._watch, daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        self._over.set()

    @contextmanager
    def running(self) -> Iterator[None]:
        self._end = time.monotonic() + self._seconds
        yield
        self._end = math.inf

    def _watch(self) -> None:
        rest = self._seconds
        while not self._over.wait(min(rest, self._seconds)):
            rest = self._end - time.monotonic()
            if rest <= 0:
                self.late = True
                self._process.kill()
                return
