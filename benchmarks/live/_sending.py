"""Synthetic frames to a sink, by the loop of a live run: what is measured is the way out alone."""

from __future__ import annotations

import numpy as np

from facescript.live.clock import WallClock
from facescript.live.loop import Loop, Tally
from facescript.live.model import Frame, Happening, Layout, Mark, Sighting, Sink, Told, Utterance
from facescript.performance.channels import COMMON

FPS = 60.0


def layout(faces: int = 1) -> Layout:
    """A layout of some faces with all their channels."""
    names = [f"face{face}.{one.name}" if faces > 1 else one.name for face in range(faces) for one in COMMON]
    return Layout(FPS, tuple(f"face{face}" for face in range(faces)), tuple(names), COMMON * faces)


class Waves:
    """A performer whose channels all move, and nothing happens."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self._phases = np.arange(len(layout.names)) * 0.1

    def hear(self, happening: Happening) -> None: ...

    def see(self, sighting: Sighting) -> None: ...

    def frame(self, number: int) -> Frame:
        return Frame(number, number / FPS, np.sin(self._phases + number / FPS))

    def marks(self, time: float) -> list[Mark]:
        return []

    def utterances(self, time: float) -> list[Utterance]:
        return []


class Nothing:
    """A feed of no events."""

    def following(self, number: int) -> int | None:
        return number

    def due(self, number: int, after: float, upto: float) -> list[Told]:
        return []


async def sent(sink: Sink, layout: Layout, seconds: float) -> Tally:
    """Sends frames for so long, as a run does."""
    loop = Loop(Waves(layout), WallClock(), Nothing(), [sink])
    await loop.play(seconds)
    return loop.tally
