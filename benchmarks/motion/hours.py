"""Hours of simulated life: a face at rest, one that reads, and two that talk to each other."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np
from bars import Floats, Trace
from events import Blink, blink_at, shut_moments
from playing import Place, Playing, Studio

from facescript.ir.values import AtFace
from facescript.schedule.score import TimedLine

FINDING = 200.0
"""Samples a second of the trace on which events are found; each is then measured at 1000 Hz."""

NAMES = ("lid.left", "gaze.yaw", "gaze.pitch", "head.yaw", "head.pitch", "brow.inner.left")

PAUSE = 0.12
"""Silence inside a line that is a pause; shorter ones are closures of consonants, s."""

SENTENCES = (
    "I went down to the river this morning, | and there was nobody there at all.",
    "They say the old bridge will be closed, | but I would not believe it yet.",
    "Do you remember the man who sold us the boat?",
    "It took three days to paint the kitchen, | and then the rain came in.",
    "My sister has moved to the coast, | so we hardly ever meet.",
    "Nobody told me that the train was late.",
    "The children were asleep before we came home, | and the dog was hungry.",
    "What would you do with a garden like that?",
    "I have never seen so many people in one small room.",
    "He plays the piano every evening, | and I listen through the wall.",
    "We could walk along the harbour, | if the weather stays like this.",
    "She bought a blue coat, | and then she gave it away.",
    "Have you ever been to the mountains in winter?",
    "The baker on the corner has the best bread in town.",
)


@dataclass(frozen=True)
class Hour:
    """An hour of one face, its trace at `FINDING` Hz with the channels `NAMES`."""

    playing: Playing
    face: str
    trace: Trace

    @property
    def minutes(self) -> float:
        return self.playing.duration / 60

    def near(self, moment: float) -> Trace:
        """The trace about a moment at 1000 Hz."""
        return self.playing.trace(max(0.0, moment - 0.25), min(moment + 0.45, self.playing.duration), face=self.face)

    def shut(self) -> list[float]:
        """When each blink shuts the eye furthest, s."""
        return shut_moments(self.trace.times, self.trace.channels["lid.left"])

    def blinks(self) -> Iterator[tuple[Blink, Trace]]:
        """Every blink with the trace about it."""
        for moment in self.shut():
            near = self.near(moment)
            yield blink_at(near, moment), near

    def off(self, place: Place) -> Floats:
        """How far gaze is from a place, deg."""
        return np.hypot(self.trace.gaze("yaw") - place[0], self.trace.gaze("pitch") - place[1])


@cache
def alone(life: str) -> Callable[[Studio], Hour]:
    """Makes the hour of a face that is alone with a life and looks at the camera; the same for the same life."""
    return lambda studio: _hour(studio.play(ALONE.format(life=life)), "ada")


ALONE = "film screen none, seed 7\nface ada = woman\n    life {life}\nwait 3600s\n"


def _hour(playing: Playing, face: str) -> Hour:
    return Hour(playing, face, playing.long(NAMES, FINDING, face))


@dataclass(frozen=True)
class Talk:
    """An hour in which two faces look at each other and speak in turns."""

    playing: Playing
    hours: Mapping[str, Hour]

    @property
    def turns(self) -> list[TimedLine]:
        """The turns that are over before the film is."""
        lines = self.playing.score.lines
        return [line for line in lines if line.start + line.spoken.duration < self.playing.duration]

    def partner(self, face: str) -> Place:
        """Where a face looks when it looks at the other."""
        return self.playing.sight(face, AtFace("bruno" if face == "ada" else "ada"))

    def pauses(self) -> int:
        """Silences in the turns, and at their ends."""
        return sum(_pauses(turn) for turn in self.turns)


def talk(studio: Studio) -> Talk:
    playing = studio.play(_talk())
    return Talk(playing, {face: _hour(playing, face) for face in ("ada", "bruno")})


def _pauses(turn: TimedLine) -> int:
    phones = [phone for phone in turn.spoken.phones if phone.symbol]
    gaps = (after.start - before.end for before, after in pairwise(phones))
    return 1 + sum(gap >= PAUSE for gap in gaps)


TURNS = 420
"""Turns of an hour; the film is cut at its end."""


def _talk() -> str:
    lines = [
        "film 1280x720, screen none, seed 7, 3600s long",
        "face ada = woman, voice en-us female",
        "    life conversation",
        "face bruno = man, voice en-gb",
        "    life conversation",
        "together:",
        "    ada: look at bruno",
        "    bruno: look at ada",
    ]
    for turn in range(TURNS):
        texts = [SENTENCES[(3 * turn + step * (1 + turn % 4)) % len(SENTENCES)] for step in range(2 + turn % 3)]
        lines.append(f'{("ada", "bruno")[turn % 2]}: say "{" | ".join(texts)}"')
    return "\n".join(lines) + "\n"
