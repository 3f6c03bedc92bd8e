"""`track:visit.csv`: a file of tracks to who is there, where, who comes and goes, in its own time."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from heapq import merge
from itertools import accumulate

from facescript.diagnostics.model import Diagnostics
from facescript.live.address import LONGEST, AddressFault
from facescript.live.clock import Clock
from facescript.live.model import Happening, Sighting, Source, Teller
from facescript.live.seeing.tracker import LEAVES, MOST
from facescript.live.sources.setting import Setting
from facescript.resolve.names import Names
from facescript.resolve.project import Project, Refused
from facescript.resolve.tracks import Track, tracks
from facescript.space.path import Path
from facescript.syntax.tree import String
from facescript.text import Source as Text
from facescript.text import Span
from facescript.world import World

RATE = 30
"""Sightings a second of each person."""


@dataclass(frozen=True, slots=True)
class Visit:
    """A person is there, and seen on a path in `stretches` of time, s of the file."""

    person: str
    path: Path
    stretches: tuple[tuple[float, float], ...]

    @property
    def start(self) -> float:
        return self.stretches[0][0]

    @property
    def end(self) -> float:
        """When she has left."""
        return self.stretches[-1][1] + LEAVES


def opened(address: str, setting: Setting) -> Source:
    """Raises `AddressFault`."""
    try:
        return TrackSource(read_visits(address.partition(":")[2], setting.world), setting.clock)
    except ValueError as fault:
        raise AddressFault("FS971", address=address[:LONGEST], reason=fault) from None


class TrackSource:
    """Tells what a file says as if it happened from now on. Who is lost has left; who is back has arrived."""

    def __init__(self, visits: tuple[Visit, ...], clock: Clock) -> None:
        self._visits, self._clock = visits, clock
        self._counts: Counter[str] = Counter()

    async def run(self, teller: Teller) -> None:
        start = self._clock.now()
        for item in told(self._visits):
            while (early := start + item.time - self._clock.now()) > 0.0:
                await asyncio.sleep(early)
            self._tell(teller, start, item)
        await asyncio.Event().wait()

    def counts(self) -> dict[str, int]:
        """Sightings, and persons who arrived."""
        return dict(self._counts)

    def _tell(self, teller: Teller, start: float, item: Sighting | Happening) -> None:
        if isinstance(item, Sighting):
            self._counts["sightings"] += 1
            teller.sighting(Sighting(item.person, start + item.time, item.place))
        else:
            self._counts["arrived"] += item.kind == "arrives"
            teller.event(Happening(item.kind, start + item.time, person=item.person))


def read_visits(name: str, world: World) -> tuple[Visit, ...]:
    """The visits that a file of the project tells of. Raises `ValueError` with a sentence for its author."""
    diagnostics = Diagnostics()
    text = Text("", name)
    try:
        found = tracks(Project(world, diagnostics, Names()), String(name, Span(text, 0, len(name))))
    except Refused:
        raise ValueError(next(iter(diagnostics)).message.removesuffix(".")) from None
    visits = tuple(visit for person, track in found.items() for visit in _visits(f"person {person or 1}", track))
    edges = sorted(edge for visit in visits for edge in ((visit.start, 1), (visit.end, -1)))
    most = max(accumulate(change for _, change in edges))
    if most > MOST:
        raise ValueError(f"The track “{name}” has {most} persons at a time; {MOST} can be there")
    return visits


def _visits(person: str, track: Track) -> Iterator[Visit]:
    """Who is not seen for longer than a camera waits for her has left, and comes again."""
    path = Path(track.times, track.places, track.lost)
    first, last = track.times[0], track.times[-1]
    gaps = [gap for gap in track.lost if first <= gap[0] and gap[1] <= last]
    edges = [first, *(edge for gap in gaps for edge in gap), last]
    stretches: list[tuple[float, float]] = []
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        if stretches and start - stretches[-1][1] > LEAVES:
            yield Visit(person, path, tuple(stretches))
            stretches = []
        stretches.append((start, end))
    yield Visit(person, path, tuple(stretches))


def told(visits: Iterable[Visit]) -> Iterator[Sighting | Happening]:
    """What the visits tell, in the order of its times; of each first where she is, then that she arrives."""
    return merge(*map(_told, visits), key=lambda item: item.time)


def _told(visit: Visit) -> Iterator[Sighting | Happening]:
    yield Sighting(visit.person, visit.start, visit.path.at(visit.start))
    yield Happening("arrives", visit.start, person=visit.person)
    for start, end in visit.stretches:
        for number in range(int((end - start) * RATE) + 1):
            time = start + number / RATE
            if time > visit.start:
                yield Sighting(visit.person, time, visit.path.at(time))
    yield Happening("leaves", visit.end, person=visit.person)
