"""One face's motion before and after an event to curves without a jump: what differs there is carried on, and fades.

What a face shows does not depend on what comes later, but for some of what it does unasked: life thinks before it
speaks, the mouth is on its way to a sound that is cut off. At an event the motion before it and the one after it are
both known; the difference there is added to the second, and taken back smoothly. Where nothing differs none is.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facescript.motion.compose import Asked
from facescript.motion.drivers import ROWS, Floats
from facescript.motion.recorded import Turned

FADING = 0.35
"""Seconds that a difference takes to fade at least."""

SPEEDS = {"sight": 150.0, "head": 60.0}
"""Degrees a second that a difference of the line of sight and of the head fades at most: with a saccade of 550 and a
head movement of 250 beside it, both stay below what eyes and heads do."""

PEAK = 1.875
"""The peak speed of a minimum-jerk movement over its mean speed."""

WIDTHS = {
    "expression": len(ROWS),
    "gestures": len(ROWS),
    "life": len(ROWS),
    "sight": 3,
    "head": 2,
    "spoken": 8,
    "taken": 7,
}
"""How many values each source asks, in the order of the rows here; `activity` is the last one. What is `taken` are the
turns of both eyes by recorded faces, and how far these have them."""

TURNING = ("head.yaw", "head.pitch", "head.roll")


def flat(asked: Asked) -> Floats:
    """All that the sources ask, array[value, time]; the eyes' distance as nearness, 1/cm."""
    sight = asked.sight.T.copy()
    sight[2] = 1.0 / sight[2]
    taken = np.zeros((7, len(asked.activity)))
    if asked.turned is not None:
        taken = np.concatenate([asked.turned.eyes.reshape(-1, 6).T, asked.turned.eye_share[None]])
    columns = [asked.expression, asked.gestures, asked.life, sight, asked.head.T, asked.spoken.T, taken]
    return np.concatenate([*columns, asked.activity[None]])


def asked_of(values: Floats) -> Asked:
    """What `flat` was made of."""
    edges = np.cumsum(list(WIDTHS.values()))
    expression, gestures, life, sight, head, spoken, taken, activity = np.split(values, edges)
    angles = sight.T.copy()
    angles[:, 2] = 1.0 / np.maximum(angles[:, 2], 1e-9)
    turned = Turned.of_eyes(taken[:6].T.reshape(-1, 2, 3), np.clip(taken[6], 0.0, 1.0)) if taken.any() else None
    return Asked(expression, gestures, life, angles, head.T, spoken.T, np.clip(activity[0], 0.0, 1.0), turned)


def _speeds() -> Floats:
    """How fast each value may fade, 1/s."""
    found = np.full(sum(WIDTHS.values()) + 1, np.inf)
    turns = [ROWS[name] for name in TURNING]
    for source in range(3):
        found[[source * len(ROWS) + row for row in turns]] = SPEEDS["head"]
        found[[source * len(ROWS) + ROWS[name] for name in ("gaze.yaw", "gaze.pitch")]] = SPEEDS["sight"]
    first = 3 * len(ROWS)
    found[first : first + 2], found[first + 3 : first + 5] = SPEEDS["sight"], SPEEDS["head"]
    return found


_SPEEDS = _speeds()


@dataclass(frozen=True, slots=True)
class Seam:
    """From `time` (s) on the values `rows` are off by `gaps` less and less, over `lasts` seconds each."""

    time: float
    rows: np.ndarray[tuple[int], np.dtype[np.intp]]
    gaps: Floats
    lasts: Floats

    @property
    def end(self) -> float:
        """When nothing is left of it."""
        return self.time + float(self.lasts.max(initial=0.0))

    def onto(self, values: Floats, times: Floats) -> None:
        """Add what is left of it at `times` to `values`, array[value, time]."""
        share = np.clip((times - self.time) / self.lasts[:, None], 0.0, 1.0)
        left = 1.0 - share * share * share * (10.0 + share * (6.0 * share - 15.0))
        values[self.rows] += self.gaps[:, None] * left * (times >= self.time)


def seam(time: float, before: Floats, after: Floats) -> Seam | None:
    """What carries the values array[value] before a moment over to those after it; None where they are the same."""
    gaps = before - after
    rows = np.flatnonzero(gaps)
    if not len(rows):
        return None
    lasts = np.maximum(FADING, PEAK * np.abs(gaps[rows]) / _SPEEDS[rows])
    return Seam(time, rows, gaps[rows], lasts)
