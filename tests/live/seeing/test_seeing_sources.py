"""Videos and cameras as sources of a run: a real film of drawn persons, a camera that goes away, addresses."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from facescript.compile import Settings
from facescript.ir.values import Point
from facescript.live.address import AddressFault
from facescript.live.clock import WallClock
from facescript.live.model import Happening, Sighting, Source
from facescript.live.opening import open_play
from facescript.live.ports import Ports
from facescript.live.seeing.geometry import Camera
from facescript.live.sources.registry import open_source
from facescript.live.sources.setting import Setting
from facescript.text import Source as Script
from facescript.world import World

cv2 = pytest.importorskip("cv2", reason="the package opencv-python-headless is not installed")

from drawn import FPS, HIGH, WIDE, film, scene  # noqa: E402

from facescript.live.seeing.cascade import Cascade  # noqa: E402
from facescript.live.seeing.device import Device, Grabber  # noqa: E402
from facescript.live.seeing.film import pictures  # noqa: E402
from facescript.live.seeing.watch import Watcher  # noqa: E402
from facescript.live.sources.camera import CameraSource  # noqa: E402

SECONDS = 1.0
SCRIPT = "film 640x480, 40cm wide\nwhen person arrives as guest:\n    look at guest\n"


class FilmClock(WallClock):
    """Goes at half the speed of this machine's while the film plays, so that one which has much to do keeps up, and
    fast thereafter."""

    def now(self) -> float:
        return min(0.5 * super().now(), SECONDS) + max(0.0, super().now() - 2 * SECONDS) * 8


class Heard:
    """Who keeps what is told, and how old each sighting was."""

    def __init__(self, clock: WallClock) -> None:
        self.clock, self.items, self.ages = clock, list[Sighting | Happening](), list[float]()

    def event(self, happening: Happening) -> None:
        self.items.append(happening)

    def sighting(self, sighting: Sighting) -> None:
        self.items.append(sighting)
        self.ages.append(self.clock.now() - sighting.time)

    @property
    def comings(self) -> list[str]:
        return [item.kind for item in self.items if isinstance(item, Happening)]


@pytest.fixture(scope="module")
def walk(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A film of one who walks to the viewers' right before a camera on top of a screen that is 30 cm high."""
    camera = Camera(Point(0.0, 15.0, 0.0))
    path = tmp_path_factory.mktemp("film") / "walk.mp4"
    film(path, (scene(camera, [Point(-15 + number, 0.0, 80.0)]) for number in range(int(SECONDS * FPS))))
    return path


def setting(root: Path, clock: WallClock) -> Setting:
    play, _ = open_play(Script("x.face", SCRIPT), World(root), Settings())
    assert play is not None
    return Setting(play, World(root), clock, Ports(), "", lambda _: None, dict)


async def hear(source: Source, heard: Heard, enough: Callable[[], bool]) -> None:
    """Let a source tell until it is enough, ten seconds at most."""
    heard.clock.begin()
    task = asyncio.create_task(source.run(heard))
    async with asyncio.timeout(10):
        while not enough() and not task.done():
            await asyncio.sleep(0.02)
    task.cancel()
    await asyncio.gather(task, return_exceptions=True)


async def test_a_video_plays_in_its_own_time_and_tells_who_walks_by(walk: Path) -> None:
    clock = FilmClock()
    source, heard = open_source(f"video:{walk.name}?by=cascade", setting(walk.parent, clock)), Heard(clock)
    await hear(source, heard, lambda: "leaves" in heard.comings)
    assert heard.comings == ["arrives", "leaves"]
    assert isinstance(heard.items[0], Sighting) and {item.person for item in heard.items} == {"person 1"}
    seen = [item for item in heard.items if isinstance(item, Sighting)]
    for one in seen:
        assert abs(one.place.x - (-15 + one.time * FPS)) < 5.0 and abs(one.place.y) < 4.0
    assert seen[-1].place.x - seen[0].place.x > 0.7 * (seen[-1].time - seen[0].time) * FPS
    counts = source.counts()
    assert counts["pictures"] + counts["passed over"] == SECONDS * FPS and counts["arrived"] == 1
    assert min(heard.ages) >= 0.0


def test_pictures_of_a_video_have_blue_first_and_are_no_larger_than_asked_for(tmp_path: Path) -> None:
    red = np.full((HIGH, WIDE, 3), (20, 40, 200), dtype=np.uint8)
    film(tmp_path / "red.mp4", [red] * 6)
    found = list(pictures(tmp_path / "red.mp4", (320, 320)))
    assert len(found) == 6 and {picture.shape for picture in found} == {(240, 320, 3)}
    assert np.abs(found[0].mean(axis=(0, 1)) - (20, 40, 200)).max() < 12


def test_pictures_in_which_there_is_no_room_for_a_face_are_refused(tmp_path: Path) -> None:
    film(tmp_path / "wide.mp4", [np.zeros((2, WIDE, 3), dtype=np.uint8)] * 6)
    with pytest.raises(ValueError, match="smaller than 40 pixels"):
        list(pictures(tmp_path / "wide.mp4", (640, 480)))


async def test_a_camera_that_goes_away_is_tried_again(walk: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Here a camera that gives a second of pictures, then nothing, is not there, and then comes back."""
    monkeypatch.setattr("facescript.live.seeing.device.AGAIN", 0.05)
    opened: list[str] = []

    def device() -> Device:
        opened.append("again")
        there = len(opened) in (1, 3)
        return cv2.VideoCapture(str(walk if there else walk.parent / "nothing.mp4"))

    clock = WallClock()
    heard, grabber = Heard(clock), Grabber(device, (640, 480), clock.now, 0.01)
    source = CameraSource(grabber, Watcher(Camera(Point(0.0, 15.0, 0.0)), Cascade()))
    await hear(source, heard, lambda: len(opened) > 4)
    counts = source.counts()
    assert counts["went away"] == 2 and counts["not there"] >= 1 and counts["passed over"] > 0


async def test_a_camera_that_is_not_there_is_no_fault(tmp_path: Path) -> None:
    clock = WallClock()
    source, heard = open_source("camera:63?by=cascade", setting(tmp_path, clock)), Heard(clock)
    await hear(source, heard, lambda: source.counts().get("not there", 0) > 0)
    assert heard.items == []


@pytest.mark.parametrize(
    ("address", "code", "reason"),
    [
        ("camera:", "FS981", "a number from 0"),
        ("camera:front", "FS981", "a number from 0"),
        ("camera:99999", "FS981", "a number from 0"),
        ("camera:0?lens=wide", "FS981", "no option `lens`"),
        ("video:nothing.mp4", "FS971", "no such file"),
        ("video:../walk.mp4", "FS971", "outside the project"),
        ("track:nothing.csv", "FS971", "no such file"),
    ],
)
def test_what_can_never_work_is_said_at_once(tmp_path: Path, address: str, code: str, reason: str) -> None:
    with pytest.raises(AddressFault, match=reason) as fault:
        open_source(address, setting(tmp_path, WallClock()))
    assert fault.value.code == code


async def test_a_file_that_is_no_video_is_said_to_be_none(tmp_path: Path) -> None:
    """... even one that would have other files read."""
    (tmp_path / "list.mp4").write_text("#EXTM3U\n#EXTINF:1,\nhttp://127.0.0.1:9/x.ts\n", "utf-8")
    clock = WallClock()
    source = open_source("video:list.mp4?by=cascade", setting(tmp_path, clock))
    clock.begin()
    with pytest.raises(ValueError, match="no picture in it"):
        await source.run(Heard(clock))
