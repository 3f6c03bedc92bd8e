"""The gate: what is too much, too early or for nobody is refused and counted; what is left comes in order."""

from __future__ import annotations

from threading import Thread

from facescript.ir.values import Point
from facescript.live.clock import SimulatedClock
from facescript.live.gate import AHEAD, HEEDING, MOST_PERSONS, MOST_TOLD, PROMPT, QUICKEST, QUICKEST_OF_ALL, Gate
from facescript.live.model import Happening, Sighting

FRAME = 0.1
"""Seconds."""


class Door:
    """A gate at ten frames a second; everything is known but what is called `nobody`."""

    def __init__(self) -> None:
        self.clock, self.said = SimulatedClock(), list[str]()
        self.gate = Gate(self.clock, 1 / FRAME, lambda happening: happening.text != "nobody", self.said.append)
        self.frame = 0

    async def next(self) -> list[Happening | Sighting]:
        """What the next frame heeds."""
        self.frame += 1
        await self.clock.until(self.frame * FRAME)
        return self.gate.due(self.frame, (self.frame - 1) * FRAME, self.frame * FRAME)

    def heard(self, text: str, time: float = 0.0) -> str | None:
        return self.gate.event(Happening("heard", time, text))


def seen(person: str, x: float, time: float = 0.0) -> Sighting:
    return Sighting(person, time, Point(x, 0.0, 80.0))


async def test_events_come_in_order_after_what_was_shown() -> None:
    door = Door()
    await door.next()
    for text in "abc":
        door.heard(text)
    found = await door.next()
    assert [item.text for item in found if isinstance(item, Happening)] == ["a", "b", "c"]
    assert all(FRAME < item.time <= 2 * FRAME for item in found)
    assert await door.next() == []


async def test_an_event_waits_for_its_time() -> None:
    door = Door()
    assert door.heard("later", 0.25) is None and door.heard("past", -3.0) is None
    assert door.heard("never", AHEAD + 1) == "its time is too far ahead"
    heeded = [[item.time for item in await door.next()] for _ in range(4)]
    assert [len(items) for items in heeded] == [1, 0, 1, 0]
    assert heeded[2] == [0.25]


async def test_the_same_event_of_a_frame_is_one() -> None:
    door = Door()
    assert [door.heard("no") for _ in range(5)] == [None] * 5
    assert len(await door.next()) == 1
    assert door.gate.counts() == {"taken": 1, "coalesced": 4}
    assert door.heard("no") is None and len(await door.next()) == 1


async def test_who_comes_again_within_a_frame_is_there() -> None:
    door = Door()
    for kind in ("arrives", "arrives", "leaves", "arrives"):
        assert door.gate.event(Happening(kind, 0.0, person="ann")) is None
    assert [item.kind for item in await door.next() if isinstance(item, Happening)] == ["arrives", "leaves", "arrives"]


async def test_what_nothing_waits_for_is_told_once() -> None:
    door = Door()
    assert [door.heard("nobody") for _ in range(3)] == ["no reaction waits for it"] * 3
    assert len(door.said) == 1 and '"nobody"' in door.said[0]
    for number in range(2 * MOST_TOLD):
        door.gate.event(Happening(f"kind{number}", 0.0, "nobody"))
    assert len(door.said) == MOST_TOLD and await door.next() == []


async def test_of_a_person_the_newest_place_counts() -> None:
    door = Door()
    await door.next()
    for x, time in ((1.0, 0.05), (3.0, 0.09), (2.0, 0.07)):
        door.gate.sighting(seen("ann", x, time))
    door.gate.sighting(seen("bob", 9.0))
    found = await door.next()
    assert [(item.person, item.place.x) for item in found if isinstance(item, Sighting)] == [("ann", 3.0), ("bob", 9.0)]


async def test_persons_and_events_keep_their_order() -> None:
    door = Door()
    door.gate.sighting(seen("ann", 1.0))
    door.gate.event(Happening("arrives", 0.0, person="ann"))
    found = await door.next()
    assert [type(item) for item in found] == [Sighting, Happening]


async def test_persons_are_bounded() -> None:
    door = Door()
    for number in range(MOST_PERSONS):
        door.gate.sighting(seen(f"p{number}", 1.0))
    assert door.gate.sighting(seen("one more", 1.0)) == "too many persons"
    assert door.gate.event(Happening("leaves", 0.0, person="p0")) is None
    assert door.gate.sighting(seen("one more", 1.0)) is None


async def test_a_flood_from_threads_is_counted_and_little_of_it_heeded() -> None:
    door, each = Door(), 5000

    def flood(text: str) -> None:
        for _ in range(each):
            door.heard(text)

    threads = [Thread(target=flood, args=(text,)) for text in "ab"]
    for thread in threads:
        thread.start()
    heeded = 0
    for _ in range(50):
        heeded += len(await door.next())
    for thread in threads:
        thread.join()
    heeded += len(await door.next())
    counts = door.gate.counts()
    assert sum(counts.values()) == 2 * each and counts["taken"] == heeded
    assert heeded <= 2 * QUICKEST * (1 + 51 * FRAME)


async def test_frames_heed_events_only_so_often_and_lose_none_that_waits() -> None:
    door, heeding, heeded = Door(), 0, set()
    for number in range(100):
        if number < 90:
            door.heard(f"no {number // 3}")
        found = await door.next()
        heeding += bool(found)
        heeded |= {item.text for item in found if isinstance(item, Happening)}
    assert 45 <= heeding <= PROMPT + 100 * FRAME * HEEDING
    assert heeded == {f"no {number}" for number in range(30)}


async def test_sightings_do_not_wait_for_events() -> None:
    door = Door()
    for number in range(50):
        door.heard(f"no {number}")
        door.gate.sighting(seen("ann", number))
        assert sum(isinstance(item, Sighting) for item in await door.next()) == 1


async def test_all_events_together_are_bounded() -> None:
    door = Door()
    for _ in range(100):
        for number in range(20):
            door.heard(f"no {number}")
        await door.next()
    assert door.gate.counts()["taken"] <= QUICKEST_OF_ALL * 11
