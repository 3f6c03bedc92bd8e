"""Turns a life into looks away from the target: now and then, and while a turn to speak is thought out."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import cos, inf, pi, sin

from facescript.ir.acts import Glance, Look, Scan
from facescript.motion.dice import Event
from facescript.motion.life_model import Living, Moved, moved, steps
from facescript.schedule.score import TimedAct, TimedLine
from facescript.space.main_sequence import head_time, saccade_time

AWAY = 30.0
"""Deg that a look away goes at most with `avert 100%`."""

SPEAKING, LISTENING = (1.8, 0.6), (5.0, 1.0)
"""Mean and deviation of the seconds on the partner between looks away (chosen for the bars C1 and C2)."""

SPEAKING_AWAY, LISTENING_AWAY = (2.4, 0.4), (1.14, 0.27)
"""Mean and deviation of the seconds away (Andrist 2013; when speaking longer than his 1.96 s, for the bar C1)."""

THINKING_BEFORE, THINKING_AFTER = (1.0, 0.25), (1.2, 0.25)
"""Mean and deviation of the seconds that a thoughtful look away starts before speech, and ends after its start."""

BACK = 2.3
"""Seconds before the end of a turn from which the eyes are on the partner (bar C3)."""

TURN_GAP = 1.0
"""Seconds of silence that make a new turn."""

SETTLING = 0.6
"""Seconds between two looks away, and the shortest one: the head comes to rest."""

HEAD_LAG = 0.1
"""Seconds the head follows the eyes."""


@dataclass(frozen=True, slots=True)
class _Away:
    """A look away, seconds; `thinking` ones go up and take more of the head."""

    index: int
    start: float
    end: float
    thinking: bool


def averts(life: Living) -> Iterable[Moved]:
    """The line of sight leaves the target, as far as the knob `avert` says (1: 30 deg), and the head goes along a bit.

    Never in a `look` with `for`, a `glance` or a `scan`, nor while the eyes go where the script sends them.
    """
    reach = AWAY * life.knob("avert")
    if reach <= 0.0:
        return
    found = tuple(_aways(life))
    places = [_direction(life, item, reach) for item in found]
    eyes = tuple(_there_and_back(found, 0.0, saccade_time(reach)))
    turn = tuple(_there_and_back(found, HEAD_LAG, head_time(reach * 0.4)))
    for axis, name in enumerate(("yaw", "pitch")):
        sight = [pose for place in places for pose in (place[axis], 0.0)]
        head = [(0.4 if item.thinking else 0.1) * place[axis] for item, place in zip(found, places, strict=True)]
        along = [pose for part in head for pose in (part, 0.0)]
        yield moved(steps(eyes, sight.__getitem__), **{f"gaze_{name}": 1.0})
        yield moved(steps(turn, along.__getitem__), **{f"head_{name}": 1.0})


def _there_and_back(found: Sequence[_Away], lag: float, length: float) -> Iterator[Event]:
    for number, item in enumerate(found):
        yield Event(2 * number, item.start + lag, item.start + lag + length)
        yield Event(2 * number + 1, item.end + lag, item.end + lag + length)


def _direction(life: Living, item: _Away, reach: float) -> tuple[float, float]:
    """Where a look away goes, deg: aside, up or down (70, 10, 20 % idly; 10, 70, 20 % in thought; `motion.md` 8)."""
    name = "think" if item.thinking else "avert"
    way = life.dice.chance(name, item.index, "way")
    aside, up = (0.1, 0.8) if item.thinking else (0.7, 0.8)
    side = 0.0 if life.dice.chance(name, item.index, "side") < 0.5 else pi
    middle, height = (side, 1.0) if way < aside else (pi / 2.0, 0.6) if way < up else (-pi / 2.0, 0.6)
    far = reach * height * life.dice.between(0.6, 1.0, name, item.index, "far")
    turn = middle + life.dice.between(-0.4, 0.4, name, item.index, "turn")
    return far * cos(turn), far * sin(turn)


def _aways(life: Living) -> Iterator[_Away]:
    """All looks away that may be, in time order."""
    turns = Stretches(_turns(life.lines))
    busy = Stretches(_busy(life.acts))
    thoughts = tuple(
        item for item in _thoughts(life, turns) if busy.next(item.start - SETTLING)[0] > item.end + SETTLING
    )
    held = [(item.start, item.end) for item in thoughts]
    held += [(max(end - BACK, start + THINKING_AFTER[0]), end) for start, end in turns]
    yield from sorted((*thoughts, *_idle(life, turns, Stretches((*busy, *held)))), key=lambda item: item.start)


def _thoughts(life: Living, turns: Stretches) -> Iterator[_Away]:
    clear = life.start
    for index, (turn, _) in enumerate(turns):
        start = turn - life.dice.normal(*THINKING_BEFORE, "think", index, "before")
        end = turn + life.dice.normal(*THINKING_AFTER, "think", index, "after")
        if start >= clear and end + SETTLING <= life.end:
            yield _Away(index, start, end, True)
            clear = end + SETTLING


def _idle(life: Living, turns: Stretches, closed: Stretches) -> Iterator[_Away]:
    """Looks away now and then. None begins in a stretch that is `closed`; one that would run into it ends before."""
    time, index = life.start, 0
    while time < life.end:
        speaking = turns.next(time)[0] <= time
        on, away = (SPEAKING, SPEAKING_AWAY) if speaking else (LISTENING, LISTENING_AWAY)
        start = time + max(SETTLING, life.dice.normal(*on, "avert", index, "on"))
        end = start + max(SETTLING, life.dice.normal(*away, "avert", index, "away"))
        shut, opened = closed.next(start - SETTLING)
        latest = min(shut, life.end) - SETTLING
        time = min(end, latest)
        if end > latest and latest - start < SETTLING:
            time = max(start, min(opened, life.end))
        else:
            yield _Away(index, start, time, False)
        index += 1


class Stretches:
    """Stretches of time that do not overlap, made of some that may: start and end in seconds."""

    def __init__(self, stretches: Iterable[tuple[float, float]]) -> None:
        self._all: list[tuple[float, float]] = []
        for start, end in sorted(stretches):
            if self._all and start <= self._all[-1][1]:
                self._all[-1] = self._all[-1][0], max(end, self._all[-1][1])
            else:
                self._all.append((start, end))
        self._ends = [end for _, end in self._all]

    def __iter__(self) -> Iterator[tuple[float, float]]:
        return iter(self._all)

    def next(self, time: float) -> tuple[float, float]:
        """The first that ends after `time`; one that never comes where there is none."""
        index = bisect_right(self._ends, time)
        return self._all[index] if index < len(self._all) else (inf, inf)


def _turns(lines: Sequence[TimedLine]) -> Iterator[tuple[float, float]]:
    """Stretches of speech with no silence of `TURN_GAP` in them."""
    start = end = None
    for line in lines:
        if start is None or end is None:
            start = line.start
        elif line.start - end >= TURN_GAP:
            yield start, end
            start = line.start
        end = line.end
    if start is not None and end is not None:
        yield start, end


def _busy(acts: Sequence[TimedAct]) -> Iterator[tuple[float, float]]:
    """When the script has the eyes to itself."""
    for act in acts:
        if isinstance(act.verb, (Glance, Scan)) or (isinstance(act.verb, Look) and act.verb.timing.lasting is not None):
            yield act.start, act.end
        for plan in act.plan:
            yield plan.starts, max(plan.landed, plan.head_done)
