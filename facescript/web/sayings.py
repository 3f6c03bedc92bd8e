"""What a page says to messages that are taken: no more of them than it has cause for, and none but those it may say."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping

from facescript.web.messages import Message

LARGEST = 1e9
"""No number of a page is as large: seconds of a film, places in a text."""

Taken = Mapping[str, Mapping[str, tuple[type, ...]]]
"""What a page may say: the kinds, and the types of what belongs to each."""


class Pace:
    """How often a page speaks: `quickest` messages a second, over a few seconds."""

    def __init__(self, quickest: int) -> None:
        self._quickest = quickest
        self._left, self._since = float(quickest), time.monotonic()

    def floods(self) -> bool:
        """Whether a page has said more than it has cause to; counts what it says now."""
        now = time.monotonic()
        self._left = min(self._left + (now - self._since) * self._quickest, 4.0 * self._quickest) - 1
        self._since = now
        return self._left < 0


def understood(said: str | bytes, taken: Taken) -> Message | None:
    """A message of a page, if it is one."""
    try:
        message = json.loads(said) if isinstance(said, str) else None
    except (ValueError, RecursionError):
        return None
    if not isinstance(message, dict):
        return None
    wanted = taken.get(str(message.get("kind")))
    if wanted is None or not all(_fits(message.get(name), types) for name, types in wanted.items()):
        return None
    return {name: message[name] for name in ("kind", *wanted)}


def _fits(value: object, types: tuple[type, ...]) -> bool:
    """Whether a value is of one of the types; a number, one that can be counted with."""
    return type(value) in types and (not isinstance(value, int | float) or abs(value) < LARGEST)
