"""Turns a life and what its face says into small turns of the head: nods on accents, and a way with F0 and energy."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from facescript.motion.dice import Event
from facescript.motion.drivers import Floats
from facescript.motion.life.model import Accented, Living, Moved, accents, moved, pulses, remember, said
from facescript.performance.curves import Spline
from facescript.performance.easing import through
from facescript.schedule.score import TimedLine
from facescript.speech.sound.accents import heard, loudness, semitones, smoothed
from facescript.speech.sound.prosody import HOP

BEAT = 3.0
"""How deep a nod on the strongest accent goes with `nods 100%`, deg (ours; heads of speakers turn a few: Graf 2002)."""

SHORTEST, LONGEST = 0.28, 0.5
"""Seconds of a nod on an accent (Hadar 1983: the quick movements of speech take 0.2 to 0.5 s)."""

RAREST = 0.3
"""How likely a nod on the faintest accent is; on the strongest it is certain (ours)."""

SHALLOWEST = 0.3
"""How deep a nod on the faintest accent is, as a part of the deepest (ours)."""

LOWEST = 0.45
"""The share of a nod's length after which the head is lowest: at the accent's peak."""

NOD = through((0.0, 0.0), (LOWEST, 1.0), (1.0, 0.0))

TURNS = {"yaw": (0.9, (-1.0, 1.0)), "pitch": (1.2, (0.6, 1.0)), "roll": (0.8, (-1.0, 1.0))}
"""How far the axes of the head go with F0 at `sway 100%`, deg, and the share of it that is drawn for each line (ours;
that they go together: Munhall 2004, bar L5). The head rises with the voice, and turns aside now so, now so."""

LOUD = 0.5
"""How far they go with energy, by as much as with F0 (ours)."""

SEMITONES, DECIBELS = 4.0, 10.0
"""How far from the line's middle F0 and energy are where the head has gone three quarters of its way."""

NEAR = 0.25
"""Seconds from the next voiced frame from which the head goes back to rest."""

EDGE = 0.5
"""Seconds around a line in which the head sets off and comes to rest."""

SLOWNESS = 0.08
"""Standard deviation in seconds of the smoothing: with the spline nothing is left above 3 Hz."""

SPACING = 0.1
"""Seconds between the knots of the curve that is left."""

LINGERS = 1.0
"""Seconds after a line in which something of its way may be left."""

RISE = 3
"""Knots after the start of a life from which the head moves: it sets off from rest."""


def beats(life: Living) -> Iterable[Moved]:
    """Small nods whose lowest point is an accent of the face's speech (knob `nods`); the announcer has none."""
    size = life.knob("nods")
    if size <= 0.0 or life.announcing:
        return
    found: list[tuple[Event, float]] = []
    for name, line in said(life):
        remember(life, "beats", name, found)
        for event, depth in _beats(life, accents(life, name, line)):
            if found and event.start < found[-1][0].end:
                event, depth = max(found.pop(), (event, depth), key=lambda one: one[1])
            found.append((event, depth))
    marks = (Event(index, event.start, event.end) for index, (event, _) in enumerate(found))
    yield moved(pulses(marks, lambda index: found[index][1], NOD), head_pitch=-size * BEAT)


def _beats(life: Living, accented: Iterable[Accented]) -> Iterator[tuple[Event, float]]:
    """The nods of one line and how deep they go in 0..1."""
    for accent in accented:
        name, dice = f"beats {accent.line}", life.dice
        if dice.chance(name, accent.index, "happens") < RAREST + (1.0 - RAREST) * accent.strength:
            length = dice.between(SHORTEST, LONGEST, name, accent.index, "length")
            start = accent.time - LOWEST * length
            depth = (SHALLOWEST + (1.0 - SHALLOWEST) * accent.strength) * dice.between(
                0.7, 1.0, name, accent.index, "depth"
            )
            if start >= life.start:
                yield Event(accent.index, start, start + length), depth


def melody(life: Living) -> Iterable[Moved]:
    """The head goes with F0 and energy while the face speaks (knob `sway`); the announcer's does not."""
    size = life.knob("sway")
    sounding = [(name, line) for name, line in said(life) if line.spoken.sound and line.end > life.since - LINGERS]
    if size <= 0.0 or life.announcing or not sounding:
        return
    first, last = (round(time / SPACING) for time in (sounding[0][1].start - EDGE, sounding[-1][1].end + EDGE))
    knots = np.zeros((len(TURNS), last - first + 1))
    for name, line in sounding:
        _lay(knots, first, line, np.array([_gains(life, name, axis) for axis in TURNS]))
    knots[:, : max(round(life.start / SPACING) + RISE - first, 0)] = 0.0
    for axis, values in zip(TURNS, knots, strict=True):
        yield moved(Spline(first * SPACING, SPACING, values), **{f"head_{axis}": size})


def _gains(life: Living, name: str, axis: str) -> tuple[float, float]:
    """Deg that an axis turns with the F0 and with the energy of a line."""
    reach, (low, high) = TURNS[axis]
    along, loud = (life.dice.between(low, high, f"melody {name}", 0, f"{axis} {what}") for what in ("f0", "energy"))
    return reach * along, reach * LOUD * loud


def _lay(knots: Floats, first: int, line: TimedLine, gains: Floats) -> None:
    """Add a line's turns, array[axis, 2] deg, to the knots, of which the first has the number `first`."""
    way = _way(line)
    begun, ended = line.start - EDGE, line.start + HOP * way.shape[1] - EDGE
    numbers = np.arange(round(begun / SPACING), round(ended / SPACING) + 1)
    numbers = numbers[(numbers >= first) & (numbers < first + knots.shape[1])]
    frames = (numbers * SPACING - begun) / HOP
    knots[:, numbers - first] += gains @ [np.interp(frames, np.arange(way.shape[1]), row) for row in way]


def _way(line: TimedLine) -> Floats:
    """The way of F0 and energy of a line in -1..1, 0 at its ends and in pauses: array[2, frame] with `EDGE` around."""
    found = heard(line.spoken).prosody
    edge, near = round(EDGE / HOP), round(NEAR / HOP)
    voiced = found.voiced & (np.arange(len(found.f0)) * HOP < line.end - line.start)
    if not voiced.any():
        return np.zeros((2, len(voiced) + 2 * edge))
    about = np.convolve(voiced, np.ones(2 * near + 1))[near : near + len(voiced)] > 0.5
    ways = [
        np.tanh((values - np.median(values[voiced])) / unit) * about
        for values, unit in ((semitones(found), SEMITONES), (loudness(found), DECIBELS))
    ]
    return np.array([smoothed(np.pad(way, edge), SLOWNESS) for way in ways])
