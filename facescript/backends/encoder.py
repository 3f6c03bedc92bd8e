"""Frames or sound to a file: one ffmpeg process, fed through a pipe, ended whatever happens."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import IO

import imageio_ffmpeg
import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import JobFailure

if sys.platform == "linux":
    from fcntl import F_SETPIPE_SZ, fcntl

Bytes = NDArray[np.uint8]
Samples = NDArray[np.int16]

PIPE_BYTES = 1 << 20
"""What Linux lets anyone's pipe hold."""

LAST_WORDS = 2000
"""Bytes kept of what ffmpeg says; it says nothing but faults."""


class Encoder:
    """A running ffmpeg that takes frames, or sound a block at a time. Leaving its `with` block waits for the file, or
    ends ffmpeg on a fault."""

    def __init__(self, options: Sequence[str], path: Path) -> None:
        """`options` are all of ffmpeg's but the output; frames come on its standard input. Raises `JobFailure`."""
        command = [program(), "-hide_banner", "-loglevel", "error", "-y", *options, f"file:{path}"]
        pipe, quiet = subprocess.PIPE, subprocess.DEVNULL
        try:
            # A session of its own: an interrupt from the terminal reaches us, and we end it in order.
            self._process = subprocess.Popen(command, stdin=pipe, stdout=quiet, stderr=pipe, start_new_session=True)
        except OSError as fault:
            raise JobFailure(f"ffmpeg cannot be run ({fault.strerror})") from None
        _widen(self._process.stdin)
        self._words = b""
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()

    def __enter__(self) -> Encoder:
        return self

    def write(self, frame: Bytes | Samples) -> None:
        """Hand over one frame or block, which ffmpeg has when this returns; it keeps a few that wait for its encoder.
        Raises `JobFailure` once ffmpeg has stopped."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(frame.data)
        except OSError:
            self._fail()

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None, at: TracebackType | None) -> None:
        try:
            if kind is None:
                _close(self._process.stdin)
                if self._process.wait():
                    self._fail()
        finally:
            self._end()

    def _listen(self) -> None:
        """The listening thread: keeps ffmpeg's last words."""
        assert self._process.stderr is not None
        while words := os.read(self._process.stderr.fileno(), LAST_WORDS):
            self._words = (self._words + words)[-LAST_WORDS:]

    def _fail(self) -> None:
        self._process.kill()
        self._listener.join()
        lines = self._words.decode(errors="replace").strip().splitlines()
        raise JobFailure(f"ffmpeg stopped: {lines[-1].strip()}" if lines else "ffmpeg stopped")

    def _end(self) -> None:
        """End ffmpeg and the thread, if they still run."""
        self._process.kill()
        self._process.wait()
        self._listener.join()
        for stream in (self._process.stdin, self._process.stderr):
            _close(stream)


def _close(stream: IO[bytes] | None) -> None:
    """Close a pipe, whether or not what is at its other end still lives."""
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
