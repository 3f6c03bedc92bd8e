"""What sources tell, from any thread and at any rate, to what a run heeds at its next frame: little, and in order."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from heapq import heappop, heappush
from threading import Lock

from facescript.live.clock import Clock
from facescript.live.model import Happening, Sighting, Told

AHEAD = 10.0
"""Seconds that an event may wait for its own time."""

MOST_WAITING = 1000
"""Events that wait for a frame or for their time."""

MOST_PERSONS = 64
"""Persons that are there at once."""

FORGOTTEN = 60.0
"""Seconds after which a person who was not seen again makes room for another."""

QUICKEST, QUICKEST_OF_ALL = 10.0, 60.0
"""As often in a second an event is heeded, and all events together; a second's worth may come at once."""

HEEDING, PROMPT = 5.0, 5.0
"""Frames a second that heed events, and how many may do so one after another: what comes in between waits for the next
of them. To heed events is far more work than a frame."""

MOST_TOLD = 20
"""Events of no reaction that are told of."""

STRANGE, EARLY, SAME = "no reaction waits for it", "its time is too far ahead", "coalesced"
MANY, CROWDED = "too many events", "too many persons"
"""Why an event is not taken."""

OPPOSITE = {"arrives": "leaves", "leaves": "arrives"}
"""Events between which the same event is another: who comes, goes and comes again is there."""

Key = tuple[str, str, str | None]


class Bucket:
    """As many as `rate` a second, and `most` at once after a pause: as many where it is not said."""

    def __init__(self, rate: float, most: float | None = None) -> None:
        self._rate, self._most = rate, most or rate
        self._left, self._since = self._most, 0.0

    def takes(self, now: float) -> bool:
        self._left = min(self._most, self._left + (now - self._since) * self._rate)
        self._since = now
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True


class Gate:
    """The `Teller` of all sources of a run. `known` says whether anything waits for an event; `told` gets a sentence
    for an author. An event before now is one of now; one that is equal to another of its frame is the same."""

    def __init__(
        self, clock: Clock, fps: float, known: Callable[[Happening], bool], told: Callable[[str], None]
    ) -> None:
        self._clock, self._frame, self._known, self._tell = clock, 1.0 / fps, known, told
        self._lock = Lock()
        self._waiting: list[tuple[float, int, Told]] = []
        self._number = 0
        self._due: dict[Key, float] = {}
        self._seen: dict[str, Sighting] = {}
        self._persons: dict[str, float] = {}
        self._buckets: dict[Key, Bucket] = {}
        self._all, self._heeding = Bucket(QUICKEST_OF_ALL), Bucket(HEEDING, PROMPT)
        self._strange: set[tuple[str, str]] = set()
        self._counts: Counter[str] = Counter()

    def event(self, happening: Happening) -> str | None:
        with self._lock:
            why = self._take(happening, self._clock.now())
            strange = why == STRANGE and self._first(happening)
            self._counts["taken" if why is None else why if why == SAME else f"refused: {why}"] += 1
        if strange:
            told = f'{happening.kind} "{happening.text}"'
            self._tell(f"No `when` of the script waits for {told}; it is counted, and told of this once.")
        return None if why == SAME else why

    def sighting(self, sighting: Sighting) -> str | None:
        with self._lock:
            now = self._clock.now()
            if not self._welcome(sighting.person, now):
                self._counts[f"refused: {CROWDED}"] += 1
                return CROWDED
            if sighting.person in self._seen:
                self._counts["sightings overtaken"] += 1
            else:
                self._wait(now, sighting)
            self._counts["sightings"] += 1
            before = self._seen.get(sighting.person)
            seen = replace(sighting, time=sighting.time if 0.0 < sighting.time < now else now)
            if before is None or seen.time >= before.time:
                self._seen[sighting.person] = seen
        return None

    def following(self, number: int) -> int | None:
        """Every frame is to be given."""
        return number

    def due(self, number: int, after: float, upto: float) -> list[Told]:
        """What a frame at `upto` heeds, the frame before being at `after`: all that came or whose time has come, in
        order, events at times in between."""
        with self._lock:
            now = max(upto, self._clock.now())
            ready: list[tuple[float, int, Told]] = []
            while self._waiting and self._waiting[0][0] <= now:
                ready.append(heappop(self._waiting))
            events = any(isinstance(item, Happening) for _, _, item in ready)
            held = events and not self._heeding.takes(now)
            return [self._heeded(one, after, upto) for one in ready if not held or not self._held(one)]

    def _held(self, one: tuple[float, int, Told]) -> bool:
        """Has an event wait on."""
        if isinstance(one[2], Sighting):
            return False
        heappush(self._waiting, one)
        return True

    def _heeded(self, one: tuple[float, int, Told], after: float, upto: float) -> Told:
        time, _, item = one
        if isinstance(item, Sighting):
            return self._seen.pop(item.person)
        self._due.pop(key(item), None)
        return replace(item, time=between(time, after, upto))

    def counts(self) -> dict[str, int]:
        """What was taken, coalesced and refused, and why."""
        with self._lock:
            return dict(self._counts)

    def _take(self, happening: Happening, now: float) -> str | None:
        """Takes an event; why not, else."""
        due, name = max(now, happening.time), key(happening)
        if not self._known(happening):
            return STRANGE
        if due > now + AHEAD:
            return EARLY
        if name in self._due and abs(due - max(now, self._due[name])) < self._frame:
            return SAME
        if len(self._waiting) >= MOST_WAITING or not self._often(name, now):
            return MANY
        if happening.person is not None and not self._comes(happening, now):
            return CROWDED
        self._due[name] = due
        self._due.pop((OPPOSITE.get(happening.kind, ""), "", happening.person), None)
        self._wait(due, happening)
        return None

    def _wait(self, due: float, item: Told) -> None:
        heappush(self._waiting, (due, self._number, item))
        self._number += 1

    def _often(self, name: Key, now: float) -> bool:
        """Whether an event does not come too often."""
        if len(self._buckets) > MOST_WAITING:
            self._buckets.clear()
        return self._buckets.setdefault(name, Bucket(QUICKEST)).takes(now) and self._all.takes(now)

    def _comes(self, happening: Happening, now: float) -> bool:
        """Notes who comes and goes; whether there is room for a person."""
        assert happening.person is not None
        if happening.kind == "leaves":
            self._persons.pop(happening.person, None)
            return True
        return self._welcome(happening.person, now)

    def _welcome(self, person: str, now: float) -> bool:
        if person not in self._persons and len(self._persons) >= MOST_PERSONS:
            self._persons = {name: seen for name, seen in self._persons.items() if now - seen < FORGOTTEN}
            if len(self._persons) >= MOST_PERSONS:
                return False
        self._persons[person] = now
        return True

    def _first(self, happening: Happening) -> bool:
        name = (happening.kind, happening.text)
        if name in self._strange or len(self._strange) >= MOST_TOLD:
            return False
        self._strange.add(name)
        return True


def key(happening: Happening) -> Key:
    """What makes two events the same."""
    return happening.kind, happening.text, happening.person


def between(time: float, after: float, upto: float) -> float:
    """A time in (after, upto], rounded to microseconds where there is room: what a frame has shown is not changed by
    what comes then."""
    return min(upto, max(round(time, 6), after + min(1e-6, (upto - after) / 2)))
