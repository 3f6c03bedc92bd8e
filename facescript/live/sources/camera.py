"""`camera:0` and `video:visit.mp4`: pictures to who is there, where, who comes and goes, in a thread of their own."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from threading import Event, Thread

from facescript.live.address import LONGEST, AddressFault
from facescript.live.clock import Clock
from facescript.live.model import Happening, Sighting, Source, Teller
from facescript.live.seeing.cascade import Cascade
from facescript.live.seeing.device import Grabber, Timed, camera
from facescript.live.seeing.faces import Finder
from facescript.live.seeing.film import FPS, pictures
from facescript.live.seeing.mediapipe import MediaPipe, installed
from facescript.live.seeing.newest import Newest
from facescript.live.seeing.options import Options, options
from facescript.live.seeing.presence import ABSENT, PRESENT
from facescript.live.seeing.thread import in_thread
from facescript.live.seeing.tracker import LEAVES
from facescript.live.seeing.watch import Watcher
from facescript.live.sources.setting import Setting
from facescript.world import World, WorldFailure

BLIND = 0.2
"""Without a picture for so long, nobody is seen, s."""

LATE = 2.0 / FPS
"""A video's picture is passed over that is so late, s."""


MOST_CAMERAS = 64


def opened(address: str, setting: Setting) -> Source:
    """Raises `AddressFault`."""
    scheme, _, rest = address.partition(":")
    name, _, query = rest.partition("?")
    film = setting.play.film
    try:
        found = options(query, film.wide_cm * film.height / film.width / 2)
        number = None if scheme == "video" else _number(name)
    except ValueError as fault:
        example = "camera:0?fov=60&tilt=-30" if scheme == "camera" else "video:visit.mp4?fov=60"
        raise AddressFault("FS981", address=address[:LONGEST], reason=fault, example=example) from None
    try:
        watcher = Watcher(found.camera, _finder(found), _signals(setting))
        if number is None:
            return VideoSource(_file(setting.world, name), found.size, setting.clock, watcher)
    except (OSError, WorldFailure) as fault:
        raise AddressFault("FS971", address=address[:LONGEST], reason=fault) from None
    return CameraSource(_grabber(number, found, setting.clock), watcher)


def _file(world: World, name: str) -> Path:
    path = world.path(name)
    if not path.is_file():
        raise WorldFailure("there is no such file")
    return path


def _number(name: str) -> int:
    if not name.isascii() or not name.isdigit() or int(name[:4]) >= MOST_CAMERAS:
        raise ValueError(f"a camera has a number from 0 to {MOST_CAMERAS - 1}")
    return int(name)


def _grabber(number: int, found: Options, clock: Clock) -> Grabber:
    return Grabber(lambda: camera(number, found.size), found.size, clock.now, found.delay)


def _finder(found: Options) -> Finder:
    if found.by == "mediapipe" and not installed():
        raise OSError("no MediaPipe is installed that comes with its models (`mediapipe==0.10.21`)")
    return MediaPipe() if found.by != "cascade" and installed() else Cascade()


def _signals(setting: Setting) -> frozenset[str]:
    """Those of presence for which the script waits."""
    waits = (one.event.text for one in setting.play.reactions if one.event.kind == "signal")
    return frozenset(waits) & {PRESENT, ABSENT}


class CameraSource:
    """Watches through a camera from now on; the newest picture counts, and those before it are passed over."""

    def __init__(self, grabber: Grabber, watcher: Watcher) -> None:
        self._grabber, self._watcher = grabber, watcher
        self._newest: Newest[Timed] = Newest()

    async def run(self, teller: Teller) -> None:
        await in_thread(lambda stop: self._watch(teller, stop), "camera")

    def counts(self) -> dict[str, int]:
        """Pictures that were looked at and passed over, faces in them, persons who arrived or for whom there was no
        room, and how often the camera was not there or went away."""
        return {**self._watcher.counts, **self._grabber.counts, "passed over": self._newest.passed}

    def _watch(self, teller: Teller, stop: Event) -> None:
        Thread(target=self._grabber.grab, args=(self._newest, stop), name="grabber", daemon=True).start()
        while not stop.is_set():
            if self._grabber.fault is not None:
                raise OSError(f"it cannot be used ({self._grabber.fault})") from self._grabber.fault
            taken = self._newest.take(BLIND)
            if taken is None:
                tell(teller, self._watcher.blind(self._grabber.now() - self._grabber.delay))
            else:
                tell(teller, self._watcher.look(*taken))


class VideoSource:
    """Watches a video, which begins when the source does and is played once, in its own time."""

    def __init__(self, path: Path, size: tuple[int, int], clock: Clock, watcher: Watcher) -> None:
        self._path, self._size, self._clock, self._watcher = path, size, clock, watcher
        self._passed = 0

    async def run(self, teller: Teller) -> None:
        await in_thread(lambda stop: self._watch(teller, stop), "video")

    def counts(self) -> dict[str, int]:
        """As of a camera."""
        return {**self._watcher.counts, "passed over": self._passed}

    def _watch(self, teller: Teller, stop: Event) -> None:
        start = time = 0.0
        for number, picture in enumerate(pictures(self._path, self._size)):
            start = start or self._clock.now()
            time = start + number / FPS
            if not self._wait(time, stop):
                return
            if self._clock.now() - time > LATE:
                self._passed += 1
                continue
            tell(teller, self._watcher.look(picture, time))
        self._wait(time + LEAVES + BLIND, stop)
        tell(teller, self._watcher.blind(time + LEAVES + BLIND))
        stop.wait()

    def _wait(self, time: float, stop: Event) -> bool:
        """Waits until a time of the run; whether it goes on then."""
        while (early := time - self._clock.now()) > 0.0:
            if stop.wait(early):
                return False
        return not stop.is_set()


def tell(teller: Teller, items: Iterable[Sighting | Happening]) -> None:
    for item in items:
        if isinstance(item, Sighting):
            teller.sighting(item)
        else:
            teller.event(item)
