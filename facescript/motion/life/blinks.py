"""Turns a life into blinks: those that come by themselves, and those that go with large gaze shifts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from math import exp

from facescript.motion.dice import Dice, Event
from facescript.motion.gesture import blink_profile
from facescript.motion.life.model import Living, Moved, moved, pulses
from facescript.motion.life.occasions import Shift
from facescript.motion.life.renewal import Span, gamma_wait, log_normal_wait, renewals
from facescript.motion.life.stations import THETA
from facescript.motion.life.stretches import Stretches

LENGTH = 0.236
"""Mean seconds of a spontaneous blink: its closing phase, 28 % of it, takes 66 ms (`motion.md` 5, bar B3)."""

SPREAD = 0.15
"""How far a blink's length strays from the mean."""

LONGEST = LENGTH * (1.0 + SPREAD)
"""Seconds the longest blink takes."""

CLEAR = LONGEST + LENGTH
"""Seconds before a blink of a gaze shift in which no other begins."""

VARIATION = 0.6
"""Coefficient of variation of the intervals: 5.2 +- 3.1 s (pubmed 21345986, bar B2)."""

ANNOUNCER_RATE = 60.0 / (2.0 * THETA + LENGTH)
"""The announcer's blinks a minute where no knob says otherwise."""

COMPLETE = 0.44
"""Share of blinks that shut the eye, or almost; the others go mostly 51 to 75 % of the way (Sforza 2008, bar B5)."""


def blinks(life: Living) -> Iterable[Moved]:
    """Both lids, at the rate of the knob `blink` (1/min), besides the blinks of gaze shifts.

    A blink of a gaze shift begins the wait for the next anew, and no other begins just before it.
    """
    rate = life.knobs.get("blink", ANNOUNCER_RATE if life.announcing else 0.0)
    if rate <= 0.0:
        return
    evoked = tuple(_evoked(life))
    heights = [_height(life.dice.at(*shift.place), "gaze blink", 0, 0.8) for shift, _ in evoked]
    yield _lids([event for _, event in evoked], heights.__getitem__)
    free = tuple(_spontaneous(life, rate, Stretches((event.start, event.end) for _, event in evoked)))
    yield _lids(free, lambda number: _height(life.dice, "blink", number, 0.51))


def evoked_chance(amplitude: float) -> float:
    """How likely a gaze shift of `amplitude` deg is to bring a blink: 2 % at 10, 97 % at 33 (Evinger 1994, bar H10)."""
    return 1.0 / (1.0 + exp(-(amplitude - 22.0) / 3.2))


def _lids(found: Sequence[Event], height: Callable[[int], float]) -> Moved:
    return moved(pulses(found, height, blink_profile), blink_left=1.0, blink_right=1.0)


def _spontaneous(life: Living, rate: float, evoked: Stretches) -> Iterator[Event]:
    mean = max(60.0 / rate - LENGTH, LENGTH)
    wait = gamma_wait(mean / 2.0) if life.announcing else log_normal_wait(mean, VARIATION)
    span = Span(life.start, life.end, mean * life.dice.chance("blink", 0, "waited"))
    return renewals(
        life.dice, "blink", wait, span, lambda number: _length(life.dice, "blink", number), evoked, CLEAR, life.memory
    )


def _evoked(life: Living) -> Iterator[tuple[Shift, Event]]:
    """Blinks that set off with eyes or head, whichever is first (bar H11)."""
    clear, found, memory = life.start, 0, life.memory
    known = memory.state(life.dice, "gaze blink") if memory else None
    if known is not None:
        shift, event = known
        yield shift, Event(found, event.start, event.end)
        clear, found = shift.start + LONGEST, found + 1
    for shift in life.occasions.shifts(life.since, life.end):
        dice = life.dice.at(*shift.place)
        if shift.start >= clear and dice.chance("gaze blink", 0, "happens") < evoked_chance(shift.amplitude):
            event = Event(found, shift.start, shift.start + _length(dice, "gaze blink", 0))
            if memory is not None:
                memory.note(life.dice, "gaze blink", shift.start, (shift, event))
            yield shift, event
            clear, found = shift.start + LONGEST, found + 1


def _length(dice: Dice, behaviour: str, number: int) -> float:
    return LENGTH * dice.between(1.0 - SPREAD, 1.0 + SPREAD, behaviour, number, "length")


def _height(dice: Dice, behaviour: str, number: int, low: float) -> float:
    """How far a blink shuts the eye (0..1); those that are not complete start at `low`."""
    if dice.chance(behaviour, number, "complete") < COMPLETE:
        return dice.between(0.95, 1.0, behaviour, number, "height")
    return dice.between(low, low + 0.24, behaviour, number, "height")
