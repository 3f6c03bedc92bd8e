"""How a person who is seen live is followed: the steps of a pursuit, worked out as they come and kept for a while.

A step looks at the person as she was 130 ms before, so that what is shown now hangs on nothing that is still to come.
Steps that were worked out further ahead than that are worked out again when more is known.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import deque
from collections.abc import Callable
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from facescript.motion.gaze.curves import saccade_curve
from facescript.motion.gaze.pursuit import (
    HEAD,
    NEARNESS,
    PLACE,
    PURSUIT_STEPS,
    STEP,
    WIDTH,
    Pair,
    Pursuit,
    Spell,
    State,
    below_the_top,
)
from facescript.space.live import LiveTarget
from facescript.space.reach import Direction
from facescript.space.room import Sight
from facescript.space.trail import Trail

Floats = NDArray[np.float64]

KEPT = 6000
"""Steps that are kept: 30 s, for hair looks back so far."""

FIRST_ROWS = 512

MARKS = 128
"""As many states are kept to go back to."""

FORGOTTEN = 60.0
"""A pursuit that nobody has asked for in so many seconds is forgotten."""

Key = tuple[object, ...]


def followed(target: LiveTarget, key: Key, spell: Spell, begin: Callable[[], LiveFollowing]) -> LiveFollowing:
    """The pursuit of a target that bears a key, taken up again where it was left; or begun, where there is none."""
    known = target.pursuits.get(key)
    if not isinstance(known, LiveFollowing):
        for other, old in list(target.pursuits.items()):
            if isinstance(old, LiveFollowing) and old.asked < spell.start - FORGOTTEN:
                del target.pursuits[other]
        known = target.pursuits[key] = begin()
    known.taken(spell)
    return known


class LiveFollowing:
    """As `pursuit.Following`, without an end. It is a function of what the trail says: it does not matter which times
    are asked for, nor in what order, so long as none is more than 30 s before the last."""

    def __init__(
        self,
        trail: Trail,
        sight: Callable[[float], Sight],
        head_goal: Callable[[Direction], Direction],
        spell: Spell,
    ) -> None:
        self.trail, self.pursuit = trail, Pursuit(sight, head_goal, spell)
        self.start = self.asked = spell.start
        self._rows = np.empty((FIRST_ROWS, WIDTH))
        self._base = self._count = self._firm = 0
        self._learned = trail.learned
        self._marks: deque[tuple[int, State]] = deque([(0, self.pursuit.state())], MARKS)
        self._saccades: list[tuple[float, float, Pair]] = []
        self._jumped: Pair = (0.0, 0.0)

    def taken(self, spell: Spell) -> None:
        """The eyes, or the head, are taken elsewhere at another time than was known before."""
        before = self.pursuit.spell
        if spell != before:
            changed = min(spell.eyes_until, spell.head_until, before.eyes_until, before.head_until)
            self._back_to(int(max(0.0, changed - self.start) / STEP))
            self.pursuit.taken(spell)

    def eyes(self, times: Floats) -> Floats:
        """Yaw and pitch of the line of sight: array[n, 2]."""
        values = self._course(times, PLACE)
        values += self._leapt(times)
        values[:, 1] = below_the_top(values[:, 1])
        return values

    def head(self, times: Floats) -> Floats:
        return self._course(times, HEAD)

    def nearness(self, times: Floats) -> Floats:
        return self._course(times, NEARNESS)

    # ------------------------------------------------------------------------------------------------ what is asked

    def _course(self, times: Floats, part: slice) -> Floats:
        """The smooth course through the steps, array[n, k], as `curves.through` has it; still before the first."""
        place = np.maximum((times - self.start) / STEP, 0.0)
        index = place.astype(np.int64)
        if len(times):
            self._reach(int(index[-1]) + 3, float(times[-1]))
        index = np.maximum(index, self._base + 1 if self._base else 0)
        u, rows = np.maximum(place - index, 0.0)[:, None], self._rows[:, part]
        at = index - self._base
        low, high = rows[at], rows[at + 1]
        rise = np.where(index[:, None] > 0, (high - rows[np.maximum(at - 1, 0)]) / 2.0, 0.0)
        out: Floats = low + (high - low) * u * u * (3.0 - 2.0 * u)
        out += rise * u * (1.0 - u) ** 2 - (rows[at + 2] - low) / 2.0 * u * u * (1.0 - u)
        return out

    def _leapt(self, times: Floats) -> Floats:
        """How far catch-up saccades have brought the eyes, array[n, 2]."""
        x, y = zip(self._jumped, *(way for _, _, way in self._saccades), strict=True)
        sums = np.array([list(accumulate(x)), list(accumulate(y))]).T
        dones = [done for _, done, _ in self._saccades]
        number = np.searchsorted(dones, times, side="right")
        values: Floats = sums[number]
        for onset, done, way in self._saccades[number[0] : number[-1] + 1] if len(times) else ():
            under_way = (times > onset) & (times < done)
            values[under_way] += saccade_curve(times[under_way], onset, done)[:, None] * np.array(way)
        return values

    # ------------------------------------------------------------------------------------------------ the steps

    def _reach(self, count: int, time: float) -> None:
        """Work out `count` steps at least, by what is known now."""
        self.asked = max(self.asked, time)
        if self._learned != self.trail.learned:
            self._learned = self.trail.learned
            self._back_to(self._firm)
        self._firm = max(self._firm, min(self._certain(), max(count, self._count)))
        for until in (min(count, self._firm), count):
            if until > self._count:
                self._run(until - self._count)

    def _certain(self) -> int:
        """How many steps hang on nothing that is still to be learned."""
        certain = int((self.trail.final - self.start) / STEP) if self.trail.final > self.start else 0
        return certain + PURSUIT_STEPS if certain >= self.pursuit.first else min(certain, self.pursuit.first)

    def _run(self, count: int) -> None:
        self._make_room(count)
        row = self._count - self._base
        leaves = self._count <= self.pursuit.first < self._count + count
        self._rows[row : row + count] = self.pursuit.run(self._count, count)
        if leaves and self._base == 0:
            self._rows[: self.pursuit.first, PLACE] = self._rows[self.pursuit.first, PLACE]
        self._count += count
        self._note_saccades()
        self._marks.append((self._count, self.pursuit.state()))

    def _note_saccades(self) -> None:
        eyes = self.pursuit.eyes
        if eyes is not None:
            last = self._saccades[-1][0] if self._saccades else -np.inf
            self._saccades += [saccade for saccade in eyes.saccades if saccade[0] > last]
            del eyes.saccades[:-1]

    def _back_to(self, step: int) -> None:
        """Forget the steps from `step` on, and some before it."""
        if step >= self._count:
            return
        while len(self._marks) > 1 and self._marks[-1][0] > step:
            self._marks.pop()
        self._count, state = self._marks[-1]
        self.pursuit.turn_to(state)
        self.pursuit.taken(self.pursuit.spell)
        self._firm = min(self._firm, self._count)
        time = self.start + self._count * STEP
        self._saccades = self._saccades[: bisect_left(self._saccades, time, key=lambda saccade: saccade[0])]

    def _make_room(self, count: int) -> None:
        """Room for more rows; those that nobody asks for any more make way."""
        used = self._count - self._base
        if used + count <= len(self._rows):
            return
        kept = min(used, KEPT)
        rows = np.empty((max(2 * (kept + count), FIRST_ROWS), WIDTH))
        rows[:kept] = self._rows[used - kept : used]
        self._rows, self._base = rows, self._count - kept
        self._forget_saccades(self.start + self._base * STEP)

    def _forget_saccades(self, before: float) -> None:
        done = bisect_left(self._saccades, before, key=lambda saccade: saccade[1])
        for _, _, (x, y) in self._saccades[:done]:
            self._jumped = self._jumped[0] + x, self._jumped[1] + y
        del self._saccades[:done]
