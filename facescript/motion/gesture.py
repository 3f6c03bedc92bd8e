"""Turns nods, shakes, tilts, blinks and winks into what they ask of the head and lids at any time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.ir.acts import Gesture
from facescript.motion.drivers import BLINKS, ROWS, Drive, Floats, mix_column, number, rows
from facescript.performance.easing import Easing, fall_out, smooth, through
from facescript.schedule.score import TimedAct

_BLINKS = rows(BLINKS)

CLOSING, HELD = 0.28, 0.20
"""Shares of a blink's length: it closes, stays shut, and opens for the rest (28, 20, 52 %; `motion.md` 3.4)."""


def blink_profile(share: Floats) -> Floats:
    """How far a blink has shut (0..1) by the share of its length.

    It opens quickly first and slowly last (Kwon 2013), and its peak speed closing is 1.51 times the one opening (Sforza
    2008: 1.40 to 1.47; bar B4: 1.25 to 1.65).
    """
    opened = fall_out((share - CLOSING - HELD) / (1.0 - CLOSING - HELD))
    return smooth(share / CLOSING) * (1.0 - opened)


PROFILES: dict[str, Easing] = {
    "nod": through((0.0, 0.0), (0.36, 1.0), (0.74, -0.12), (1.0, 0.0)),
    "shake": through((0.0, 0.0), (0.19, 1.0), (0.44, -0.8), (0.66, 0.5), (0.84, -0.2), (1.0, 0.0)),
    "tilt": through((0.0, 0.0), (0.35, 1.0), (0.6, 1.0), (1.0, 0.0)),
    "blink": blink_profile,
    "wink": blink_profile,
}
"""Each gesture's share of its far pose by the share of its length: 0 at both ends, 1 at the far point. A nod goes down,
back, and a little over; a shake swings both ways and dies away; a tilt stays a moment."""


@dataclass(frozen=True, slots=True)
class Movement:
    """One gesture in time: seconds from the film's start, the rows it moves, and its far pose, array[len(rows)]."""

    start: float
    end: float
    rows: NDArray[np.intp]
    far: Floats
    profile: Easing
    act: TimedAct

    def at(self, times: Floats) -> Drive:
        """What it asks of its rows: array[len(rows), time]."""
        return self.far[:, None] * self.profile((times - self.start) / (self.end - self.start))


class Gestures:
    """The gestures among the acts of one face in one scene; those that overlap add up, and of blinks each shuts what
    the others leave open."""

    def __init__(self, acts: Iterable[TimedAct]) -> None:
        self.movements = tuple(movement(act, act.verb) for act in acts if isinstance(act.verb, Gesture))
        self._starts = np.array([item.start for item in self.movements])
        self._ends = np.array([item.end for item in self.movements])

    def at(self, times: Floats) -> Drive:
        """What they ask at `times` (sorted): array[row, time]."""
        drive = np.zeros((len(ROWS), len(times)))
        firsts = np.searchsorted(times, self._starts, side="right")
        lasts = np.searchsorted(times, self._ends, side="left")
        for index in np.flatnonzero(firsts < lasts):
            window = slice(firsts[index], lasts[index])
            item = self.movements[index]
            asked = item.at(times[window])
            shut = np.isin(item.rows, _BLINKS)
            asked[shut] = np.clip(asked[shut], 0.0, 1.0) * (1.0 - drive[item.rows[shut], window])
            drive[item.rows, window] += asked
        return drive


def movement(act: TimedAct, gesture: Gesture) -> Movement:
    """A gesture in time; `for T` is its length, its degree scales the far pose."""
    lasting = gesture.timing.lasting
    end = act.end if lasting is None else act.start + number(lasting)
    pose = number(gesture.degree) * mix_column(gesture.mix)
    moved = np.flatnonzero(pose)
    return Movement(act.start, end, moved, pose[moved], PROFILES[gesture.kind], act)
