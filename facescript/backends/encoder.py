"""Frames to a file: one ffmpeg process, fed through a pipe by a thread of its own, ended whatever happens."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from queue import SimpleQueue
from types import TracebackType
from typing import IO

import imageio_ffmpeg
import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import JobFailure

if sys.platform == "linux":
    from fcntl import F_SETPIPE_SZ, fcntl

Bytes = NDArray[np.uint8]

AHEAD = 8
"""Frames that may wait for the encoder."""

PIPE_BYTES = 1 << 20
"""What Linux lets anyone's pipe hold."""

LAST_WORDS = 2000
"""Bytes kept of what ffmpeg says; it says nothing but faults."""


class Encoder:
    """A running ffmpeg that takes frames. Leaving its `with` block waits for the file, or ends ffmpeg on a fault."""

    def __init__(self, options: Sequence[str], path: Path) -> None:
        """`options` are all of ffmpeg's but the output; frames come on its standard input. Raises `JobFailure`."""
        command = [program(), "-hide_banner", "-loglevel", "error", "-y", *options, f"file:{path}"]
        pipe, quiet = subprocess.PIPE, subprocess.DEVNULL
        try:
            # A session of its own: an interrupt from the terminal reaches us, and we end it in order.
            self._process = subprocess.Popen(command, stdin=pipe, stdout=quiet, stderr=pipe, start_new_session=True)
        except OSError as fault:
            raise JobFailure(f"ffmpeg cannot be run ({fault.strerror})") from None
        # Simple queues, because they alone stay whole when an interrupt comes while one is being used.
        self._waiting: SimpleQueue[Bytes | None] = SimpleQueue()
        self._free: SimpleQueue[Bytes | None] = SimpleQueue()
        for _ in range(AHEAD):
            self._free.put(None)
        _widen(self._process.stdin)
        self._words = b""
        self._broken = False
        self._threads = [threading.Thread(target=work, daemon=True) for work in (self._feed, self._listen)]
        for thread in self._threads:
            thread.start()

    def __enter__(self) -> Encoder:
        return self

    def write(self, frame: Bytes) -> None:
        """Hand over one frame; it is copied. Raises `JobFailure` once ffmpeg has stopped."""
        if self._broken:
            self._fail()
        slot = self._free.get()
        if slot is None:
            slot = np.empty_like(frame)
        slot[...] = frame
        self._waiting.put(slot)

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None, at: TracebackType | None) -> None:
        try:
            if kind is None:
                self._waiting.put(None)
                self._threads[0].join()
                if self._process.wait() or self._broken:
                    self._fail()
        finally:
            self._end()

    def _feed(self) -> None:
        """The feeding thread: frames to ffmpeg until there are no more; once it has stopped they are thrown away."""
        assert self._process.stdin is not None
        while (frame := self._waiting.get()) is not None:
            if not self._broken:
                try:
                    self._process.stdin.write(frame.data)
                except (OSError, ValueError):
                    self._broken = True
            self._free.put(frame)
        with suppress(OSError):
            self._process.stdin.close()

    def _listen(self) -> None:
        """The listening thread: keeps ffmpeg's last words."""
        assert self._process.stderr is not None
        while words := os.read(self._process.stderr.fileno(), LAST_WORDS):
            self._words = (self._words + words)[-LAST_WORDS:]

    def _fail(self) -> None:
        self._process.kill()
        self._threads[1].join()
        lines = self._words.decode(errors="replace").strip().splitlines()
        raise JobFailure(f"ffmpeg stopped: {lines[-1].strip()}" if lines else "ffmpeg stopped")

    def _end(self) -> None:
        """End ffmpeg and the threads, if they still run."""
        self._process.kill()
        self._waiting.put(None)
        self._process.wait()
        for thread in self._threads:
            thread.join()
        for stream in (self._process.stdin, self._process.stderr):
            if stream is not None:
                with suppress(OSError):
                    stream.close()


def _widen(pipe: IO[bytes] | None) -> None:
    """Let a pipe hold more than its usual 64 KiB where the system can: fewer changes of process a frame."""
    if pipe is not None and sys.platform == "linux":
        with suppress(OSError):
            fcntl(pipe.fileno(), F_SETPIPE_SZ, PIPE_BYTES)


def program() -> str:
    """The path of ffmpeg. Raises `JobFailure` where there is none."""
    try:
        return str(imageio_ffmpeg.get_ffmpeg_exe())
    except RuntimeError:
        raise JobFailure("ffmpeg is not installed") from None
