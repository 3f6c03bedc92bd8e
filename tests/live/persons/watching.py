"""A made-up camera, late and trembling, and a face that looks at whom it sees, frame by frame, as in a run."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import atan2, degrees
from pathlib import Path

import numpy as np
from gazing import face, film, request, score
from numpy.typing import NDArray
from scripted import Letters

from facescript.compile import compile_source
from facescript.ir.values import AtCamera, AtTarget, Point
from facescript.live.model import Happening, Sighting
from facescript.live.persons.ahead import next_shift
from facescript.live.persons.persons import Persons
from facescript.live.run.run import Run
from facescript.motion.gaze.track import GazeTrack, eyes, midline
from facescript.space.planner import GazeRequest
from facescript.space.room import Room
from facescript.text import Source
from facescript.world import World

Floats = NDArray[np.float64]

People = dict[str, "Truth"]
Truth = Callable[[float], tuple[float, float] | None]
"""Where a person is at a time: cm to the viewer's right of the face, and from the screen; None while she is unseen."""

EYES = Room(film(), [face()], []).point("ada", AtCamera(), 0.0).y
FPS = 60.0
VISITOR = "person 1"


@dataclass(frozen=True)
class Camera:
    """Pictures a second, how old they are when they are told of (s, between), and how far off places are from side to
    side (cm) and in depth (as a part of it): a face box of a fifth of a degree and three parts in a hundred."""

    rate: float = 30.0
    delay: tuple[float, float] = (0.03, 0.1)
    noise: float = 0.4
    depth: float = 0.03
    seed: int = 1

    def sightings(self, people: Mapping[str, Truth], seconds: float) -> list[tuple[float, Sighting]]:
        """What it tells, by when it does."""
        rng = np.random.default_rng(self.seed)
        usual = rng.uniform(*self.delay)
        told = []
        for time in np.arange(0.02, seconds, 1.0 / self.rate).tolist():
            late = float(np.clip(usual + rng.normal(0.0, 0.012), *self.delay))
            for person, truth in people.items():
                place = truth(time)
                if place is not None:
                    told.append((time + late, Sighting(person, time, self._off(rng, *place))))
        return sorted(told, key=lambda one: one[0])

    def _off(self, rng: np.random.Generator, x: float, z: float) -> Point:
        far = 1.0 + rng.normal(0.0, self.depth)
        return Point((x + rng.normal(0, self.noise)) * far, (EYES + rng.normal(0, self.noise)) * far, z * far)


@dataclass(frozen=True)
class Watched:
    """Frames of a face that looks at persons: where gaze and head point (yaw, deg), and gaze's pitch."""

    times: Floats
    gaze: Floats
    pitch: Floats
    head: Floats

    def part(self, start: float, end: float = np.inf) -> Watched:
        inside = (self.times >= start) & (self.times < end)
        return Watched(*(values[inside] for values in (self.times, self.gaze, self.pitch, self.head)))


class Watcher:
    """One face and the `people` that it sees. `requests` are its looks, at persons by their names; none is foreseen.
    Every few frames it `peeks` so far ahead, s."""

    def __init__(
        self, requests: Sequence[GazeRequest] | None = None, people: Sequence[str] = (VISITOR,), peeks: float = 0.0
    ) -> None:
        self.persons = Persons()
        for person in people:
            self.persons.target(person)
        self.requests = [request(0, AtTarget(VISITOR), 1.0)] if requests is None else requests
        self.peeks = peeks
        self._version, self._next = -1, 0.0
        self._track: GazeTrack

    def frames(self, told: Sequence[tuple[float, Sighting]], seconds: float, fps: float = FPS) -> Iterator[Floats]:
        """Each frame's row: time, gaze, pitch, head. So many frames are worked out at once as last a tenth of a second
        at most, for that is how far ahead following is certain."""
        waiting = list(told)[::-1]
        block: list[Floats] = []
        ahead = max(1, int(fps / 10.0))
        for number in range(int(seconds * fps)):
            time = number / fps
            while waiting and waiting[-1][0] <= time:
                self.persons.see(waiting.pop()[1])
            self.persons.pass_to(time)
            if self._version != self.persons.version or self._next <= time:
                self._plan(time)
                block = []
            if self.peeks and number % 4 == 0:
                looked(self._track, np.array([time + self.peeks]))
            if not block:
                block = list(looked(self._track, np.arange(number, number + ahead) / fps))[::-1]
            yield block.pop()

    def _plan(self, time: float) -> None:
        """Plan by what is known now; what hangs on persons once more when it begins, and no look before it does."""
        begun = [one for one in self.requests if one.onset <= time]
        known = score(self.persons.targets, begun, face(), film(), 1e6)
        onsets = (one.onset for one in self.requests if one.onset > time)
        self._version, self._next = self.persons.version, min([next_shift(known, time), *onsets])
        self._track = GazeTrack(known, face())

    def afresh(self) -> GazeTrack:
        """The same, of those who have never been followed."""
        targets = [replace(target, pursuits={}) for target in self.persons.targets]
        return GazeTrack(score(targets, self.requests, face(), film(), 1e6), face())


def watch(told: Sequence[tuple[float, Sighting]], seconds: float, watcher: Watcher | None = None) -> Watched:
    return Watched(*np.array(list((watcher or Watcher()).frames(told, seconds))).T)


def looked(track: GazeTrack, times: Floats) -> Floats:
    """array[n, 4]: times, yaw and pitch of gaze as drawn, yaw of the head, deg."""
    head = np.concatenate([track.head(times), np.zeros((len(times), 1))], axis=1)
    points = midline(eyes(track.sight(times), head), head)
    return np.stack([times, points[:, 0], points[:, 1], head[:, 0]], axis=1)


class Live:
    """A run of a script, and what comes to it by when."""

    def __init__(
        self, text: str, told: Sequence[tuple[float, Sighting]], events: Sequence[Happening], fps: float = FPS
    ) -> None:
        compiled = compile_source(Source("made.face", text), World(Path(__file__).parent), Letters())
        assert compiled.play is not None, [item.message for item in compiled.diagnostics]
        self.run, self.fps = Run(compiled.play, Letters(), fps), fps
        self.waiting = sorted([*told, *((event.time, event) for event in events)], key=lambda one: -one[0])

    def frames(self, seconds: float) -> Iterator[Floats]:
        for number in range(int(seconds * self.fps)):
            while self.waiting and self.waiting[-1][0] <= number / self.fps:
                _, what = self.waiting.pop()
                self.run.see(what) if isinstance(what, Sighting) else self.run.hear(what)
            yield self.run.frame(number).values

    def watch(self, seconds: float) -> dict[str, Floats]:
        values = np.array(list(self.frames(seconds))).T
        return {"time": np.arange(values.shape[1]) / self.fps, **dict(zip(self.run.layout.names, values, strict=True))}


def true_yaw(truth: Truth, times: Floats) -> Floats:
    """The direction in which a person really is, deg."""
    places = [truth(time) or (0.0, 1.0) for time in times.tolist()]
    return np.array([degrees(atan2(x, z)) for x, z in places])


def lag(gaze: Floats, true: Floats, most: float = 0.4, rate: float = FPS) -> float:
    """By how much (s) one course comes after another, where the two are most alike."""
    fine = 10
    times = np.arange((len(gaze) - 1) * fine) / fine
    one, other = (np.interp(times, np.arange(len(values)), values) for values in (gaze, true))
    shifts = range(int(-most / 2 * rate * fine), int(most * rate * fine))
    return max(shifts, key=lambda shift: _alike(one, other, shift)) / (rate * fine)


def _alike(one: Floats, other: Floats, shift: int) -> float:
    late, early = (one[shift:], other[: len(other) - shift]) if shift >= 0 else (one[:shift], other[-shift:])
    return float(np.corrcoef(late, early)[0, 1])
