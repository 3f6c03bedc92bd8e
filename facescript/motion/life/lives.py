"""Turns the lives of a face in a scene into what they ask of every driver at any time."""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from facescript.ir.acts import Life, SetLife
from facescript.ir.values import Amount, Draw
from facescript.motion.dice import Dice
from facescript.motion.drivers import ROWS, Drive, Floats, number
from facescript.motion.life.blinks import blinks
from facescript.motion.life.brows import brows
from facescript.motion.life.ears import ears
from facescript.motion.life.eyes import eyes
from facescript.motion.life.head import head, nods
from facescript.motion.life.memory import Memory
from facescript.motion.life.model import Behaviour, Living, Moved
from facescript.motion.life.occasions import FIRST, Occasions
from facescript.motion.life.prosody import beats, melody
from facescript.performance.curves import Ramp
from facescript.schedule.score import TimedAct, TimedLine

BEHAVIOURS: tuple[Behaviour, ...] = (blinks, brows, ears, head, nods, beats, melody, eyes)
"""All that a living face does unasked; a behaviour without its knob does nothing."""

QUIETING = 0.4
"""Seconds that an old life takes at least to come to rest: a head does not jump."""


@dataclass(frozen=True, slots=True)
class Spell:
    """One life from its start until it has faded away."""

    name: str
    start: float
    end: float
    fades: tuple[Ramp, Ramp]
    moves: tuple[Moved, ...]

    def weight(self, times: Floats) -> Floats:
        return self.fades[0].at(times) * (1.0 - self.fades[1].at(times))

    def drive(self, times: Floats, drive: Drive) -> None:
        """Add what it asks at `times` to `drive`, array[row, time]."""
        weight = self.weight(times)
        for item in self.moves:
            values = item.curve.at(times) * weight
            for row, gain in item.gains:
                drive[row] += gain * values


class Lives:
    """What the lives of one face in one scene ask."""

    def __init__(self, spells: Sequence[Spell], occasions: Occasions) -> None:
        self.spells, self.occasions = tuple(spells), occasions

    def at(self, times: Floats) -> Drive:
        """What they ask at `times` (sorted): array[row, time]; rows `gaze.*` move the line of sight."""
        drive = np.zeros((len(ROWS), len(times)))
        for spell in self.spells:
            window = slice(*np.searchsorted(times, [spell.start, spell.end]))
            if window.start < window.stop:
                spell.drive(times[window], drive[:, window])
        return drive


def lives(
    first: Life,
    acts: Sequence[TimedAct],
    lines: Sequence[TimedLine],
    start: float,
    end: float,
    dice: Dice,
    channels: tuple[str, ...],
    memory: Memory | None = None,
) -> Lives:
    """The lives of a face in a scene from `start` to `end` seconds: `first`, and what its `life` statements say after.

    `acts` and `lines` are the face's own in the scene, in time order; `channels` are what it can move. With a `memory`
    they are those since it began, and so is what comes of them.
    """
    occasions = Occasions(acts, lines, memory.earlier if memory else FIRST)
    if memory is not None:
        memory.begin(occasions)
    return Lives(tuple(_spells(first, acts, lines, start, end, dice, channels, occasions, memory)), occasions)


def _spells(
    first: Life,
    acts: Sequence[TimedAct],
    lines: Sequence[TimedLine],
    start: float,
    end: float,
    dice: Dice,
    channels: tuple[str, ...],
    occasions: Occasions,
    memory: Memory | None,
) -> Iterator[Spell]:
    changes = [(act.start, number(act.verb.over), act.verb.life) for act in acts if isinstance(act.verb, SetLife)]
    changes = [(start, 0.0, first), *changes]
    named = Counter(memory.earlier.lived) if memory else Counter()
    for (begun, over, life), (ended, fade, _) in pairwise([*changes, (end, 0.0, first)]):
        own = dice.at(life.name, named[life.name])
        named[life.name] += 1
        gone = ended + max(fade, QUIETING)
        if ended > begun and (memory is None or gone > memory.since):
            heard = _heard(lines, begun, ended)
            living = Living(life.name, _knobs(life, own), begun, ended, own, heard, occasions, channels, memory)
            moves = tuple(_by(behaviour, item) for behaviour in BEHAVIOURS for item in behaviour(living))
            yield Spell(life.name, begun, gone, (Ramp(begun, begun + over), Ramp(ended, gone)), moves)


def _by(behaviour: Behaviour, item: Moved) -> Moved:
    """A movement with the name of what makes it."""
    return replace(item, by=behaviour.__name__)


def _heard(lines: Sequence[TimedLine], start: float, end: float) -> Sequence[TimedLine]:
    """The lines from the last that begins by `start` to the first after `end`."""
    low = bisect_right(lines, start, key=lambda line: line.start)
    return lines[max(0, low - 1) : bisect_right(lines, end, key=lambda line: line.start) + 1]


def _knobs(life: Life, dice: Dice) -> dict[str, float]:
    """The knobs with their draws drawn."""
    return {name: _drawn(amount, dice, name) for name, amount in life.knobs}


def _drawn(amount: Amount, dice: Dice, name: str) -> float:
    if isinstance(amount, Draw):
        return dice.between(amount.low, amount.high, "knob", 0, name)
    return number(amount)
