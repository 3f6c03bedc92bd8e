"""Turns a life into looks away from the target: now and then, and while a turn to speak is thought out.

The sources disagree. Eyes Alive (Lee, Badler, Badler 2002) has the eyes on the partner for 41 % of the time that one
speaks and for 75 % that one listens, yet 3.13 s on the partner and 0.93 s away when speaking: 77 %. Both hold where the
0.93 s are what lies between two saccades, as its authors measured it: one looks away for several fixations. So it is
here: the times on the partner and of each fixation away are theirs, and the number of fixations is what the 41 and 75 %
make of them, 4.8 when speaking and 6.1 when listening. Argyle's 40 and 60 to 70 % agree (bars C1 and C2). Their means
and deviations cannot be normal, for a normal wait would often be negative: they are log-normal here. Andrist 2013 has
one look away of 1.96 or 1.14 s instead; he is followed for what Eyes Alive knows nothing of: looks away to think, and
back before a turn ends (bar C3). `motion.md`, 3.2 and 8.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import cos, exp, hypot, inf, log, pi, sin

from facescript.motion.dice import Dice
from facescript.motion.life.fixations import TARGET, Fixation, Offset, fixation
from facescript.motion.life.memory import Memory
from facescript.motion.life.model import Living
from facescript.motion.life.occasions import Turn
from facescript.motion.life.renewal import Span, log_normal_wait, renewals
from facescript.motion.life.stretches import Stretches

MEAN_SIZE, LARGEST_CHANCE, SCALE = 6.9, 15.0, 15.7
"""A saccade is -6.9 ln(P / 15.7) deg, P uniform up to 15 (Eyes Alive): 0.31 deg and more."""

DIRECTIONS = (15.54, 6.46, 17.69, 7.44, 16.80, 7.89, 20.38, 7.79)
"""Percent of saccades by direction: the viewer's right, right and up, up, and so on round (Eyes Alive)."""

LEAVING = 3.0
"""Deg from the target that is away: a gaze is felt as direct within 4 to 6 deg in all (`motion.md` 9)."""


@dataclass(frozen=True, slots=True)
class Manner:
    """Means (s) and coefficients of variation of the times on the partner and of a fixation away, the share of the time
    that the eyes are on the partner, and how far (deg) they go at most: Eyes Alive, its frames read at 30 a second."""

    on: tuple[float, float]
    away: tuple[float, float]
    share: float
    furthest: float

    @property
    def going_on(self) -> float:
        """How likely a fixation away is to be followed by another one."""
        return 1.0 - self.away[0] * self.share / (self.on[0] * (1.0 - self.share))


SPEAKING = Manner((3.13, 3.16 / 3.13), (0.93, 0.80 / 0.93), 0.41, 27.5)
LISTENING = Manner((7.92, 1.57 / 7.92), (0.43, 0.24 / 0.43), 0.75, 22.7)

BRIEFEST, MOST = 0.15, 15
"""Seconds of the shortest fixation away, and the most of them in one look away."""

CLOSE = 1e-6
"""Seconds within which two times are one: a last fixation as short as can be is one wherever in the film it is."""

THINKING_BEFORE, THINKING_AFTER, BACK = (1.0, 0.25), (1.2, 0.25), (2.3, 0.5)
"""Mean and deviation of the seconds that a thoughtful look away starts before a turn, and ends after its start, and
that the eyes are back on the partner before its end (Andrist 2013)."""

SOONEST, LATEST = 0.5, 4.0
"""Seconds that the first and the last of these keep to; the eyes are back half a second before a turn's end anyway."""

BACK_SHARE, LEAST_SHARE = 0.2, 0.2
"""The part of a turn that the look back takes at most, and of the talk before it that is on the partner at least."""

SETTLING = 0.6
"""Seconds before a gaze shift and such by which a look away is over, and of the shortest: the head comes to rest."""

IDLE_HEAD, THINKING_HEAD = 0.1, 0.4
"""The part of a look away that the head goes along (Andrist 2013)."""


@dataclass(frozen=True, slots=True)
class Away:
    """A look away, seconds: its fixations, and how far the head goes along (yaw and pitch, deg)."""

    start: float
    end: float
    fixations: tuple[Fixation, ...]
    head: Offset


def looks_away(life: Living, reach: float) -> Iterator[Away]:
    """Looks away of `reach` deg at most, in time order. None is in a `look` with `for`, a `glance` or a `scan`, nor
    while the eyes go where the script sends them."""
    turns = life.occasions.turns(life.start, life.end)
    busy = [(start - SETTLING, end) for start, end in life.occasions.busy.within(life.start - 1.0, life.end + 1.0)]
    busy.append((life.end - SETTLING, inf))
    thoughts = tuple(_thoughts(life, turns, reach, Stretches(busy)))
    busy += [(item.start - SETTLING, item.end) for item in thoughts]
    silent = Stretches([*busy, *((turn.start - SETTLING, turn.end) for turn in turns)])
    found = [*thoughts, *_idle(life.dice, LISTENING, life.start, life.end, silent, reach, life.memory)]
    held = Stretches([*busy, *((turn.end - _back(life, turn), turn.end + SETTLING) for turn in turns)])
    for turn in turns:
        start, end, manner = max(turn.start, life.start), min(turn.end, life.end), _talking(life, turn)
        found += _idle(life.dice.at(*turn.place), manner, start, end, held, reach, life.memory)
    yield from sorted(found, key=lambda item: item.start)


def _back(life: Living, turn: Turn) -> float:
    """Seconds before the end of a turn from which the eyes are on the partner."""
    drawn = life.dice.at(*turn.place).normal(*BACK, "think", 0, "back")
    return min(LATEST, max(SOONEST, min(drawn, BACK_SHARE * (turn.end - turn.start))))


def _talking(life: Living, turn: Turn) -> Manner:
    """The manner between the look away to think and the look back: together they come to the share on the partner."""
    lasts, back = turn.end - turn.start, _back(life, turn)
    share = (SPEAKING.share * lasts - back) / max(lasts - THINKING_AFTER[0] - back, SOONEST)
    return replace(SPEAKING, share=min(SPEAKING.share, max(LEAST_SHARE, share)))


def _thoughts(life: Living, turns: Sequence[Turn], reach: float, busy: Stretches) -> Iterator[Away]:
    """The looks away about the starts of turns; a short answer needs no thought."""
    clear = life.start
    for turn in turns:
        dice = life.dice.at(*turn.place)
        start = turn.start - max(SOONEST, dice.normal(*THINKING_BEFORE, "think", 0, "before"))
        end = turn.start + dice.normal(*THINKING_AFTER, "think", 0, "after")
        start, end = max(start, clear), min(end, turn.end - SOONEST)
        if turn.start - start >= SETTLING / 2.0 and end > turn.start and busy.next(start)[0] >= end:
            first = _thoughtful(dice, reach)
            yield _away(dice, "think", 0, SPEAKING, (start, end), first, reach, THINKING_HEAD)
        clear = turn.end + SETTLING / 2.0


def _idle(
    dice: Dice, manner: Manner, start: float, end: float, closed: Stretches, reach: float, memory: Memory | None
) -> Iterator[Away]:
    """Looks away now and then from `start` to `end`, none of them `closed`."""
    reach = min(reach, manner.furthest)
    wait = log_normal_wait(*manner.on)

    def lasting(number: int) -> float:
        return max(SETTLING, sum(_stays(dice, "avert", number, manner)))

    for item in renewals(dice, "avert", wait, Span(start, end), lasting, closed, SETTLING, memory):
        first = _saccade(dice, f"avert {item.index}", 0, min(LEAVING, 0.6 * reach), reach)
        yield _away(dice, "avert", item.index, manner, (item.start, item.end), first, reach, IDLE_HEAD)


def _away(
    dice: Dice, behaviour: str, number: int, manner: Manner, span: tuple[float, float], first: Offset, reach: float,
    share: float
) -> Away:  # fmt: skip
    """A look away to `first` and, where it lasts, on from there."""
    start, end = span
    found, here, time = [fixation(start, first)], first, start
    for step, stay in enumerate(_stays(dice, behaviour, number, manner), 1):
        time += stay
        if time > end - BRIEFEST + CLOSE:
            break
        here = _onwards(dice, f"{behaviour} {number}", step, here, reach)
        found.append(fixation(time, here))
    found.append(fixation(end, TARGET))
    return Away(start, end, tuple(found), (share * first[0], share * first[1]))


def _stays(dice: Dice, behaviour: str, number: int, manner: Manner) -> Iterator[float]:
    """Seconds of the fixations of a look away, one after another."""
    for step in range(MOST):
        yield max(BRIEFEST, dice.log_normal(*manner.away, f"{behaviour} {number}", step, "stay"))
        if dice.chance(f"{behaviour} {number}", step, "on") >= manner.going_on:
            return


def _saccade(dice: Dice, behaviour: str, number: int, least: float, most: float) -> Offset:
    """A saccade of `least` to `most` deg: its way."""
    low, high = SCALE * exp(-most / MEAN_SIZE), min(LARGEST_CHANCE, SCALE * exp(-least / MEAN_SIZE))
    size = -MEAN_SIZE * log(dice.between(low, high, behaviour, number, "size") / SCALE)
    drawn, turn = dice.between(0.0, sum(DIRECTIONS), behaviour, number, "way"), 0
    while turn < 7 and drawn >= DIRECTIONS[turn]:
        drawn -= DIRECTIONS[turn]
        turn += 1
    angle = (turn - 0.5 + dice.chance(behaviour, number, "turn")) * pi / 4.0
    return size * cos(angle), size * sin(angle)


TRIES = 8
"""Draws of a further saccade; where all of them end out of reach or on the target, the eyes stay."""


def _onwards(dice: Dice, behaviour: str, step: int, here: Offset, reach: float) -> Offset:
    """Where the eyes go next when they are away: neither back to the target nor beyond `reach`."""
    for attempt in range(TRIES):
        yaw, pitch = _saccade(dice, behaviour, TRIES * step + attempt, 0.0, reach)
        there = here[0] + yaw, here[1] + pitch
        if min(LEAVING, 0.6 * reach) <= hypot(*there) <= reach:
            return there
    return here


def _thoughtful(dice: Dice, reach: float) -> Offset:
    """Where a look away to think goes: up (70 %), aside (10 %) or down (20 %; Andrist 2013)."""
    way = dice.chance("think", 0, "way")
    side = 0.0 if dice.chance("think", 0, "side") < 0.5 else pi
    middle, height = (side, 1.0) if way < 0.1 else (pi / 2.0, 0.6) if way < 0.8 else (-pi / 2.0, 0.6)
    far = reach * height * dice.between(0.6, 1.0, "think", 0, "far")
    turn = middle + dice.between(-0.4, 0.4, "think", 0, "turn")
    return far * cos(turn), far * sin(turn)
