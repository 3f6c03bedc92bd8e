"""One gaze shift: from what is looked at next, and how, to the times and goals of eyes and head."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from copy import copy
from dataclasses import dataclass
from functools import partial
from math import hypot, inf

from facescript.ir.acts import GazeManner
from facescript.ir.play import Face
from facescript.ir.values import Aim, AtCamera, Draw, Towards
from facescript.space.main_sequence import (
    head_lag,
    head_time,
    least_head_time,
    least_saccade_time,
    minimum_jerk,
    saccade_part,
    saccade_time,
)
from facescript.space.plan import GazePlan
from facescript.space.reach import Direction, extent, head_goal, in_head, shortfall, within
from facescript.space.room import Room

SHARES = {"": (0.69, 0.52, 0.08), "head-mover": (0.95, 0.8, 0.4), "eye-mover": (0.69, 0.52, 0.08)}
"""The head's share of a direction (sideways, up, down) by the face's habit (motion.md section 2; bar H4)."""

EYE_ONLY, BEYOND = 15.0, 0.75
"""A glance, and any look of an eye-mover, leaves the first `EYE_ONLY` deg to the eyes and takes the head `BEYOND` of
the rest (motion.md section 2, "quick glance"; bar H5)."""

HEAD_FIRST = 0.5
"""With `head then eyes` the eyes leave when the head has spent this part of its time."""

HINDRANCE = 0.4
"""By this part of its time a saccade takes longer that interrupts another at its start (ours: eyes that are still on
their way are not to be hurled on)."""

TURNING = 1.0
"""A head movement below this many degrees is none to wait for."""

SEEN = 0.5
"""A gaze short of its target by less than this is not seen to be, deg."""

REACHED = 0.976
"""The part of their reach within which the eyes come to less than `SEEN` of a target (`reach.EYE_KNEE`)."""

WAIT_STEP, WAIT_STEPS = 0.004, 500
"""Steps in which the moment is sought when the waiting eyes have the target, s; longer where they would be more."""

WAIT_STRIDE = 16
"""As many steps are taken at once at first."""

FOLLOWING = 3
"""A movement that follows a target is so much dearer to work out than one to a place."""

BEHIND = (0.1, 0.18, 0.25, 0.5, 0.75)
"""So long ago is looked where a followed target was, s: eyes and head see it late, and come after it by and by."""

FAR, FAST = 5.0, 25.0
"""A target that has gone further (deg, and deg for each s) is one that eyes and head may not have come after yet."""

MOST_LAID = 32
"""As many movements may lie over each other; older ones of a part are taken to be done."""


def number(amount: float | Draw) -> float:
    """An amount that is drawn already."""
    if isinstance(amount, Draw):
        raise ValueError("a draw that is not drawn")
    return amount


Goal = Callable[[float], Direction]
"""Where a movement is bound for at a time of the scene's clock."""


@dataclass(frozen=True, slots=True)
class Move:
    """A movement of eyes or head towards a goal that may itself move; times of the scene's clock."""

    onset: float
    done: float
    goal: Goal
    cost: int = 1


class Past:
    """The movements of one part so far, each blended over the one before, so that an interruption never jumps."""

    def __init__(self, first: Move, part: Callable[[float, float], float]) -> None:
        self.moves = [first]
        self.part = part
        self.worked = 0

    def fork(self) -> Past:
        """Another that goes on from here, with the movements that it may still be asked for."""
        other = Past(self.moves[0], self.part)
        other.moves = self.moves[-MOST_LAID - 1 :]
        return other

    def drop_pending(self, time: float) -> None:
        """Forget the movements that would begin at `time` or later: they are overtaken before they begin."""
        while len(self.moves) > 1 and self.moves[-1].onset >= time:
            self.moves.pop()

    def at(self, time: float) -> Direction:
        """Where the part is at `time`."""
        first = len(self.moves) - 1
        last = max(0, first - MOST_LAID)
        while first > last and time < self.moves[first].done:
            first -= 1
        self.worked += sum(move.cost for move in self.moves[first:])
        yaw, pitch = self.moves[first].goal(time)
        for move in self.moves[first + 1 :]:
            if time > move.onset:
                gone = self.part((time - move.onset) / (move.done - move.onset), move.done - move.onset)
                goal = move.goal(time)
                yaw, pitch = yaw + gone * (goal[0] - yaw), pitch + gone * (goal[1] - pitch)
        return yaw, pitch

    def still(self) -> float:
        """When the last movement is over."""
        return max(move.done for move in self.moves)

    def goal(self, time: float) -> Direction:
        """Where the part is bound for."""
        return self.moves[-1].goal(time)

    def to_come(self, time: float) -> float:
        """How many movements are still to come at `time`: each under way counts by the part of it that is left."""
        under_way = (move for move in self.moves[-MOST_LAID:] if move.onset < time < move.done)
        return sum((move.done - time) / (move.done - move.onset) for move in under_way)

    def way(self, goal: Goal, time: float) -> float:
        """How far a movement that sets off at `time` has to go to `goal`, deg: from where the part is then, or from
        where it is bound for if that is further, for a movement that is interrupted goes on under the next. What
        follows a target may not be there yet: where that has been counts too."""
        there = goal(time)
        return max(_distance(there, place) for place in (self.at(time), *self._places(time)))

    def _places(self, time: float) -> Iterator[Direction]:
        """Where the part may be or get to, by the movements that are not over at `time`."""
        for number, move in enumerate(reversed(self.moves[-MOST_LAID:])):
            now = move.goal(time)
            if not number and time < move.done:
                yield now
            if move.cost > 1:
                late = [(move.goal(max(time - lag, move.onset)), FAR + FAST * lag) for lag in BEHIND]
                self.worked += move.cost * (len(BEHIND) + 1)
                yield from (place for place, far in late if _distance(place, now) > far)
            if time >= move.done:
                return


@dataclass(frozen=True, slots=True)
class Wish:
    """What a shift is asked for: the aim made definite, the manner, and the length an author gave it.

    `parts` are those it moves: in a shift back they may be fewer than the manner's.
    """

    aim: Aim
    parts: str
    manner: GazeManner
    over: float | None = None
    glance: bool = False
    released: float = inf


class Shifter:
    """Plans the shifts of one face in one scene, one after another in time."""

    def __init__(
        self, room: Room, face: Face, start: float, aim: Aim | None = None, turned: Direction | None = None
    ) -> None:
        """The eyes are at `aim` and the head is `turned` at first; None is as every scene begins."""
        self.room, self.face, self.start = room, face, start
        self._directions: dict[Aim, Goal] = {}
        self.aim: Aim = aim or AtCamera()
        rest = self._direction(self.aim)
        ahead = turned or head_goal(rest(0.0), self._usual(rest(0.0)))
        self.eyes = Past(Move(-inf, -inf, rest), saccade_part)
        self.head = Past(Move(-inf, -inf, lambda _: ahead), lambda part, _: minimum_jerk(part))

    def fork(self) -> Shifter:
        """Another that goes on from here."""
        other = copy(self)
        other.eyes, other.head = self.eyes.fork(), self.head.fork()
        other._directions = {aim: goal for aim, goal in self._directions.items() if not isinstance(aim, Towards)}
        return other

    @property
    def worked(self) -> int:
        """How many movements were worked out so far."""
        return self.eyes.worked + self.head.worked

    def plan(self, time: float, wish: Wish) -> GazePlan:
        """The shift that begins at `time` (scene's clock), laid over those planned before it."""
        eyes, head = wish.parts != "head only", wish.parts != "eyes only"
        target, cost = self._direction(wish.aim), FOLLOWING if self.room.moving(wish.aim) else 1
        at = target(time)
        self._drop_pending(time, eyes, head)
        share, start = self._share(wish, at, self.head.goal(time))
        turned = self._turned(target, share, start, cost > 1)
        amplitude, turn = self._sizes(time, wish, target, turned)
        hindered = self.eyes.to_come(time)
        times = _times(time, wish, amplitude, turn, hindered)
        if eyes:
            self.aim = wish.aim
            self.eyes.moves.append(Move(times.eye_onset, times.eye_done, target, cost))
        if head:
            first, done = turned(time), times.head_done
            follows = (lambda now: turned(now) if now >= done else first) if cost > 1 else turned
            self.head.moves.append(Move(times.head_onset, done, follows, cost))
        landed = self._landed(times, target) if eyes else times.head_done
        return GazePlan(
            aim=wish.aim,
            parts=wish.parts,
            eye_onset=self.start + times.eye_onset,
            landed=self.start + landed,
            head_onset=self.start + times.head_onset,
            head_done=self.start + times.head_done,
            head_share=share,
            amplitude=amplitude if eyes else turn,
            released=wish.released,
            instant=wish.over == 0.0,
            eye_done=self.start + times.eye_done,
            head_from=start,
            needs=_needs(wish, amplitude, turn, hindered),
        )

    def _sizes(self, time: float, wish: Wish, target: Goal, turned: Goal) -> tuple[float, float]:
        """How far the eyes have to go to `target` and the head to `turned`, deg, each when it sets off."""
        if wish.parts == "head only":
            return 0.0, self.head.way(turned, time)
        if wish.parts == "head then eyes":
            turn = self.head.way(turned, time)
            return self.eyes.way(target, _times(time, wish, 0.0, turn).eye_onset), turn
        amplitude = self.eyes.way(target, time)
        if wish.parts == "eyes only":
            return amplitude, 0.0
        return amplitude, self.head.way(turned, _times(time, wish, amplitude, 0.0).head_onset)

    def shortfall(self, wish: Wish) -> Callable[[float], float]:
        """Of the wish planned last: by how many degrees the gaze stays short of its target at a time, all settled."""
        head = self.head.moves[-1].goal

        def short(time: float) -> float:
            sight = self.room.sight(self.face.name, wish.aim, time)
            target = sight.yaw, sight.pitch
            angle = _distance(target, head(time)) if wish.parts == "head only" else shortfall(target, head(time))
            return angle if angle > SEEN else 0.0

        return short

    def _direction(self, aim: Aim) -> Goal:
        known = self._directions.get(aim)
        if known is None:
            known = self._directions[aim] = self._directed(aim)
        return known

    def _directed(self, aim: Aim) -> Goal:
        if not self.room.moving(aim):
            sight = self.room.sight(self.face.name, aim, 0.0)
            still = within((sight.yaw, sight.pitch))
            return lambda time: still
        followed = self.room.following(self.face.name, aim)

        def direction(time: float) -> Direction:
            sight = followed(time)
            return within((sight.yaw, sight.pitch))

        return _once(self.room, direction)

    def _turned(self, target: Goal, share: Direction, start: Direction, moves: bool) -> Goal:
        """Where the head turns for a target, which may move."""
        if moves:
            return _once(self.room, partial(_head_at, target, share, start))
        still = head_goal(target(0.0), share, start)
        return lambda _: still

    def _drop_pending(self, time: float, eyes: bool, head: bool) -> None:
        if eyes:
            self.eyes.drop_pending(time)
        if head:
            self.head.drop_pending(time)

    def _usual(self, direction: Direction) -> Direction:
        side, up, down = SHARES[self.face.gaze]
        return side, up if direction[1] > 0 else down

    def _share(self, wish: Wish, target: Direction, head: Direction) -> tuple[Direction, Direction]:
        """The head's share of the way, and from where the way is counted."""
        if wish.manner.head_share is not None:
            share = number(wish.manner.head_share)
            return (share, share), (0.0, 0.0)
        if wish.manner.parts == "head only":
            return (1.0, 1.0), (0.0, 0.0)
        if not wish.glance and self.face.gaze != "eye-mover":
            return self._usual(target), (0.0, 0.0)
        start = head if wish.glance else (0.0, 0.0)
        way = target[0] - start[0], target[1] - start[1]
        far = hypot(*way)
        share = BEYOND * max(0.0, far - EYE_ONLY) / far if far else 0.0
        side, vertical = self._usual(way)
        return (share, share * vertical / side), start

    def _landed(self, times: Times, target: Goal) -> float:
        """When the eyes have the target, or are as near as they get: they may have to wait for the head."""
        time, done = times.eye_done, times.head_done
        step = max(WAIT_STEP, (done - time) / WAIT_STEPS)
        if time >= done or not self._waits(target, time):
            return time
        while time + WAIT_STRIDE * step < done and self._waits(target, time + WAIT_STRIDE * step):
            time += WAIT_STRIDE * step
        while time < done and self._waits(target, time):
            time = min(done, time + step)
        return time

    def _waits(self, target: Goal, time: float) -> bool:
        """Whether the target is out of the eyes' reach."""
        return extent(in_head(target(time), self.head.at(time))) > REACHED


@dataclass(frozen=True, slots=True)
class Times:
    """When eyes and head of a shift set off and arrive."""

    eye_onset: float
    eye_done: float
    head_onset: float
    head_done: float


def _times(time: float, wish: Wish, amplitude: float, turn: float, hindered: float = 0.0) -> Times:
    """The timing of a shift of `amplitude` deg with a head movement of `turn` deg, by the order of its parts.

    It is `hindered` by the saccades, or parts of them, that are still to come when it interrupts them.
    """
    if wish.over == 0.0:
        return Times(time, time, time, time)
    speed = number(wish.manner.speed)
    slower = 1.0 + HINDRANCE * hindered
    eye = max(saccade_time(amplitude) / speed, least_saccade_time(amplitude)) * slower
    head = max(head_time(turn) / speed, least_head_time(turn))
    lag, wait = head_lag(amplitude) / speed, HEAD_FIRST * head if turn > TURNING else 0.0
    over = None if wish.over is None else max(wish.over, _shortest(wish.parts, amplitude, turn, slower))
    if over is not None:
        lag, wait = min(lag, over / 2), over / 2
        eye, head = over, max(head, over - lag)
    if wish.parts == "eyes only":
        return Times(time, time + eye, time, time)
    if wish.parts == "head only":
        return Times(time, time, time, time + (over or head))
    if wish.parts == "head then eyes":
        length = over - wait if over is not None else eye
        return Times(time + wait, time + wait + length, time, time + (over or head))
    return Times(time, time + eye, time + lag, time + lag + head)


def _needs(wish: Wish, amplitude: float, turn: float, hindered: float) -> float:
    """How long a shift takes whose `over` asks for less than eyes or head can do, s; else 0."""
    if not wish.over:
        return 0.0
    least = _shortest(wish.parts, amplitude, turn, 1.0 + HINDRANCE * hindered)
    return least if least > wish.over else 0.0


def _shortest(parts: str, amplitude: float, turn: float, slower: float) -> float:
    """The shortest `over` that eyes (`amplitude` deg) and head (`turn` deg) can follow, s, so much `slower` than free
    ones."""
    eyes, head = slower * least_saccade_time(amplitude), slower * least_head_time(turn)
    if parts == "head only":
        return head
    return max(2 * eyes, head) if parts == "head then eyes" else eyes


def _head_at(target: Goal, share: Direction, start: Direction, time: float) -> Direction:
    return head_goal(target(time), share, start)


def _once(room: Room, goal: Goal) -> Goal:
    """The same goal, worked out once where it is asked for again and again at one time, by what the room knows."""
    last = (inf, inf, (0.0, 0.0))

    def remembered(time: float) -> Direction:
        nonlocal last
        if last[0] != time or last[1] != room.now:
            last = (time, room.now, goal(time))
        return last[2]

    return remembered


def _distance(one: Direction, other: Direction) -> float:
    return hypot(one[0] - other[0], one[1] - other[1])
