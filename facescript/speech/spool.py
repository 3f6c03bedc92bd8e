"""Sound to a file of this process and back, so that hours of it need not lie in memory."""

from __future__ import annotations

import os
import tempfile
from dataclasses import dataclass
from threading import Lock
from typing import IO

HELD = 24 * 1024 * 1024
"""Bytes of sound that stay in memory: nine minutes of the default voice never touch the disk."""

LOCK = Lock()
"""Where a file has one place of its own, one reads at a time."""


@dataclass(frozen=True, slots=True, eq=False)
class Kept:
    """Sound in a spool's file: `length` bytes from `first` on. The file goes when nothing is kept in it any more."""

    file: IO[bytes]
    first: int
    length: int

    def __len__(self) -> int:
        return self.length

    def read(self) -> bytes:
        """The bytes, from any thread and from a process that was forked since."""
        if hasattr(os, "pread"):
            return os.pread(self.file.fileno(), self.length, self.first)
        with LOCK:
            self.file.seek(self.first)
            return self.file.read(self.length)


class Spool:
    """Takes sound: the first of it stays in memory, what comes later goes into a file without a name."""

    def __init__(self, held: int = HELD) -> None:
        self._room = held
        self._file: IO[bytes] | None = None
        self._size = 0

    def keep(self, sound: bytes) -> bytes | Kept:
        """The sound as it is kept; in memory too where the disk takes no more."""
        if len(sound) <= self._room:
            self._room -= len(sound)
            return sound
        try:
            return self._put(sound)
        except OSError:
            return sound

    def _put(self, sound: bytes) -> Kept:
        if self._file is None:
            self._file = tempfile.TemporaryFile(prefix="facescript-")  # noqa: SIM115 (open while sound is kept)
        with LOCK:
            self._file.seek(self._size)
            self._file.write(sound)
            self._file.flush()
            kept = Kept(self._file, self._size, len(sound))
            self._size += len(sound)
        return kept
