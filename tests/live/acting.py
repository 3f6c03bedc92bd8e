"""A run for tests of what is around one: its one channel counts what it has heeded, and an event is a mark."""

from __future__ import annotations

import numpy as np

from facescript.live.model import Frame, Happening, Layout, Mark, Sighting, Told, Utterance
from facescript.performance.channels import Channel


class Actor:
    """Performs at a rate; `heeded` has all that it heard and saw, `numbers` the frames that it was asked for."""

    def __init__(self, fps: float = 60.0) -> None:
        self.layout = Layout(fps, ("mia",), ("head.yaw",), (Channel("head.yaw", "deg"),))
        self.heeded: list[Told] = []
        self.numbers: list[int] = []
        self._told = 0

    def hear(self, happening: Happening) -> None:
        self.heeded.append(happening)

    def see(self, sighting: Sighting) -> None:
        self.heeded.append(sighting)

    def frame(self, number: int) -> Frame:
        self.numbers.append(number)
        return Frame(number, number / self.layout.fps, np.array([float(len(self.heeded))]))

    def marks(self, time: float) -> list[Mark]:
        new, self._told = self.heeded[self._told :], len(self.heeded)
        return [Mark("event", item.time, item.kind) for item in new if isinstance(item, Happening)]

    def utterances(self, time: float) -> list[Utterance]:
        return []


class Audience:
    """A sink that keeps what it is given."""

    def __init__(self) -> None:
        self.frames: list[Frame] = []
        self.marks: list[Mark] = []

    async def open(self, layout: Layout) -> None:
        pass

    def frame(self, frame: Frame) -> None:
        self.frames.append(frame)

    def mark(self, mark: Mark) -> None:
        self.marks.append(mark)

    def utter(self, utterance: Utterance) -> None:
        pass

    async def close(self) -> None:
        pass

    def counts(self) -> dict[str, int]:
        return {"sent": len(self.frames)}


class Ears:
    """A teller that keeps what it is told, and refuses what is called `nobody`."""

    def __init__(self) -> None:
        self.told: list[Told] = []

    def event(self, happening: Happening) -> str | None:
        self.told.append(happening)
        return "no reaction waits for it" if happening.text == "nobody" else None

    def sighting(self, sighting: Sighting) -> str | None:
        self.told.append(sighting)
        return None
