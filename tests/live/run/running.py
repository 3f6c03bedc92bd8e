"""Plays that are run in tests: scripts with what happens to them, and the frames that come of it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray
from scripted import Letters

from facescript.diagnostics.model import Diagnostics
from facescript.ir.play import Play
from facescript.live.model import Happening
from facescript.live.run.run import Run
from facescript.resolve.resolver import resolve
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

Floats = NDArray[np.float64]

FPS = 60.0

HEAD = """film 640x360, seed {seed}
face ada = woman
    life {life}
target lamp at 25deg 10deg 2m
target crowd of (-60cm 0cm 2m) (0cm 5cm 2m) (50cm 10cm 2m)
target ann moves
    0s -80cm 0cm 2m
    4s   0cm 0cm 1m
    9s  90cm 0cm 2m
"""


class Whole(Run):
    """A run that forgets nothing."""

    def _forget(self, time: float) -> None:
        pass


def play_of(text: str) -> Play:
    told = Diagnostics()
    play = resolve(parse(Source("made.face", text), told), World(Path(__file__).parent), told)
    assert play is not None, [item.message for item in told]
    return play


def running(text: str, events: Iterable[Happening] = (), kind: type[Run] = Run, fps: float = FPS) -> Run:
    """A run of a script that has heard some events already."""
    run = kind(play_of(text), Letters(), fps)
    for event in sorted(events, key=lambda one: one.time):
        run.hear(event)
    return run


def rows(run: Run, seconds: float, first: int = 0) -> Floats:
    """The values of all frames up to a time, array[frame, channel]."""
    return np.array([run.frame(number).values for number in range(first, int(seconds * run.layout.fps))])


def speeds(run: Run, values: Floats, *names: str) -> float:
    """The fastest that channels with these names move from frame to frame, a second."""
    columns = [index for index, name in enumerate(run.layout.names) if name in names]
    return float(np.abs(np.diff(values[:, columns], axis=0)).max(initial=0.0) * FPS)


# ------------------------------------------------------------------------------------------------ made at random

LIVES = ("still", "calm", "conversation", "announcer", "reading")

DEEDS = (
    "look at lamp for 900ms", "look at ann", "look left 20deg, eyes only", "look at crowd.2, head only",
    "glance crowd.3", "scan crowd, 400ms each", "scan people, 300ms each", "look away", "show smile 20% to 90%",
    "show frown 80% for 1s", "show neutral", "add AU4 30% for 700ms", "add brow.outer 20%", "drop AU4", "drop smile",
    "nod 20% to 60%", "blink", "wait 300ms to 900ms", 'say "one two three"', 'say "hello there my friend"',
)  # fmt: skip

deeds = st.sampled_from(DEEDS)


def block(lines: Sequence[str], depth: int) -> str:
    return "".join(f"{'    ' * depth}{line}\n" for line in lines)


@st.composite
def scripts(draw: st.DrawFn, deed: st.SearchStrategy[str] = deeds) -> str:
    """A scene that goes on for ever, another before it now and then, and reactions to `heard "0"` to `"3"`."""
    text = HEAD.format(seed=draw(st.integers(0, 99)), life=draw(st.sampled_from(LIVES)))
    if draw(st.booleans()):
        text += "scene before:\n" + block(draw(st.lists(deed, min_size=1, max_size=4)), 1)
    text += "scene main:\n    repeat forever:\n" + block([*draw(st.lists(deed, min_size=1, max_size=4)), "wait 1s"], 2)
    for number in range(4):
        ending = draw(st.sampled_from(["resume", "resume", "resume", "restart"]))
        text += f'when heard "{number}":\n' + block([*draw(st.lists(deed, min_size=1, max_size=3)), ending], 1)
    return text + "event ann arrives at 1s\n"


@st.composite
def happenings(draw: st.DrawFn, most: int, until: float) -> list[Happening]:
    """Events at any times, those that come and go among them."""
    kinds = st.sampled_from([*(("heard", str(number), None) for number in range(4)), ("arrives", "", "ann")])
    times = draw(st.lists(st.integers(1, int(until * 100)), min_size=1, max_size=most, unique=True))
    made = ((draw(kinds), time / 100) for time in sorted(times))
    return [Happening(kind, time, text, person) for (kind, text, person), time in made]
