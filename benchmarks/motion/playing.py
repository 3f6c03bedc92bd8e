"""A script's text to what its faces do: every channel at any rate, through the same compiler as an author's."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import atan2, degrees, hypot
from pathlib import Path
from typing import TypeVar

import numpy as np
from bars import Floats, Trace, eye_extremes

from facescript.compile import compile_source
from facescript.ir.play import Play
from facescript.ir.values import Aim, AtCamera
from facescript.motion.perform import perform
from facescript.performance.channels import INDEX
from facescript.performance.performance import Performance
from facescript.schedule.score import Score
from facescript.space.room import Room, towards
from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.model import VoiceBox
from facescript.text import Source
from facescript.world import World

RATE = 1000.0
"""Samples a second of a trace, unless a measure says otherwise."""

BLOCK = 60.0
"""Seconds of a long trace sampled at once."""

Place = tuple[float, float]
"""Yaw (+ the viewer's right) and pitch (+ up), deg."""

Made = TypeVar("Made")


class CannotPlay(Exception):
    """A script that does not compile; `args[0]` is what the compiler says."""


@dataclass
class Studio:
    """Where scripts are played: the voice, what was made once for several measures, and how far any eye turned in
    all traces so far (deg, bar S8)."""

    voice: VoiceBox = field(default_factory=open_voice)
    extremes: dict[str, float] = field(default_factory=lambda: {"yaw": 0.0, "up": 0.0, "down": 0.0})
    _made: dict[Callable[..., object], object] = field(default_factory=dict)

    def play(self, text: str) -> Playing:
        """The script performed. Raises `CannotPlay`."""
        compiled = compile_source(Source("bars.face", text), World(Path.cwd()), self.voice)
        if compiled.play is None or compiled.score is None:
            faults = compiled.diagnostics.items
            raise CannotPlay(f"{faults[0].code}: {faults[0].message}" if faults else "nothing to play")
        return Playing(self, compiled.play, compiled.score)

    def once(self, make: Callable[[Studio], Made]) -> Made:
        """What `make` makes, made once."""
        if make not in self._made:
            self._made[make] = make(self)
        return self._made[make]  # type: ignore[return-value]

    def saw(self, trace: Trace) -> None:
        for side, furthest in eye_extremes(trace).items():
            self.extremes[side] = max(self.extremes[side], furthest)


@dataclass
class Playing:
    """A script that was performed."""

    studio: Studio
    play: Play
    score: Score

    @cached_property
    def performance(self) -> Performance:
        return perform(self.score)

    @property
    def duration(self) -> float:
        return self.score.duration

    def sight(self, face: str, aim: Aim) -> Place:
        """Where a face looks when it looks at something that stays, deg."""
        seen = Room(self.score.film, self.score.faces, self.score.targets).sight(face, aim, 0.0)
        return seen.yaw, seen.pitch

    def trace(self, start: float, end: float, rate: float = RATE, face: str = "") -> Trace:
        """Every channel of a face (the first unless named) from `start` to `end` seconds."""
        times = start + np.arange(round((end - start) * rate)) / rate
        name = face or next(iter(self.performance.faces))
        poses = self.performance.sample_face(name, times)
        trace = Trace(times, dict(zip(INDEX, poses.T, strict=True)))
        self.studio.saw(trace)
        return trace

    def long(self, names: Sequence[str], rate: float, face: str = "") -> Trace:
        """Some channels over the whole film."""
        parts = [self.trace(start, end, rate, face) for start, end in _blocks(self.duration)]
        times = np.concatenate([part.times for part in parts])
        return Trace(times, {name: np.concatenate([part.channels[name] for part in parts]) for name in names})


def _blocks(duration: float) -> Iterator[tuple[float, float]]:
    for start in np.arange(0.0, duration, BLOCK):
        yield float(start), float(min(start + BLOCK, duration))


def script(*lines: str, life: str = "still", film: str = "", face: str = "") -> str:
    """A script of one woman on a screen that does not exaggerate."""
    more = f"    {face}\n" if face else ""
    return f"film screen none{film}\nface ada = woman\n    life {life}\n{more}" + "\n".join(lines) + "\n"


def towards_words(place: Place) -> str:
    """A direction as `look` takes it: left is the face's own, so it is the viewer's right."""
    yaw, pitch = place
    side, height = "left" if yaw >= 0 else "right", "up" if pitch >= 0 else "down"
    return f"{side} {abs(yaw):.4f}deg {height} {abs(pitch):.4f}deg"


def place_words(place: Place, distance_cm: float, height_cm: float) -> str:
    """The place that a face whose eyes are `height_cm` above the picture's middle sees in a direction."""
    x, y, z = (part * distance_cm for part in towards(*place))
    return f"{x:.4f}cm {y + height_cm:.4f}cm {z:.4f}cm"


def eye_height(studio: Studio) -> float:
    """How far above the picture's middle the eyes of `script`'s face are, cm."""
    score = studio.play(script("wait 1s")).score
    return Room(score.film, score.faces, ()).point("ada", AtCamera(), 0.0).y


@dataclass(frozen=True)
class Shift:
    """One gaze shift: what was seen of it, when it begins (s), and where it starts and ends (deg)."""

    seen: Trace
    onset: float
    start: Place
    end: Place

    @cached_property
    def trace(self) -> Trace:
        """The trace turned so that its yaw is along the shift's way."""
        return turned_trace(self.seen, self.way)

    @property
    def size(self) -> float:
        return hypot(self.end[0] - self.start[0], self.end[1] - self.start[1])

    @property
    def way(self) -> float:
        """Its direction, deg from the viewer's right, counted up."""
        return degrees(atan2(self.end[1] - self.start[1], self.end[0] - self.start[0]))

    @property
    def target(self) -> float:
        """Where it is bound for, along its way."""
        way = np.radians(self.way)
        return float(self.end[0] * np.cos(way) + self.end[1] * np.sin(way))


def shifts(
    studio: Studio, pairs: Sequence[tuple[Place, Place]], manner: str = "", rest: float = 1.5, rate: float = RATE,
    face: str = ""
) -> list[Shift]:  # fmt: skip
    """Looks from the first place of each pair to the second, each begun `rest` seconds after the one before."""
    more = f", {manner}" if manner else ""
    places = [place for pair in pairs for place in pair]
    lines = [
        f"at {number * rest:.4f}s: look {towards_words(place)}{more}" for number, place in enumerate(places, start=1)
    ]
    playing = studio.play(script(*lines, f"wait {(len(lines) + 2) * rest:.4f}s", face=face))
    found = []
    for index, (start, end) in enumerate(pairs):
        onset = (2 * index + 2) * rest
        found.append(Shift(playing.trace(onset - 0.05, onset + rest - 0.01, rate), onset, start, end))
    return found


def turned_trace(trace: Trace, way: float) -> Trace:
    """The trace with yaw and pitch of eyes, head and gaze along a direction (deg) and across it."""
    cosine, sine = np.cos(np.radians(way)), np.sin(np.radians(way))
    channels = dict(trace.channels)
    for name in ("head", "eye.left", "eye.right", "gaze"):
        yaw, pitch = trace.channels[f"{name}.yaw"], trace.channels[f"{name}.pitch"]
        channels[f"{name}.yaw"] = yaw * cosine + pitch * sine
        channels[f"{name}.pitch"] = pitch * cosine - yaw * sine
    return Trace(trace.times, channels)


def on_way(size: float, way: float) -> Place:
    """The place `size` deg from straight ahead in a direction (deg)."""
    return float(size * np.cos(np.radians(way))), float(size * np.sin(np.radians(way)))


def speed_of(trace: Trace, part: str) -> Floats:
    """The speed of eye, head or gaze, deg/s."""
    values = getattr(trace, part)
    return np.hypot(trace.speed(values("yaw")), trace.speed(values("pitch")))
