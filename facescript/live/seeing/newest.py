"""What comes faster than it is used to the newest of it: a place for one thing between two threads."""

from __future__ import annotations

from threading import Condition
from typing import Generic, TypeVar

T = TypeVar("T")


class Newest(Generic[T]):
    """Holds the newest thing. `passed` counts those that nobody took."""

    def __init__(self) -> None:
        self.passed = 0
        self._held: list[T] = []
        self._changed = Condition()

    def put(self, thing: T) -> None:
        with self._changed:
            self.passed += len(self._held)
            self._held = [thing]
            self._changed.notify()

    def take(self, patience: float) -> T | None:
        """The newest thing, once; None where none came within `patience` seconds."""
        with self._changed:
            self._changed.wait_for(lambda: bool(self._held), patience)
            return self._held.pop() if self._held else None
