"""Turns a life into blinks: those that come by themselves, and those that go with large gaze shifts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from math import exp

from facescript.motion.dice import Event, events
from facescript.motion.gesture import blink_profile
from facescript.motion.life_model import Living, Moved, moved, pulses

LENGTH = 0.236
"""Mean seconds of a spontaneous blink: its closing phase, 28 % of it, takes 66 ms (`motion.md` 5, bar B3)."""

SPREAD = 0.15
"""How far a blink's length strays from the mean."""

VARIATION = 0.6
"""Coefficient of variation of the intervals: 5.2 +- 3.1 s (pubmed 21345986, bar B2)."""

THETA = 1.48
"""The announcer's wait: gamma with shape 2 and this scale in seconds, from the end of a blink (`thesis` 4.3)."""

ANNOUNCER_RATE = 60.0 / (2.0 * THETA + LENGTH)
"""The announcer's blinks a minute where no knob says otherwise."""

COMPLETE = 0.44
"""Share of blinks that shut the eye, or almost; the others go mostly 51 to 75 % of the way (Sforza 2008, bar B5)."""


def blinks(life: Living) -> Iterable[Moved]:
    """Both lids, at the rate of the knob `blink` (1/min), besides the blinks of gaze shifts."""
    rate = life.knobs.get("blink", ANNOUNCER_RATE if life.announcing else 0.0)
    if rate <= 0.0:
        return
    evoked = tuple(_evoked(life))
    free = (event for event in _spontaneous(life, rate) if not any(_near(event, other) for other in evoked))
    for found, kind, low in ((free, "blink", 0.51), (evoked, "gaze blink", 0.8)):
        yield moved(pulses(found, _heights(life, kind, low), blink_profile), blink_left=1.0, blink_right=1.0)


def evoked_chance(amplitude: float) -> float:
    """How likely a gaze shift of `amplitude` deg is to bring a blink: 2 % at 10, 97 % at 33 (Evinger 1994, bar H10)."""
    return 1.0 / (1.0 + exp(-(amplitude - 22.0) / 3.2))


def _spontaneous(life: Living, rate: float) -> Iterator[Event]:
    wait = max(60.0 / rate - LENGTH, LENGTH)

    def gap(index: int) -> float:
        if life.announcing:
            found = life.dice.gamma(wait / 2.0, "blink", index, "gap")
        else:
            found = life.dice.log_normal(wait, VARIATION, "blink", index, "gap")
        return found if index else found * life.dice.chance("blink", 0, "phase")

    return events(life.start, life.end, gap, lambda index: _length(life, "blink", index))


def _evoked(life: Living) -> Iterator[Event]:
    """Blinks that set off with eyes or head, whichever is first (bar H11)."""
    plans = (plan for act in life.acts for plan in act.plan if life.start <= plan.starts < life.end)
    clear = life.start
    for index, plan in enumerate(sorted(plans, key=lambda plan: plan.starts)):
        if plan.starts < clear or plan.instant:
            continue
        if life.dice.chance("gaze blink", index, "happens") < evoked_chance(plan.amplitude):
            clear = plan.starts + _length(life, "gaze blink", index)
            yield Event(index, plan.starts, clear)


def _near(event: Event, other: Event) -> bool:
    """Whether two blinks would run into one another."""
    return event.start < other.end + LENGTH and other.start < event.end + LENGTH


def _length(life: Living, kind: str, index: int) -> float:
    return LENGTH * life.dice.between(1.0 - SPREAD, 1.0 + SPREAD, kind, index, "length")


def _heights(life: Living, kind: str, low: float) -> Callable[[int], float]:
    """How far each blink shuts the eye (0..1); those that are not complete start at `low`."""

    def height(index: int) -> float:
        if life.dice.chance(kind, index, "complete") < COMPLETE:
            return life.dice.between(0.95, 1.0, kind, index, "height")
        return life.dice.between(low, low + 0.24, kind, index, "height")

    return height
