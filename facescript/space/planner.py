"""Requests to look somewhere to planned gaze shifts of one face: who owns eyes and head when, and what comes back."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from copy import copy
from dataclasses import dataclass, replace
from heapq import heapify, heappop, heappush
from math import inf

from facescript.ir.acts import GazeManner
from facescript.ir.play import Face
from facescript.ir.values import Aim, AtCamera, Away
from facescript.space.away import averted
from facescript.space.live import LiveSightings
from facescript.space.plan import GazePlan
from facescript.space.reach import Direction
from facescript.space.room import Room
from facescript.space.shift import Shifter, Wish, number
from facescript.space.sightings import HOLD, LATENCY, NOTICED, Absence

Key = tuple[int | tuple[int, ...], int]

BEGINS, RELEASES, TURNS = 0, 1, 2
"""What happens to a request: at one time, in this order."""

JUDGED = 500
"""At so many keys of a moving target, about, it is seen how far it is out of reach."""


class TooMuchGaze(Exception):
    """More movements than a room has `left` would have to be worked out."""


@dataclass(frozen=True, slots=True)
class GazeRequest:
    """A look, a glance or one stop of a scan, with all draws drawn; seconds from the film's start.

    `key` is (order of the act, number of the stop). `start` is without the manner's latency; at `released` it lets
    go and what it covered comes back. `over` is the length an author gave the shift (0: at once). `glance` is a
    glance: the head takes little part. `persons` and `people` are as in `Room.bind`; `place` names
    the look to the seed.
    """

    key: Key
    aim: Aim
    manner: GazeManner
    start: float
    released: float = inf
    over: float | None = None
    scene: int = 0
    glance: bool = False
    persons: tuple[tuple[str, str], ...] = ()
    people: tuple[str, ...] = ()
    place: tuple[object, ...] = ()

    @property
    def onset(self) -> float:
        """When the look begins, its latency included."""
        return self.start + number(self.manner.latency)


def plan_gaze(
    room: Room, face: Face, requests: Sequence[GazeRequest], scenes: Sequence[float] = (0.0,)
) -> dict[Key, tuple[GazePlan, ...]]:
    """The shifts of every request by its key, in time; a shift back, where there is one, is the last of its request.

    `scenes` are the scenes' starts. Every scene begins with eyes and head at the camera. The later start wins the
    parts it uses; when it lets go, the part's older owner has it again (rule 5 of the blending law). Raises
    `TooMuchGaze`.
    """
    plans: dict[Key, tuple[GazePlan, ...]] = {}
    rows: dict[int, list[GazeRequest]] = {}
    for request in requests:
        rows.setdefault(request.scene, []).append(request)
    for scene, own in sorted(rows.items(), key=lambda row: row[0]):
        plans.update(Planning(room, face, scenes[min(scene, len(scenes) - 1)]).plan(own))
    return plans


@dataclass(frozen=True, slots=True)
class Owner:
    """What has eyes or head when all is at rest, and will have them again when what covers it lets go."""

    aim: Aim
    manner: GazeManner
    glance: bool


@dataclass(frozen=True, slots=True)
class Rest:
    """A face's gaze at rest: what the eyes are at and where the head is turned, what has them, and whether that is one
    and the same."""

    aim: Aim
    turned: Direction
    eyes: Owner | None
    head: Owner | None
    one: bool


def plan_on(
    room: Room, face: Face, requests: Sequence[GazeRequest], rest: Rest | None
) -> tuple[dict[Key, tuple[GazePlan, ...]], Rest, float]:
    """The shifts of requests of one scene, that begin with `rest` (None: as every scene does), from 0 s on; what they
    leave, and from when on that is at rest. Nothing that is looked at may move. Raises `TooMuchGaze`."""
    scene = Planning(room, face, 0.0, rest)
    plans = scene.plan(requests)
    return plans, scene.rest(), max(scene.shifter.eyes.still(), scene.shifter.head.still())


@dataclass(frozen=True, slots=True)
class _Owners:
    """The requests that have eyes and head; None is the camera, at which every scene begins."""

    eyes: GazeRequest | None
    head: GazeRequest | None


@dataclass(frozen=True, slots=True)
class _Watched:
    """A shift that is under way: its request, its aim, its start by the scene's clock, and how far it stays short."""

    key: Key
    aim: Aim
    start: float
    short: Callable[[float], float]


@dataclass(frozen=True, slots=True)
class _Turn:
    """When (scene's clock) the target of a request is let go of because it `leaves`, or is found again."""

    clock: float
    leaves: Absence | None


@dataclass(frozen=True, slots=True)
class _Attended:
    """Since when (scene's clock) a request looks at its target, or since when it has let go of it, which is `gone`."""

    clock: float
    gone: Absence | None = None


class Planning:
    """Plans one scene of one face: the requests begin and let go in time, and each change of an owner is a shift.

    Where a scene goes on, what was planned of the time before a moment stays as it is (`pass_to`), and what comes later
    is planned by a `fork`: of requests that have begun it only counts when they let go.
    """

    def __init__(self, room: Room, face: Face, start: float, rest: Rest | None = None) -> None:
        self.whole, self.room, self.face, self.start = room, room.of(start), face, start
        self.room.turn_to(0.0)
        self.shifter = Shifter(self.room, face, start, *((rest.aim, rest.turned) if rest else ()))
        self.eyes: dict[Key, GazeRequest] = {}
        self.head: dict[Key, GazeRequest] = {}
        self.aims: dict[Key, Aim] = {}
        self.watched: dict[str, _Watched] = {}
        self.plans: dict[Key, list[GazePlan]] = {}
        self.changes: list[tuple[float, int, Key, GazeRequest]] = []
        self.turns: dict[Key, _Turn] = {}
        self.attended: dict[Key, _Attended] = {}
        self.begun: dict[Key, GazeRequest] = {}
        if rest:
            self._resume(rest)

    def _resume(self, rest: Rest) -> None:
        """Go on from a rest: what has eyes and head bears the keys of nothing that is done."""
        for name, owner, parts in ((-1, rest.eyes, self.eyes), (-1 if rest.one else -2, rest.head, self.head)):
            if owner is not None:
                request = GazeRequest((name, 0), owner.aim, owner.manner, -inf, glance=owner.glance)
                parts[request.key] = next((one for one in self.eyes.values() if one.key == request.key), request)
                self.aims[request.key] = owner.aim

    def rest(self) -> Rest:
        """What is left when all is done and has let go."""
        owners = self._owners()
        eyes, head = (
            Owner(self.aims[one.key], one.manner, one.glance) if one else None for one in (owners.eyes, owners.head)
        )
        one = owners.eyes is owners.head
        return Rest(self.shifter.aim, self.shifter.head.goal(0.0), eyes, head, one)

    @property
    def owners(self) -> set[Key]:
        """The requests that have eyes or head, or will have them again."""
        return {*self.eyes, *self.head}

    def fork(self) -> Planning:
        """Another that goes on from here."""
        other = copy(self)
        other.shifter = self.shifter.fork()
        other.eyes, other.head, other.aims = dict(self.eyes), dict(self.head), dict(self.aims)
        other.watched, other.turns, other.begun = dict(self.watched), dict(self.turns), dict(self.begun)
        other.attended = dict(self.attended)
        other.plans = {key: list(plans) for key, plans in self.plans.items()}
        return other

    def pass_to(self, time: float, requests: Sequence[GazeRequest]) -> None:
        """Plan what comes before a time once and for all, and forget all that is not asked for any more."""
        self._run(requests, time)
        self.shifter = self.shifter.fork()
        wanted = {request.key for request in requests} | self.owners | {one.key for one in self.watched.values()}
        for known in (self.aims, self.plans, self.begun, self.turns, self.attended):
            for key in [key for key in known if key not in wanted]:
                del known[key]

    def _come(self, requests: Sequence[GazeRequest]) -> Iterator[tuple[float, int, Key, GazeRequest]]:
        """What is still to happen to requests, some of which have begun."""
        for request in requests:
            held = self.begun.get(request.key)
            if request.key not in self.plans:
                yield request.onset, BEGINS, request.key, request
            if request.released < inf and (held or request.key not in self.plans):
                yield max(request.released, request.onset), RELEASES, request.key, held or request
        self._look_again()
        for key, turn in self.turns.items():
            yield self.start + turn.clock, TURNS, key, self.begun[key]

    def _look_again(self) -> None:
        """Of persons who are seen live more may be known than when they were attended to: who is lost, who is found."""
        for key in self.owners & self.attended.keys():
            sightings, attended = self.room.sightings(self.face.name, self.aims[key]), self.attended[key]
            if not isinstance(sightings, LiveSightings):
                continue
            if attended.gone:
                now = sightings.at(attended.gone.start) or attended.gone
                turn: _Turn | None = _Turn(max(now.end + LATENCY, attended.clock), None)
            else:
                next_ = sightings.lets_go(attended.clock)
                turn = _Turn(*next_) if next_ else None
            self._await(self.begun[key], turn)

    def plan(self, requests: Sequence[GazeRequest]) -> dict[Key, tuple[GazePlan, ...]]:
        """The shifts of every request by its key, in time."""
        self._run(requests, inf)
        self._judge("eyes", inf)
        self._judge("head", inf)
        return {key: tuple(plans) for key, plans in self.plans.items()}

    def _run(self, requests: Sequence[GazeRequest], until: float) -> None:
        """Plan all that happens before a time."""
        self.changes = list(self._come(requests))
        heapify(self.changes)
        while self.changes and self.changes[0][0] < until:
            time, what, _, request = heappop(self.changes)
            self.room.turn_to(time - self.start)
            if what == TURNS:
                self._turn(time, request)
            elif what == RELEASES:
                self._let_go(time, request)
            else:
                self._begin(time, request)
            if self.shifter.worked > self.whole.left:
                raise TooMuchGaze
        self.whole.left -= self.shifter.worked

    def _begin(self, time: float, request: GazeRequest) -> None:
        clock = time - self.start
        aim = self.room.bind(self.face.name, request.aim, clock, request.persons, request.people)
        if isinstance(aim, Away):
            place = request.place or request.key
            aim = averted(self.shifter.eyes.goal(clock), self.room.film.seed, self.face.name, *place)
        self.aims[request.key] = aim
        self.begun[request.key] = request
        self._take(request)
        seen = self._attend(request, clock, known=False)
        wish = Wish(seen, request.manner.parts, request.manner, request.over, request.glance, request.released)
        part = "head" if request.manner.parts == "head only" else "eyes"
        for taken in (part,) if request.manner.parts == "eyes only" else (part, "head"):
            self._judge(taken, clock)
        self.plans[request.key] = [self.shifter.plan(clock, wish)]
        self.watched[part] = _Watched(request.key, aim, clock, self.shifter.shortfall(replace(wish, aim=aim)))

    def _attend(self, request: GazeRequest, clock: float, known: bool) -> Aim:
        """What a request that has eyes or head from now on looks at: its aim, or the camera while its target is let go
        of. Where the target is out of reach is `known` to one that comes back; a new one looks there first."""
        aim = self.aims[request.key]
        sightings = self.room.sightings(self.face.name, aim)
        if sightings is None:
            return aim
        gone = sightings.at(clock)
        if gone and (known or gone.lost) and clock >= gone.start + HOLD:
            self._leave(request, gone, clock)
            return AtCamera()
        self.attended[request.key] = _Attended(clock)
        next_ = sightings.lets_go(clock)
        self._await(request, _Turn(*next_) if next_ else None)
        return aim

    def _leave(self, request: GazeRequest, gone: Absence, soonest: float) -> None:
        """Let go of a target that is gone, until it is back."""
        self.attended[request.key] = _Attended(soonest, gone)
        self._await(request, _Turn(max(gone.end + LATENCY, soonest), None))

    def _await(self, request: GazeRequest, turn: _Turn | None) -> None:
        """Come back to a request when its target is let go of, or found again."""
        self.turns.pop(request.key, None)
        if turn is not None and turn.clock < inf:
            self.turns[request.key] = turn
            heappush(self.changes, (self.start + turn.clock, TURNS, request.key, request))

    def _turn(self, time: float, request: GazeRequest) -> None:
        """The target of a request is let go of, or found again, if that has eyes or head."""
        turn = self.turns.get(request.key)
        if turn is None or self.start + turn.clock != time:
            return
        del self.turns[request.key]
        owners = self._owners()
        eyes, head = owners.eyes is request, owners.head is request
        if not eyes and not head:
            return
        parts = request.manner.parts if eyes and head else "eyes only" if eyes else "head only"
        if turn.leaves:
            self._leave(request, turn.leaves, turn.clock + NOTICED)
            wish = Wish(AtCamera(), parts, GazeManner(parts, speed=request.manner.speed))
        else:
            aim = self._attend(request, turn.clock, known=False)
            wish = Wish(aim, parts, request.manner, None, request.glance)
        self.plans[request.key].append(self.shifter.plan(turn.clock, wish))

    def _judge(self, part: str, until: float) -> None:
        """The shift that has the eyes (or has the head and nothing else) loses them."""
        shift = self.watched.pop(part, None)
        if shift is not None:
            self._note(shift, until)

    def _note(self, shift: _Watched, until: float) -> None:
        """Note how far a shift that lasts until then stays short of its target, at worst."""
        moving = self.room.moving(shift.aim)
        keys = moving.times if moving else ()
        low, high = bisect_right(keys, shift.start), bisect_left(keys, until)
        times = [shift.start, *keys[low : high : max(0, high - low) // JUDGED + 1]]
        if moving and until < keys[-1]:
            times.append(until)
        worst = max(times, key=shift.short)
        short = shift.short(worst)
        sightings, plan = self.room.sightings(self.face.name, shift.aim), self.plans[shift.key][0]
        had = sightings.had(shift.start, until) if sightings else "in sight"
        if short > 0.0 or had == "lost":
            away, when = had == "at times", self.start + worst
            found = replace(plan, unreachable=short, worst=when, at_times=away, lost=had == "lost")
            self.plans[shift.key][0] = found

    def _let_go(self, time: float, request: GazeRequest) -> None:
        before = self._owners()
        if before.eyes is request:
            self._judge("eyes", time - self.start)
        if before.head is request:
            self._judge("head", time - self.start)
        for held in (self.eyes, self.head, self.begun, self.turns):
            held.pop(request.key, None)
        after = self._owners()
        clock = time - self.start
        for wish in self._back(request, before, after, clock):
            self.plans[request.key].append(self.shifter.plan(clock, wish))

    def _back(self, request: GazeRequest, before: _Owners, after: _Owners, clock: float) -> tuple[Wish, ...]:
        """What eyes and head go back to; together where that is one and the same."""
        eyes, head = before.eyes is request, before.head is request
        if eyes and head and after.eyes is after.head:
            both = "head then eyes" if request.manner.parts == "head then eyes" else "eyes then head"
            return (self._covered(after.eyes, both, request.manner, clock),)
        parts = [("eyes only", after.eyes)] if eyes else []
        parts += [("head only", after.head)] if head else []
        return tuple(self._covered(owner, part, request.manner, clock) for part, owner in parts)

    def _covered(self, owner: GazeRequest | None, parts: str, manner: GazeManner, clock: float) -> Wish:
        """The wish to go back to what `owner` looks at, at the speed of the one that lets go."""
        if owner is None:
            return Wish(AtCamera(), parts, GazeManner(speed=manner.speed))
        back = replace(owner.manner, speed=manner.speed)
        return Wish(self._attend(owner, clock, known=True), parts, back, None, owner.glance)

    def _owners(self) -> _Owners:
        return _Owners(
            next(reversed(self.eyes.values()), None),
            next(reversed(self.head.values()), None),
        )

    def _take(self, request: GazeRequest) -> None:
        """The request has its parts from now on; what it covers for good will never come back."""
        for part, owners in (("head only", self.eyes), ("eyes only", self.head)):
            if request.manner.parts != part:
                if request.released == inf:
                    owners.clear()
                owners[request.key] = request
