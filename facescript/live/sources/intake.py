"""Messages of a peer to what the gate is told, all counted, and to what the peer is told of those that are refused."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable

from facescript.live.gate import Bucket
from facescript.live.messages import Nonsense, read
from facescript.live.model import Happening, Teller, Told

PACE = 1000.0
"""Messages a second of a source that are read, and as many at once; all above are counted alone."""


class Intake:
    """Takes messages for a gate and counts them."""

    def __init__(self) -> None:
        self._counts: Counter[str] = Counter(messages=0, malformed=0)
        self._pace = Bucket(PACE)

    def take(self, teller: Teller, data: str | bytes) -> str | None:
        """A message in any form; why it is refused, where it is."""
        return self.told(teller, lambda: read(data))

    def told(self, teller: Teller, read: Callable[[], tuple[Told, ...]]) -> str | None:
        """What `read` finds in a message, or its `Nonsense`; why it is refused, where it is."""
        self._counts["messages"] += 1
        if not self._pace.takes(time.monotonic()):
            self._counts["passed over"] += 1
            return None
        try:
            items = read()
        except Nonsense as fault:
            self._counts["malformed"] += 1
            return str(fault.args[0])
        reasons = [teller.event(item) if isinstance(item, Happening) else teller.sighting(item) for item in items]
        return next((reason for reason in reasons if reason is not None), None)

    def count(self, what: str) -> None:
        self._counts[what] += 1

    def counts(self) -> dict[str, int]:
        return dict(self._counts)
