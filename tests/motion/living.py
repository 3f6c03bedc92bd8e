"""Lives by their knobs or their names, and what is seen of them."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np
from performing import Floats, channels, grid, line, performed

from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Life
from facescript.performance.limits import gaze_on_lid
from facescript.resolve.resolver import resolve
from facescript.schedule.score import TimedLine
from facescript.speech.model import WordTime
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

MINUTES = 10.0
LONG = MINUTES * 60.0
PRESETS = (
    "still", "calm", "reading", "conversation", "announcer", "announcer-ctn", "announcer-ettoday", "announcer-other"
)  # fmt: skip


def life(**knobs: float) -> Life:
    return Life("calm", tuple(knobs.items()))


@cache
def preset(written: str) -> Life:
    """A life as an author writes it: `calm, blink 8/min`."""
    script = parse(Source("made.face", f"face ada = woman\n    life {written}\nada: blink\n"), Diagnostics())
    play = resolve(script, World(Path(mkdtemp(prefix="facescript-empty-"))), Diagnostics(), {})
    assert play is not None
    return play.faces[0].life


def lived(
    what: Life, duration: float = LONG, rate: float = 60.0, lines: tuple[TimedLine, ...] = ()
) -> dict[str, Floats]:
    return channels(performed(duration=duration, life=what, lines=lines), grid(duration, rate))


def stretches(moving: Floats, rate: float = 60.0) -> Floats:
    """Start and end (s) of every stretch in which something is so: array[stretch, 2]."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], moving, [False]]).astype(int)))
    return edges.reshape(-1, 2) / rate


def lid(drawn: dict[str, Floats]) -> Floats:
    """How far the left lid has shut but for what it follows of the eye."""
    return 1.0 - (1.0 - drawn["lid.left"]) / gaze_on_lid(drawn["eye.left.pitch"])


def blinked(drawn: dict[str, Floats], rate: float = 60.0) -> Floats:
    """Start and end of every blink."""
    return stretches(lid(drawn) > 0.02, rate)


def far_off(drawn: dict[str, Floats]) -> Floats:
    """How far the line of sight is from the camera, deg."""
    return np.hypot(drawn["gaze.yaw"], drawn["gaze.pitch"])


def jumps(drawn: dict[str, Floats], rate: float = 1000.0, fast: float = 6.0) -> Floats:
    """Start, end (s) and size (deg) of every saccade: where gaze is faster than `fast` deg/s; array[saccade, 3]."""
    yaw, pitch = drawn["gaze.yaw"], drawn["gaze.pitch"]
    found = stretches(np.hypot(np.diff(yaw), np.diff(pitch)) * rate > fast, rate)
    ends = np.rint(found * rate).astype(int)
    sizes = [np.hypot(yaw[last] - yaw[first], pitch[last] - pitch[first]) for first, last in ends]
    return np.column_stack([found, sizes])


def talk(start: float, seconds: float, text: str = "") -> TimedLine:
    """Speech with a pause of 0.3 s after every 2 s."""
    phrase = [("m", 0.1), ("a", 0.1)] * 10 + [("", 0.3)]
    spoken = line(start, *(phrase * round(seconds / 2.3)))
    return worded(spoken, text) if text else spoken


def worded(spoken: TimedLine, text: str) -> TimedLine:
    """The line with a text, by which its draws are known."""
    words = (WordTime(text, 0, len(text), 0.0, spoken.spoken.duration),)
    return replace(spoken, spoken=replace(spoken.spoken, words=words))


def gaps(found: Floats) -> Floats:
    return found[1:, 0] - found[:-1, 1]


def lengths(found: Floats) -> Floats:
    return found[:, 1] - found[:, 0]
