"""A camera of this machine to its pictures with their times; one that goes away is tried again."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from threading import Event
from typing import Any, Protocol

import cv2

from facescript.live.seeing.faces import Picture
from facescript.live.seeing.newest import Newest

AGAIN = 1.0
"""A camera that is not there is tried again after so long, s."""

FPS = 30

SILENT = 0
"""OpenCV's level of saying nothing."""

Timed = tuple[Picture, float]


class Device(Protocol):
    """What OpenCV has of a camera."""

    def isOpened(self) -> bool: ...

    def read(self) -> tuple[bool, Any]: ...

    def release(self) -> None: ...


def camera(number: int, size: tuple[int, int]) -> Device:
    """The camera of a number, asked for pictures of a size."""
    _hush()
    device = cv2.VideoCapture(number)
    device.set(cv2.CAP_PROP_FRAME_WIDTH, size[0])
    device.set(cv2.CAP_PROP_FRAME_HEIGHT, size[1])
    device.set(cv2.CAP_PROP_FPS, FPS)
    device.set(cv2.CAP_PROP_BUFFERSIZE, 1)
    found: Device = device
    return found


def _hush() -> None:
    """That a camera is not there, we say ourselves. What sets this has another place from version to version."""
    hush: Any = getattr(cv2, "setLogLevel", None) or cv2.utils.logging.setLogLevel
    hush(SILENT)


@dataclass(slots=True)
class Grabber:
    """Takes the pictures of a camera as they come, and keeps the newest with the time at which it was taken: `now` less
    the camera's `delay`, s."""

    opened: Callable[[], Device]
    size: tuple[int, int]
    now: Callable[[], float]
    delay: float
    counts: Counter[str] = field(default_factory=Counter)
    fault: Exception | None = None

    def grab(self, newest: Newest[Timed], stop: Event) -> None:
        """Until it is told to stop; what it cannot go on after is its `fault`."""
        try:
            self._grab(newest, stop)
        except Exception as fault:  # it is raised by who takes the pictures
            self.fault = fault

    def _grab(self, newest: Newest[Timed], stop: Event) -> None:
        while not stop.is_set():
            device = self.opened()
            try:
                if not self._read(device, newest, stop):
                    self.counts["not there"] += 1
                elif not stop.is_set():
                    self.counts["went away"] += 1
            finally:
                device.release()
            stop.wait(AGAIN)

    def _read(self, device: Device, newest: Newest[Timed], stop: Event) -> bool:
        """Reads until nothing comes; whether anything came."""
        came = False
        while device.isOpened() and not stop.is_set():
            found, picture = device.read()
            if not found or picture is None:
                break
            came = True
            newest.put((self._usual(picture), self.now() - self.delay))
        return came

    def _usual(self, picture: Any) -> Picture:
        """In three colours, and no larger than it was asked for."""
        if picture.ndim == 2:
            picture = cv2.cvtColor(picture, cv2.COLOR_GRAY2BGR)
        part = min(self.size[0] / picture.shape[1], self.size[1] / picture.shape[0])
        if part < 1.0:
            picture = cv2.resize(picture, None, fx=part, fy=part, interpolation=cv2.INTER_AREA)
        found: Picture = picture
        return found
