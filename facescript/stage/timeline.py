"""Acts that set something for a scene until the next one does: which of them weigh how much at a time."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np

from facescript.performance.easing import smooth
from facescript.schedule.score import Score, TimedAct

Kind = TypeVar("Kind")


@dataclass(frozen=True, slots=True)
class Change(Generic[Kind]):
    """From `start` to `settled` (seconds of the film) the picture becomes `value`."""

    start: float
    settled: float
    value: Kind

    def share(self, time: float) -> float:
        """How much of the change is done, 0..1, with minimum jerk."""
        if time >= self.settled:
            return 1.0
        done = (time - self.start) / (self.settled - self.start)
        return float(smooth(np.array([done]))[0])


class Timeline(Generic[Kind]):
    """Changes by scene; each scene begins at `first` again."""

    def __init__(self, score: Score, first: Kind, changes: Sequence[tuple[TimedAct, Kind]]) -> None:
        self._first = first
        self._starts = [scene.start for scene in score.scenes]
        self._changes: list[list[Change[Kind]]] = [[] for _ in score.scenes]
        for act, value in changes:
            self._changes[act.scene].append(Change(act.start, act.settled, value))

    def scene(self, time: float) -> int:
        """The number of the scene that a time falls in; a scene's end belongs to the next."""
        return max(0, bisect_right(self._starts, time) - 1)

    def layers(self, time: float) -> tuple[tuple[Kind, float], ...]:
        """What shows at a time, lowest first: each covers those before it by its share; the first share is 1."""
        layers: list[tuple[Kind, float]] = [(self._first, 1.0)]
        for change in self._changes[self.scene(time)] if self._starts else ():
            if change.start > time:
                break
            share = change.share(time)
            layers = [(change.value, 1.0)] if share >= 1.0 else [*layers, (change.value, share)]
        return tuple(layer for layer in layers if layer[1] > 0.0)
