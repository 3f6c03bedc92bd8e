"""Frames done to a bar on the terminal; nothing where standard error is not one."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager

WIDTH = 30
EVERY = 0.1
"""Seconds between two drawings of the bar."""


class Progress:
    """A bar for one output after another; `step` is called with (done, total)."""

    def __init__(self, silent: bool) -> None:
        self.name = ""
        self.shown = not silent and sys.stderr.isatty()
        self.last = 0.0

    @contextmanager
    def of(self, name: str) -> Iterator[None]:
        """While this output is made the bar bears its name."""
        self.name, self.last = name, 0.0
        try:
            yield
        finally:
            if self.shown and self.last:
                sys.stderr.write("\n")

    def step(self, done: int, total: int) -> None:
        """Draw the bar anew, not too often."""
        now = time.monotonic()
        if not self.shown or (done < total and now - self.last < EVERY):
            return
        self.last = now
        filled = WIDTH * done // max(total, 1)
        bar = "#" * filled + "." * (WIDTH - filled)
        sys.stderr.write(f"\r{self.name} [{bar}] {done}/{total}")
        sys.stderr.flush()
