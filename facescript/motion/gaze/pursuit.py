"""A moving target to how eyes and head follow it: smooth pursuit, catch-up saccades, a head that comes after.

The model of motion.md section 4, run once on a fixed grid from the moment the look begins, so that what comes out is
a function of time. The eyes match the velocity seen 130 ms ago, carried on by its acceleration, with a gain that falls
with speed (bars P1, P2); where an error too large lasts another 50 ms they jump to where the target will be (bars P3,
S7).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import hypot, inf

import numpy as np
from numpy.typing import NDArray

from facescript.motion.gaze.curves import Course, saccade_curve, through
from facescript.space.main_sequence import HEAD_CEILING, PEAK_OVER_MEAN, saccade_part, saccade_time
from facescript.space.reach import Direction
from facescript.space.room import Sight

Floats = NDArray[np.float64]

STEP = 0.005
"""The grid, s."""

PURSUIT_STEPS, VERGENCE_STEPS = 26, 30
"""Delays of pursuit and of vergence (130 and 150 ms), in steps."""

BEFORE = VERGENCE_STEPS + 2
"""As many steps are looked back on when the following begins."""

VERGENCE_RATE = 15.0
"""How fast the eyes converge on what comes nearer (critically damped), 1/s: 5.5 deg/s for each degree, between the 4
to 5 of pure vergence and the 14 to 18 of a target that is seen to come (motion.md section 4)."""

DECIDING = 0.05
"""How long an error too large lasts before a saccade mends it, s: with the delay of sight, 180 ms after a jump."""

SMOOTHING = 0.03
"""Time constant with which the eyes take up a new velocity, s."""

FASTEST = 100.0
"""A target faster than this has jumped: no pursuit, a saccade only, deg/s."""

FORESEEN = 50.0
"""The acceleration that is carried on at most, deg/s^2: smooth motion is foreseen, a sudden start is not."""

CATCHING = 500.0
"""The fastest an eye catches up, deg/s: the head may turn against it, and both come to the end of reach."""

REST = 0.15
"""Between two catch-up saccades, s."""

HEAD_RATE = 8.0
"""How fast the head closes up with its moving goal (critically damped), 1/s."""

AFTER = 2.0
"""How long the following goes on after the target has come to rest, s."""

UPRIGHT, OVERHEAD = 75.0, 89.0
"""A saccade that overshoots by far turns no line of sight over the top: from the first pitch on it is slowed so that it
never comes to the second, deg. The eyes, and the head with them, are at the end of their reach long before."""

Pair = tuple[float, float]


def gain(speed: float) -> float:
    """Pursuit gain: 0.98 up to 10 deg/s, falling to 0.75 at 60 deg/s and on (bar P2)."""
    return 0.98 - 0.23 * min(1.0, max(0.0, (speed - 10.0) / 50.0))


def tolerated(speed: float) -> float:
    """The error that draws no catch-up saccade from a target of `speed` deg/s, in deg."""
    return min(2.0, 0.5 + 0.1 * speed)


@dataclass(slots=True)
class Following:
    """How a target is followed: the eyes' smooth course, catch-up saccades (onset, done, way), the head's course, and
    the course of the nearness, 1/distance in 1/cm, at which the eyes converge. Times are the film's."""

    smooth: Course
    saccades: list[tuple[float, float, Pair]]
    head: Course
    nearness: Course

    def eyes(self, times: Floats) -> Floats:
        """Yaw and pitch of the line of sight: array[n, 2]."""
        values = np.array(self.smooth(times))
        for onset, done, way in self.saccades:
            first = np.searchsorted(times, onset)
            values[first:] += saccade_curve(times[first:], onset, done)[:, None] * np.array(way)
        values[:, 1] = below_the_top(values[:, 1])
        return values


def below_the_top(pitch: Floats) -> Floats:
    """Pitches (deg) kept from turning the line of sight over the top."""
    room = OVERHEAD - UPRIGHT
    beyond = np.maximum(np.abs(pitch) - UPRIGHT, 0.0)
    kept: Floats = pitch - np.sign(pitch) * (beyond - room * np.tanh(beyond / room))
    return kept


@dataclass(slots=True)
class Eyes:
    """The state of the eyes at one step: smooth position and velocity, since when a saccade may be made (`ready`) and
    the error has been too large (`amiss`), from when on none is begun (`until`), the saccades made and their sum."""

    place: Pair
    speed: Pair
    ready: float
    amiss: float
    until: float
    jumped: Pair = (0.0, 0.0)
    saccades: list[tuple[float, float, Pair]] = field(default_factory=list)

    def look(self, time: float) -> Pair:
        """Where the eyes are, the saccade under way included."""
        x, y = self.place[0] + self.jumped[0], self.place[1] + self.jumped[1]
        if self.saccades and time < self.saccades[-1][1]:
            onset, done, way = self.saccades[-1]
            ahead = 1.0 - saccade_part((time - onset) / (done - onset), done - onset)
            return x - ahead * way[0], y - ahead * way[1]
        return x, y


@dataclass(frozen=True, slots=True)
class Spell:
    """When a shift has the eyes and the head that follow, seconds of the film: from its `start` on; the eyes `leave`
    for the target and have `landed`, the head has `turned` to it; from `eyes_until` and `head_until` on the next shift
    takes them elsewhere."""

    start: float
    leave: float
    landed: float
    turned: float
    eyes_until: float
    head_until: float


def follow(
    sight: Callable[[float], Sight], head_goal: Callable[[Direction], Direction], spell: Spell, end: float
) -> Following:
    """Follow `sight` (film's time to the line of sight to the target) to the time `end`.

    The eyes are on the target when they leave for it, and make no other saccade before they have landed nor once they
    are taken elsewhere. The head turns to where the target is at the start, and follows from then on.
    """
    count = max(2, int((end - spell.start) / STEP) + 2)
    pursuit = Pursuit(sight, head_goal, spell, count - 1)
    rows = pursuit.run(0, count)
    place, head, nearness = (through(spell.start, STEP, rows[:, part]) for part in (PLACE, HEAD, NEARNESS))
    return Following(place, pursuit.eyes.saccades if pursuit.eyes else [], head, nearness)


PLACE, HEAD, NEARNESS, WIDTH = slice(0, 2), slice(2, 4), slice(4, 5), 5
"""What is in a row of a pursuit: the smooth place of the eyes (saccades aside), the head, and the nearness."""


@dataclass(frozen=True, slots=True)
class State:
    """How far eyes, head and vergence have come at a step."""

    eyes: Eyes | None
    look: Pair
    head: tuple[Pair, Pair] | None
    near: Pair | None


class Pursuit:
    """Works out how `sight` is followed, step after step. The eyes leave at the step `first`, at the `last` there is.

    A step looks at the target as it was 130 ms and more before, but for the first ones of eyes and head.
    """

    def __init__(
        self,
        sight: Callable[[float], Sight],
        head_goal: Callable[[Direction], Direction],
        spell: Spell,
        last: float = inf,
    ) -> None:
        self.sight, self.head_goal, self.spell = sight, head_goal, spell
        self.first = int(min(last, max(0, int((spell.leave - spell.start) / STEP))))
        self.eyes: Eyes | None = None
        self.look: Pair = (0.0, 0.0)
        self.head: tuple[Pair, Pair] | None = None
        self.near: Pair | None = None

    def state(self) -> State:
        eyes = replace(self.eyes, saccades=self.eyes.saccades[:]) if self.eyes else None
        return State(eyes, self.look, self.head, self.near)

    def taken(self, spell: Spell) -> None:
        """Eyes and head are taken elsewhere at other times from the next step on."""
        self.spell = spell
        if self.eyes is not None:
            self.eyes.until = spell.eyes_until

    def turn_to(self, state: State) -> None:
        """Be as at a step before."""
        self.eyes = replace(state.eyes, saccades=state.eyes.saccades[:]) if state.eyes else None
        self.look, self.head, self.near = state.look, state.head, state.near

    def run(self, step: int, count: int) -> Floats:
        """The rows of `count` steps from `step` on, which is the one that comes next: array[count, WIDTH]."""
        seen = self._seen(step, count)
        foreseen = _foreseen(seen[:, :2], count)
        rows = np.empty((count, WIDTH))
        looks = self._pursued(foreseen, step, rows[:, PLACE])
        self._turned(looks, step, rows[:, HEAD])
        self._converging(1.0 / seen[BEFORE - VERGENCE_STEPS :, 2], rows[:, NEARNESS])
        return rows

    def _seen(self, step: int, count: int) -> Floats:
        """The line of sight to the target on the grid from `BEFORE` steps before `step` on, as far as it is seen in
        time for `count` steps: array[BEFORE - PURSUIT_STEPS + count, 3]."""
        start, last = self.spell.start, step + count - PURSUIT_STEPS
        return np.array([self.sight(start + number * STEP) for number in range(step - BEFORE, last)])

    def _at(self, step: int) -> Pair:
        """Where the target is at a step."""
        sight = self.sight(self.spell.start + step * STEP)
        return sight.yaw, sight.pitch

    def _pursued(self, foreseen: Floats, step: int, places: Floats) -> list[Pair]:
        """The smooth place of the eyes at each step, and where they look a step later.

        They expect the target where it is `foreseen` (place and velocity a step), and follow it from the step `first`
        on; before, they are where it is then.
        """
        begun = max(0, self.first - step)
        if self.eyes is None:
            away = begun >= len(places)
            self.look = self._at(0 if away else self.first)
            if not away:
                speed = _pair(foreseen[begun, 2:])
                spell = self.spell
                self.eyes = Eyes(self.look, speed, spell.landed, spell.landed, spell.eyes_until)
        looks = [self.look] * min(begun, len(places))
        places[:begun] = self.look
        if self.eyes is not None:
            looks += self._stepped(self.eyes, foreseen, step, begun, places)
        return looks

    def _stepped(self, eyes: Eyes, foreseen: Floats, step: int, begun: int, places: Floats) -> list[Pair]:
        """The steps of the eyes on their way, from the `begun`th row on."""
        look, looks = self.look, []
        for row, (x, y, u, v) in enumerate(foreseen[begun:].tolist(), begun):
            time = self.spell.start + (step + row) * STEP
            places[row] = eyes.place
            _advance(eyes, (x - look[0], y - look[1]), (u, v), time)
            look = eyes.look(time + STEP)
            looks.append(look)
        self.look = look
        return looks

    def _turned(self, looks: list[Pair], step: int, heads: Floats) -> None:
        """The head at each step: turned for where the target is at the start, it goes with where the eyes look from
        when it is there until it is taken elsewhere, and stops."""
        (x, y), (u, v) = self.head or (self.head_goal(self._at(0)), (0.0, 0.0))
        spell, pull, drag = self.spell, HEAD_RATE * HEAD_RATE, 2 * HEAD_RATE
        for row, look in enumerate(looks):
            heads[row] = x, y
            if spell.turned <= spell.start + (step + row) * STEP < spell.head_until:
                goal = self.head_goal(look)
            else:
                goal = x + u / HEAD_RATE, y + v / HEAD_RATE
            u += STEP * (pull * (goal[0] - x) - drag * u)
            v += STEP * (pull * (goal[1] - y) - drag * v)
            u, v = _at_most(u, v, HEAD_CEILING)
            x, y = x + STEP * u, y + STEP * v
        self.head = (x, y), (u, v)

    def _converging(self, nearness: Floats, converged: Floats) -> None:
        """The nearness at which the eyes converge, which comes after the target's."""
        near, pace = self.near or (float(nearness[0]), 0.0)
        for row, goal in enumerate(nearness[: len(converged)].tolist()):
            converged[row] = near
            pace += STEP * VERGENCE_RATE * (VERGENCE_RATE * (goal - near) - 2 * pace)
            near += STEP * pace
        self.near = near, pace


def _pair(row: Floats) -> Pair:
    return float(row[0]), float(row[1])


def _foreseen(place: Floats, count: int) -> Floats:
    """The place and velocity to be expected at each of `count` steps from what was last seen before it:
    array[count, 4]."""
    speed = np.diff(place, axis=0, prepend=place[:1]) / STEP
    speed[0] = speed[1]
    speed[np.hypot(*speed.T) >= FASTEST] = 0.0
    ahead = np.diff(speed, axis=0, prepend=speed[:1]) / STEP
    ahead *= FORESEEN / np.maximum(np.hypot(*ahead.T), FORESEEN)[:, None]
    last, t = slice(BEFORE - PURSUIT_STEPS, BEFORE - PURSUIT_STEPS + count), PURSUIT_STEPS * STEP
    place, speed, ahead = place[last], speed[last], ahead[last]
    return np.concatenate([place + t * speed + t * t / 2 * ahead, speed + t * ahead], axis=1)


def _advance(eyes: Eyes, error: Pair, speed: Pair, time: float) -> None:
    """One step of the eyes, which miss the target by `error` and expect it to have a speed: a catch-up saccade where
    one is due, and smooth pursuit."""
    fast = hypot(*speed)
    if hypot(*error) <= tolerated(fast):
        eyes.amiss = time + STEP
    if eyes.ready <= time < eyes.until and eyes.amiss + DECIDING <= time:
        _catch_up(eyes, error, speed, time)
    kept, share, half = gain(fast), STEP / SMOOTHING, STEP / 2
    slow = _at_most(2.0 * error[0], 2.0 * error[1], max(0.3, 0.05 * fast))
    (x, y), (u, v) = eyes.place, eyes.speed
    eyes.speed = u + share * (kept * speed[0] + slow[0] - u), v + share * (kept * speed[1] + slow[1] - v)
    eyes.place = x + half * (u + eyes.speed[0]), y + half * (v + eyes.speed[1])


def _catch_up(eyes: Eyes, error: Pair, speed: Pair, time: float) -> None:
    """A saccade to where the target will be when it lands."""
    lasts = max(saccade_time(hypot(*error)), PEAK_OVER_MEAN * hypot(*error) / CATCHING)
    way = error[0] + lasts * (speed[0] - eyes.speed[0]), error[1] + lasts * (speed[1] - eyes.speed[1])
    eyes.saccades.append((time, time + lasts, way))
    eyes.jumped = eyes.jumped[0] + way[0], eyes.jumped[1] + way[1]
    eyes.ready = time + lasts + REST


def _at_most(x: float, y: float, limit: float) -> Pair:
    size = hypot(x, y)
    return (x, y) if size <= limit else (x * limit / size, y * limit / size)
