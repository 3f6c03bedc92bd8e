"""Pictures with their times to what a run is told: sightings, who arrives and leaves, whether anybody is there.

The same pictures and times give the same.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field

from facescript.live.model import Happening, Sighting
from facescript.live.seeing.background import SHARE, Background
from facescript.live.seeing.faces import Finder, Picture
from facescript.live.seeing.geometry import Camera
from facescript.live.seeing.presence import Presence
from facescript.live.seeing.tracker import Seen, Tracker

WHOLE = 3
"""Every so manyth picture is searched as a whole; in the others, faces only where they are expected."""


@dataclass(slots=True)
class Watcher:
    """Watches through a camera. `signals` are those of presence for which the script waits."""

    camera: Camera
    finder: Finder
    signals: frozenset[str] = frozenset()
    counts: Counter[str] = field(default_factory=Counter)
    tracker: Tracker = field(default_factory=Tracker)
    _background: Background = field(default_factory=Background)
    _presence: Presence = field(default_factory=Presence)

    def look(self, picture: Picture, time: float) -> Iterator[Sighting | Happening]:
        """What a picture of a time (s, later than the one before) tells. Who arrives was seen first."""
        near = None if self.counts["pictures"] % WHOLE == 0 else self.tracker.expected(time)
        self.counts["pictures"] += 1
        boxes = self.finder.faces(picture, near)
        self.counts["faces"] += len(boxes)
        strange = self._background.differs(picture, time)
        seen = self.tracker.step(boxes, time, self._background.stands)
        height, width = picture.shape[:2]
        for person, box in seen.faces:
            yield Sighting(person, time, self.camera.locate(box, width, height, self.finder.width))
        yield from self._comings(seen, time)
        yield from self._signal(bool(seen.faces) or strange > SHARE, time)

    def blind(self, time: float) -> Iterator[Happening]:
        """What it tells that there is no picture at a time: who was there is let go after a while."""
        yield from self._comings(self.tracker.step((), time), time)
        yield from self._signal(False, time)

    def _comings(self, seen: Seen, time: float) -> Iterator[Happening]:
        self.counts["arrived"] += len(seen.arrived)
        self.counts["refused"] = self.tracker.refused
        yield from (Happening("arrives", time, person=person) for person in seen.arrived)
        yield from (Happening("leaves", time, person=person) for person in seen.left)

    def _signal(self, somebody: bool, time: float) -> Iterator[Happening]:
        signal = self._presence.step(somebody, time)
        if signal in self.signals:
            yield Happening("signal", time, signal)
