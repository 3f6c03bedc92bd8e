"""A file of tracks to who is there: the reader of the language, persons apart, gaps, and what is wrong with a file."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from facescript.live.clock import WallClock
from facescript.live.model import Happening, Sighting
from facescript.live.seeing.tracker import MOST
from facescript.live.sources.track import TrackSource, read_visits, told
from facescript.world import World

ROOT = Path(__file__).parents[3]


def items(folder: Path, text: str) -> list[Sighting | Happening]:
    (folder / "visit.csv").write_text(text, "utf-8")
    return list(told(read_visits("visit.csv", World(folder))))


def comings(found: list[Sighting | Happening]) -> list[tuple[str, float, str | None]]:
    return [(item.kind, item.time, item.person) for item in found if isinstance(item, Happening)]


def test_one_person_walks_by_thirty_times_a_second(tmp_path: Path) -> None:
    found = items(tmp_path, "time,x,y,z\n1,-60,0,200\n2,0,2,150\n3,60,0,200\n")
    seen = [item for item in found if isinstance(item, Sighting)]
    assert comings(found) == [("arrives", 1.0, "person 1"), ("leaves", 4.0, "person 1")]
    assert isinstance(found[0], Sighting) and len(seen) == 61
    assert [item.time for item in seen] == sorted(item.time for item in seen)
    (middle,) = [item for item in seen if item.time == pytest.approx(2.0)]
    assert (middle.place.x, middle.place.y, middle.place.z) == pytest.approx((0.0, 2.0, 150.0))


def test_persons_are_told_apart_and_go_their_own_ways(tmp_path: Path) -> None:
    rows = "0,ann,-50,0,150\n0,bo,50,0,150\n1,ann,50,0,150\n1,bo,-50,0,150\n1.5,bo,-50,0,150\n"
    found = items(tmp_path, "time,person,x,y,z\n" + rows)
    assert comings(found) == [
        ("arrives", 0.0, "person ann"),
        ("arrives", 0.0, "person bo"),
        ("leaves", 2.0, "person ann"),
        ("leaves", 2.5, "person bo"),
    ]
    assert [item.time for item in found] == sorted(item.time for item in found)
    last = {item.person: item.place.x for item in found if isinstance(item, Sighting)}
    assert last == pytest.approx({"person ann": 50.0, "person bo": -50.0})


def test_who_is_lost_for_longer_has_left_and_comes_again(tmp_path: Path) -> None:
    rows = "0,0,0,100\n1,10,0,100\n1.1,,,\n1.6,20,0,100\n2,20,0,100\n2.1,nan,nan,nan\n4,-30,0,100\n5,0,0,100\n"
    found = items(tmp_path, "time,x,y,z\n" + rows)
    arrives, leaves = [(kind, time) for kind, time, _ in comings(found)][::2], comings(found)[1::2]
    assert arrives == [("arrives", 0.0), ("arrives", 4.0)]
    assert [(kind, time) for kind, time, _ in leaves] == [("leaves", 3.0), ("leaves", 6.0)]
    times = [item.time for item in found if isinstance(item, Sighting)]
    assert not [time for time in times if 1.01 < time < 1.59 or 2.01 < time < 3.99]


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("time,x,y\n0,1,2\n", "no column `z`"),
        ("time,x,y,z\n0,left,0,100\n", "`left` in row 1, column `x`"),
        ("time,person,x,y,z\n1,ann,0,0,100\n1,bo,0,0,100\n1,ann,0,0,100\n", "`1` of row 3"),
        ("time,person,x,y,z\n0," + "a" * 41 + ",0,0,100\n", "is no name of at most 40"),
        ("time,x,y,z\n0,,,\n", "no row says where"),
        ("time,person,x,y,z\n" + "".join(f"0,p{n},0,0,100\n1,p{n},0,0,100\n" for n in range(MOST + 1)), "17 persons"),
    ],
)
def test_what_is_wrong_with_a_file_is_said(tmp_path: Path, text: str, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        items(tmp_path, text)


def test_a_file_outside_the_project_is_refused(tmp_path: Path) -> None:
    (tmp_path / "out.csv").write_text("time,x,y,z\n0,0,0,100\n", "utf-8")
    (tmp_path / "in").mkdir()
    with pytest.raises(ValueError, match="outside the project"):
        read_visits("../out.csv", World(tmp_path / "in"))


class Heard:
    def __init__(self) -> None:
        self.events: list[Happening] = []
        self.sightings: list[Sighting] = []

    def event(self, happening: Happening) -> None:
        self.events.append(happening)

    def sighting(self, sighting: Sighting) -> None:
        self.sightings.append(sighting)


async def test_it_is_told_in_its_own_time(tmp_path: Path) -> None:
    (tmp_path / "visit.csv").write_text("time,x,y,z\n0.1,-60,0,200\n0.3,0,2,150\n3,60,0,200\n", "utf-8")
    clock, heard = WallClock(), Heard()
    clock.begin()
    source = TrackSource(read_visits("visit.csv", World(tmp_path)), clock)
    task = asyncio.create_task(source.run(heard))
    await asyncio.sleep(0.35)
    now = clock.now()
    task.cancel()
    assert [event.kind for event in heard.events] == ["arrives"]
    assert 0.0 <= now - heard.sightings[-1].time < 0.1 and len(heard.sightings) > 4
    assert source.counts() == {"sightings": len(heard.sightings), "arrived": 1}


def test_the_examples_track_is_one_person(tmp_path: Path) -> None:
    visits = read_visits("track.csv", World(ROOT / "examples"))
    assert {visit.person for visit in visits} == {"person 1"}
