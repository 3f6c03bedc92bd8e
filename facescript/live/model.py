"""What passes through a live run: happenings and sightings in; frames, marks and utterances out, to sinks."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from facescript.ir.values import Point
from facescript.performance.channels import Channel
from facescript.schedule.events import Happening
from facescript.speech.model import Spoken

__all__ = ["Frame", "Happening", "Layout", "Mark", "Sighting", "Sink", "Source", "Teller", "Told", "Utterance"]


@dataclass(frozen=True, slots=True)
class Sighting:
    """Where a person is at a `time` of the run (s), cm: x to the viewer's right, y up, z out of the screen. A person's
    name is that of the events `arrives` and `leaves`; one who is lost is no longer told of."""

    person: str
    time: float
    place: Point


@dataclass(frozen=True, slots=True)
class Layout:
    """What every frame of a run is: `names` and `channels` are those of its values, in order; with several faces a name
    bears its face's in front (`ada.head.yaw`). `faces` are those that are seen."""

    fps: float
    faces: tuple[str, ...]
    names: tuple[str, ...]
    channels: tuple[Channel, ...]
    title: str = ""
    seed: int = 0


@dataclass(frozen=True, slots=True)
class Frame:
    """All channels at a time of the run: the frame's `number` over the layout's `fps`, s; `values` array[channel]."""

    number: int
    time: float
    values: NDArray[np.float64] = field(compare=False)


@dataclass(frozen=True, slots=True)
class Mark:
    """Something that begins at a `time` of the run (s): an act, a word of a line, a line (or that it `breaks` off), a
    scene, or an event that was heeded. `text` is what it is called or says, `label` the author's name for it, `late` by
    how much the run was behind when it told of it, s."""

    kind: Literal["act", "word", "line", "breaks", "scene", "event"]
    time: float
    text: str
    face: str | None = None
    label: str | None = None
    late: float = 0.0


@dataclass(frozen=True, slots=True)
class Utterance:
    """A line that sounds from `start` on, s of the run; `cut` is when it breaks off, else None. One that is told of
    again under its `number` takes the place of what was told."""

    number: int
    face: str
    start: float
    spoken: Spoken
    volume: float
    text: str
    cut: float | None = None


Told = Happening | Sighting
"""What a source tells and a run heeds."""


class Sink(Protocol):
    """Where a run goes. None of `frame`, `mark` and `utter` waits: what a peer cannot take in time is dropped, and
    counted. A sink whose peer is not there yet tries again by itself, and raises nothing for it."""

    async def open(self, layout: Layout) -> None:
        """Begin. Raises `OSError` or `ValueError` for an address that cannot work."""
        ...

    def frame(self, frame: Frame) -> None: ...

    def mark(self, mark: Mark) -> None: ...

    def utter(self, utterance: Utterance) -> None: ...

    async def close(self) -> None: ...

    def counts(self) -> dict[str, int]:
        """What was sent, and what was dropped and why: `sent`, `dropped`, ..."""
        ...


class Teller(Protocol):
    """Takes what a source has, from any thread, at once; what is too much is dropped there, and counted."""

    def event(self, happening: Happening) -> str | None:
        """Takes an event; why it is refused, where it is. A time of 0 or before now means now."""
        ...

    def sighting(self, sighting: Sighting) -> str | None:
        """The same for where a person is; of a person only the newest is heeded at a frame."""
        ...


class Source(Protocol):
    """Where events come from. A time before now is taken as now; an event of a time to come waits at the gate."""

    async def run(self, teller: Teller) -> None:
        """Tells until it is cancelled. What is not there yet (a camera, a broker) is tried again. Raises `OSError` or
        `ValueError` for what can never work."""
        ...

    def counts(self) -> dict[str, int]: ...
