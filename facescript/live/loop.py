"""A run, its clock and what it heeds to frames at absolute deadlines, for sinks; late ones are dropped and counted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from math import inf
from typing import Protocol

from facescript.live.clock import Clock
from facescript.live.model import Frame, Happening, Layout, Mark, Sighting, Sink, Told, Utterance

EARLY = 1e-6
"""Seconds before its deadline at which a frame's time has come."""

FINEST, COARSEST = 1e-4, 1.0
"""Seconds in which lateness is counted: its step, and what all above is counted as."""


class Performer(Protocol):
    """What is performed: a run, or what a test puts in its place."""

    layout: Layout

    def hear(self, happening: Happening) -> None: ...

    def see(self, sighting: Sighting) -> None: ...

    def frame(self, number: int) -> Frame: ...

    def marks(self, time: float) -> list[Mark]: ...

    def utterances(self, time: float) -> list[Utterance]: ...


class Feed(Protocol):
    """Where what is heeded comes from: the gate, or a log."""

    def following(self, number: int) -> int | None:
        """The number of the next frame from `number` on that is to be given; None at the end."""
        ...

    def due(self, number: int, after: float, upto: float) -> list[Told]:
        """What is heeded at a frame at `upto`, the frame before being at `after`, in order."""
        ...


class Keeper(Protocol):
    """Who keeps what happens: the log, the list of onsets."""

    def heeded(self, number: int, item: Told) -> None: ...

    def dropped(self, first: int, end: int) -> None:
        """Frames `first` to before `end` were not given."""
        ...

    def given(self, frame: Frame, marks: Sequence[Mark], now: float) -> None:
        """A frame and what began were given to all sinks at `now`."""
        ...

    def ended(self, number: int) -> None:
        """No frame from `number` on was given."""
        ...


@dataclass(slots=True)
class Tally:
    """How a run went: `late` frames were given more than half a frame after their deadline."""

    frames: int = 0
    late: int = 0
    dropped: int = 0
    _lateness: Counter[int] = field(default_factory=Counter)

    def count(self, lateness: float, frame: float) -> None:
        self.frames += 1
        self.late += lateness > frame / 2
        self._lateness[int(min(lateness, COARSEST) / FINEST)] += 1

    def lateness(self, part: float) -> float:
        """Seconds by which all but a part of the frames were late at most: 0.01 for the 99th percentile."""
        left = part * self.frames
        for step in sorted(self._lateness, reverse=True):
            left -= self._lateness[step]
            if left < 0:
                return (step + 1) * FINEST
        return 0.0


class Loop:
    """Gives frames until the feed ends, or for `seconds`. It is ended by cancelling `play`: between two frames."""

    def __init__(
        self, performer: Performer, clock: Clock, feed: Feed, sinks: Iterable[Sink], keepers: Iterable[Keeper] = ()
    ) -> None:
        self._performer, self._clock, self._feed = performer, clock, feed
        self._sinks, self._keepers = tuple(sinks), tuple(keepers)
        self.layout = performer.layout
        self._fps = self.layout.fps
        self._after = -1.0 / self._fps
        self.next = 0
        self.tally = Tally()

    async def play(self, seconds: float = inf) -> None:
        """The clock begins when the first frame is made: what is made once is made by then."""
        end = seconds * self._fps - EARLY
        while (number := self._feed.following(self.next)) is not None and number < end:
            if self.next:
                await self._clock.until(number / self._fps)
                number = self._newest(number, end)
            self._dropped(number)
            made = self._make(number)
            if not self.next:
                self._clock.begin()
            self._give(*made)
            self.next = number + 1

    def close(self) -> None:
        """No frame is given any more."""
        for keeper in self._keepers:
            keeper.ended(self.next)

    def _newest(self, number: int, end: float) -> int:
        """The newest frame whose time has come."""
        newest = (self._clock.now() + EARLY) * self._fps
        return max(number, int(min(newest, end)))

    def _dropped(self, number: int) -> None:
        if number > self.next:
            self.tally.dropped += number - self.next
            for keeper in self._keepers:
                keeper.dropped(self.next, number)

    def _make(self, number: int) -> tuple[Frame, list[Mark], list[Utterance]]:
        """A frame and what begins, with all that is heeded by then."""
        time = number / self._fps
        for item in self._feed.due(number, self._after, time):
            self._heed(number, item)
        self._after = time
        return self._performer.frame(number), self._performer.marks(time), self._performer.utterances(time)

    def _give(self, frame: Frame, marks: list[Mark], utterances: list[Utterance]) -> None:
        """To all sinks; what begins before the frame in which it does."""
        for sink in self._sinks:
            for utterance in utterances:
                sink.utter(utterance)
            for mark in marks:
                sink.mark(mark)
            sink.frame(frame)
        now = self._clock.now()
        self.tally.count(max(0.0, now - frame.time), 1.0 / self._fps)
        for keeper in self._keepers:
            keeper.given(frame, marks, now)

    def _heed(self, number: int, item: Told) -> None:
        if isinstance(item, Happening):
            self._performer.hear(item)
        else:
            self._performer.see(item)
        for keeper in self._keepers:
            keeper.heeded(number, item)
