"""Frames of faces, picture by picture, to persons: who is whom, who has arrived, who has left.

A person is expected where she was going. Frames and persons are paired so that distance and difference in size cost
least together, so that one of several is followed through the others; who is hidden for a moment is waited for where
she should come out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from math import exp, hypot, log

from facescript.live.seeing.assignment import pairs
from facescript.live.seeing.geometry import Box

ARRIVES = 0.5
"""Somebody has arrived who was seen for so long, s."""

OFTEN = 0.5
"""... in at least so many of the pictures."""

LEAVES = 1.0
"""Somebody has left who was not seen for so long, s."""

STAYS = 10.0
"""... or for so long, where somebody still stands where she was: she has turned away, or looks down."""

DOUBTFUL = 0.25
"""One who has not arrived is forgotten after so long, s."""

MOST = 16
"""Persons at a time."""

REACH, SPREAD, FURTHEST, STANDING = 0.8, 4.0, 2.5, 1.2
"""A face may be so many face widths from where it is expected, and more for each second in which it was not seen, to a
limit: 4 a second are 60 cm/s. One who stands there unseen is found again as near as the last."""

GROWTH = 0.5
"""A face may be larger or smaller than it was by so much, as a logarithm: 1.65 times."""

PLACE, SPEED, SIZE = 0.7, 0.25, 0.3
"""What part of a surprise goes into place, speed and size (an alpha-beta filter)."""

COASTS = 0.6
"""One who is not seen goes on, and slows down in this time, s."""


def nobody(face: Box) -> bool:
    """Nobody stands where no face is seen."""
    return False


@dataclass(slots=True, eq=False)
class Track:
    """A face that is followed: the middle of its frame, its speed (pixels/s) and its size, as last seen."""

    x: float
    y: float
    width: float
    height: float
    born: float
    seen: float
    vx: float = 0.0
    vy: float = 0.0
    hits: int = 1
    looks: int = 1
    person: str | None = None

    def expected(self, time: float) -> Box:
        """The frame in which it should be."""
        on = COASTS * (1.0 - exp((self.seen - time) / COASTS))
        x, y = self.x + self.vx * on, self.y + self.vy * on
        return Box(x - self.width / 2, y - self.height / 2, self.width, self.height)

    def cost(self, box: Box, time: float) -> float:
        """How little a frame looks like it; 1 is too little."""
        (x, y), (ex, ey) = box.middle, self.expected(time).middle
        unseen = time - self.seen
        reach = min(REACH + SPREAD * unseen, FURTHEST) if unseen <= LEAVES else STANDING
        away = hypot(x - ex, y - ey) / ((box.width + self.width) / 2)
        return hypot(away / reach, log(box.width / self.width) / GROWTH)

    def take(self, box: Box, time: float) -> None:
        """It was seen in a frame."""
        (x, y), (ex, ey) = box.middle, self.expected(time).middle
        span = time - self.seen
        on = exp(-span / COASTS)
        self.vx, self.vy = self.vx * on + SPEED * (x - ex) / span, self.vy * on + SPEED * (y - ey) / span
        self.x, self.y = ex + PLACE * (x - ex), ey + PLACE * (y - ey)
        self.width += SIZE * (box.width - self.width)
        self.height += SIZE * (box.height - self.height)
        self.seen = time
        self.hits += 1

    def is_gone(self, time: float, stands: Callable[[Box], bool]) -> bool:
        unseen = time - self.seen
        if self.person is None:
            return unseen > DOUBTFUL
        return unseen > STAYS or (unseen > LEAVES and not stands(self.expected(time)))

    def settled(self, time: float) -> bool:
        return time - self.born >= ARRIVES and self.hits >= OFTEN * self.looks


@dataclass(frozen=True, slots=True)
class Seen:
    """What a picture told: the persons in it with their frames, as they are; who arrives with it, and who leaves."""

    faces: tuple[tuple[str, Box], ...] = ()
    arrived: tuple[str, ...] = ()
    left: tuple[str, ...] = ()


@dataclass(slots=True)
class Tracker:
    """Follows at most `MOST` faces. `refused` counts frames for which there was no room."""

    tracks: list[Track] = field(default_factory=list)
    persons: int = 0
    refused: int = 0
    _time: float = float("-inf")

    def expected(self, time: float) -> list[Box]:
        """Where those who are followed should be."""
        return [track.expected(time) for track in self.tracks]

    def step(self, boxes: Sequence[Box], time: float, stands: Callable[[Box], bool] = nobody) -> Seen:
        """The faces of the picture of a time (s, later than the one before: else it is passed over). `stands` says
        whether somebody is where a face was, though none is seen."""
        if time <= self._time:
            return Seen()
        self._time = time
        matched = pairs([[track.cost(box, time) for box in boxes] for track in self.tracks], 1.0)
        faces = []
        for number, column in matched:
            self.tracks[number].take(boxes[column], time)
            faces.append((self.tracks[number], boxes[column]))
        for track in self.tracks:
            track.looks += 1
        arrived = self._arrived([track for track, _ in faces], time)
        left = self._left(time, stands)
        self._begin([box for column, box in enumerate(boxes) if column not in {pair[1] for pair in matched}], time)
        told = tuple((track.person, box) for track, box in faces if track.person is not None)
        return Seen(told, arrived, left)

    def _arrived(self, tracks: list[Track], time: float) -> tuple[str, ...]:
        found = []
        for track in tracks:
            if track.person is None and track.settled(time):
                self.persons += 1
                track.person = f"person {self.persons}"
                found.append(track.person)
        return tuple(found)

    def _left(self, time: float, stands: Callable[[Box], bool]) -> tuple[str, ...]:
        gone = [track for track in self.tracks if track.is_gone(time, stands)]
        self.tracks = [track for track in self.tracks if track not in gone]
        return tuple(track.person for track in gone if track.person is not None)

    def _begin(self, boxes: list[Box], time: float) -> None:
        room = MOST - len(self.tracks)
        self.refused += max(0, len(boxes) - room)
        for box in boxes[: max(0, room)]:
            self.tracks.append(Track(*box.middle, box.width, box.height, time, time))
