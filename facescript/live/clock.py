"""Time to the moments of a run: this machine's clock, or one that goes as fast as its frames are made."""

from __future__ import annotations

import asyncio
import time
from typing import Protocol


class Clock(Protocol):
    """Seconds of a run; 0 until it begins. They never go back."""

    def begin(self) -> None:
        """The run begins now."""
        ...

    def now(self) -> float:
        """May be asked by any thread."""
        ...

    async def until(self, moment: float) -> None:
        """Waits until then, where that is not past; lets others have their turn in any case."""
        ...


class WallClock:
    """The seconds since the beginning. Each wait is for a moment since then, so that no error of one adds to the
    next."""

    def __init__(self) -> None:
        self._began: float | None = None

    def begin(self) -> None:
        self._began = time.perf_counter()

    def now(self) -> float:
        return 0.0 if self._began is None else time.perf_counter() - self._began

    async def until(self, moment: float) -> None:
        await asyncio.sleep(max(0.0, moment - self.now()))


class SimulatedClock:
    """A clock on which it is whatever moment was waited for: a run takes only the time that its frames need."""

    def __init__(self) -> None:
        self._now = 0.0

    def begin(self) -> None:
        pass

    def now(self) -> float:
        return self._now

    async def until(self, moment: float) -> None:
        self._now = max(self._now, moment)
        await asyncio.sleep(0)
