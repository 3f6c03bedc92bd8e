"""Lines to a file, in a thread of its own: who writes them never waits for a disk or for who reads a pipe."""

from __future__ import annotations

import threading
from typing import IO

MOST = 8 << 20
"""Bytes that wait to be written, at most."""

PATIENCE = 2.0
"""Seconds that what is left gets at the end."""


class Writer:
    """Writes whole lines as soon as the file takes them. `patient`: a full queue is waited for; else its lines are
    refused. `failed` is what the file said when it took no more."""

    def __init__(self, file: IO[bytes], patient: bool) -> None:
        self._file, self._patient = file, patient
        self._lines: list[bytes] = []
        self._size, self._ended = 0, False
        self.failed: OSError | None = None
        self._change = threading.Condition()
        self._thread = threading.Thread(target=self._write, name="facescript-writer", daemon=True)
        self._thread.start()

    def put(self, line: str) -> bool:
        """Takes a line; whether it will be written."""
        data = line.encode() + b"\n"
        with self._change:
            if self._patient:
                self._change.wait_for(lambda: self._size + len(data) <= MOST or self.failed is not None)
            if self.failed is not None or self._size + len(data) > MOST:
                return False
            self._lines.append(data)
            self._size += len(data)
            self._change.notify_all()
        return True

    def close(self) -> int:
        """Writes what is left and closes the file; returns how many lines could not be written in time."""
        with self._change:
            self._ended = True
            self._change.notify_all()
        self._thread.join(None if self._patient else PATIENCE)
        if not self._thread.is_alive():
            self._file.close()
        with self._change:
            return len(self._lines)

    def _write(self) -> None:
        while True:
            with self._change:
                self._change.wait_for(lambda: self._lines or self._ended)
                lines = list(self._lines)
            if not lines:
                return
            if not self._wrote(b"".join(lines)):
                return
            with self._change:
                del self._lines[: len(lines)]
                self._size -= sum(map(len, lines))
                self._change.notify_all()

    def _wrote(self, data: bytes) -> bool:
        """Whether the file took all of it."""
        rest = memoryview(data)
        try:
            while rest:
                rest = rest[self._file.write(rest) or 0 :]
        except OSError as fault:
            with self._change:
                self.failed = fault
                self._change.notify_all()
            return False
        return True
