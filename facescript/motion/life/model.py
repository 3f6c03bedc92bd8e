"""What the behaviours of a life have in common: what they know of their scene, and the movements they make of it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import inf
from typing import TypeVar

import numpy as np

from facescript.motion.dice import Dice, Event, Waits, events
from facescript.motion.drivers import ROWS, Floats
from facescript.motion.life.fixations import Fixations
from facescript.motion.life.memory import Memory
from facescript.motion.life.occasions import Occasions
from facescript.motion.life.stations import ANNOUNCER, STATIONS, Station
from facescript.performance.curves import Curve, Pulses, Steps
from facescript.performance.easing import Easing, smooth
from facescript.schedule.score import TimedLine
from facescript.speech.sound.accents import heard

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Living:
    """One life of one face from `start` to `end` (seconds from the film's start) in a scene.

    `knobs` are in base units (`ir.acts.Life`), `lines` are the face's own about that time, `occasions` what
    lives heed of the whole scene, `channels` what the face can move. In a run it goes on from its `memory`.
    """

    preset: str
    knobs: dict[str, float]
    start: float
    end: float
    dice: Dice
    lines: Sequence[TimedLine]
    occasions: Occasions
    channels: tuple[str, ...]
    memory: Memory | None = None

    @property
    def since(self) -> float:
        """From when on it is asked what it does."""
        return self.start if self.memory is None else max(self.start, self.memory.since)

    def knob(self, name: str) -> float:
        """A knob, 0 where the life has none of it."""
        return max(0.0, self.knobs.get(name, 0.0))

    @property
    def announcing(self) -> bool:
        """Whether it moves by the statistics of newsreaders."""
        return self.preset in STATIONS

    @property
    def station(self) -> Station:
        """The newsreaders' statistics that it moves by, or takes single ones from."""
        return STATIONS.get(self.preset, ANNOUNCER)


@dataclass(frozen=True, slots=True)
class Moved:
    """A curve and what it moves: the rows of a drive, and how much of the curve each takes. `by` is its behaviour."""

    curve: Curve | Fixations
    gains: tuple[tuple[int, float], ...]
    by: str = ""


Behaviour = Callable[[Living], Iterable[Moved]]
"""Turns a life into movements: nothing where its knob is 0."""


def moved(curve: Curve | Fixations, **gains: float) -> Moved:
    """A curve on drivers by name, a dot written as `_`."""
    return Moved(curve, tuple((ROWS[name.replace("_", ".")], gain) for name, gain in gains.items()))


def pulses(found: Iterable[Event], height: Callable[[int], float], profile: Easing) -> Pulses:
    """Movements there and back, `height(k)` high."""
    kept = tuple(found)
    starts, lengths = _columns(kept)
    return Pulses(starts, lengths, np.array([height(event.index) for event in kept]), profile)


def steps(found: Iterable[Event], pose: Callable[[int], float], ease: Easing = smooth) -> Steps:
    """Movements from pose to pose, `pose(k)` at the end of event k."""
    kept = tuple(found)
    starts, lengths = _columns(kept)
    return Steps(starts, lengths, np.array([pose(event.index) for event in kept]), ease)


def going_on(life: Living, behaviour: str, gaps: Waits, lengths: Waits) -> Iterator[Event]:
    """The events of a life, each after a gap from the end of the one before; in a run from the last that was before."""
    last = life.memory.state(life.dice, behaviour) if life.memory else None
    for event in events(life.start, life.end, gaps, lengths, last):
        if life.memory is not None:
            life.memory.note(life.dice, behaviour, event.start, event)
        yield event


def _columns(found: Sequence[Event]) -> tuple[Floats, Floats]:
    starts = np.array([event.start for event in found])
    return starts, np.array([event.end - event.start for event in found])


@dataclass(frozen=True, slots=True)
class Accented:
    """An accent of a face's speech: its line's name and its number in the line, seconds from the film's start, and its
    strength in 0..1."""

    line: str
    index: int
    time: float
    strength: float


def said(life: Living) -> Iterator[tuple[str, TimedLine]]:
    """The lines of a face that sound in its life, each with a name for draws: its words, and how often they were said
    before. So draws stay as they are when the script changes elsewhere."""
    for line, (text, before) in life.occasions.lines(life.start, life.end):
        yield f"{text} {before}", line


def remember(life: Living, behaviour: str, line: str, found: list[T]) -> None:
    """What a behaviour `found` in the lines before one of them: in a run the last of it, where they are told of no
    more."""
    if life.memory is not None:
        if not found:
            found += life.memory.state(life.dice, f"{behaviour} {line}") or ()
        life.memory.note(life.dice, f"{behaviour} {line}", -inf, tuple(found[-1:]))


def accents(life: Living, name: str, line: TimedLine) -> tuple[Accented, ...]:
    """The accents of a line that sound in a life, in time order."""
    return tuple(
        Accented(name, index, line.start + accent.time, accent.strength)
        for index, accent in enumerate(heard(line.spoken).accents)
        if life.start <= line.start + accent.time < min(line.end, life.end)
    )
