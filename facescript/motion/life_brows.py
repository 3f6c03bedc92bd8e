"""Turns a life into brow raises, there and back."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import zip_longest

import numpy as np

from facescript.motion.dice import Event, events
from facescript.motion.life_model import Living, Moved, accents, moved, pulses
from facescript.performance.easing import through

SHORTEST, LONGEST = 0.51, 0.99
"""Seconds from the start of a raise to the end of its lowering (`thesis` 4.4)."""

SOONEST, LATEST = 0.90, 12.54
"""The announcer's seconds from the end of a raise to the start of the next, uniform (`thesis` 4.4)."""

ANNOUNCER_RATE = 120.0 / (SHORTEST + LONGEST + SOONEST + LATEST)
"""The announcer's raises a minute where no knob says otherwise."""

VARIATION = 0.6
"""Coefficient of variation of the others' intervals, as for blinks."""

FAINTEST, STRONGEST = 0.2, 0.5
"""How far the frontalis contracts (ours: the thesis gives no sizes)."""

PEAK = 0.35
"""The share of a raise's length after which it is highest."""

LEAD, REACH = 0.06, 0.6
"""Seconds by which the peak of a raise comes before an accent, and how far it is moved for that (bar L4)."""

RAISE = through((0.0, 0.0), (PEAK, 1.0), (0.6, 1.0), (1.0, 0.0))


def brows(life: Living) -> Iterable[Moved]:
    """AU1 and AU2 of both sides, at the rate of the knob `brows` (1/min)."""
    rate = life.knobs.get("brows", ANNOUNCER_RATE if life.announcing else 0.0)
    if rate <= 0.0:
        return
    wait = max(60.0 / rate - (SHORTEST + LONGEST) / 2.0, SHORTEST)
    dice = life.dice

    def gap(index: int) -> float:
        if life.announcing:
            scale = 2.0 * wait / (SOONEST + LATEST)
            return scale * dice.between(SOONEST, LATEST, "brows", index, "gap")
        return dice.log_normal(wait, VARIATION, "brows", index, "gap")

    found = events(life.start, life.end, gap, lambda k: dice.between(SHORTEST, LONGEST, "brows", k, "length"))
    if not life.announcing:
        found = _with_accents(tuple(found), tuple(accents(life.lines)))
    curve = pulses(found, lambda k: dice.between(FAINTEST, STRONGEST, "brows", k, "height"), RAISE)
    yield moved(curve, **{f"brow_{part}_{side}": 1.0 for part in ("inner", "outer") for side in ("left", "right")})


def _with_accents(found: Sequence[Event], accented: Sequence[float]) -> Iterator[Event]:
    """The raises, those near an accent of the face's speech moved so that they peak just before it."""
    clear = 0.0
    for event, after in zip_longest(found, found[1:]):
        peak = event.start + PEAK * (event.end - event.start) + LEAD
        shift = min((accent - peak for accent in accented), key=abs, default=np.inf)
        start, end = event.start + shift, event.end + shift
        fits = abs(shift) <= REACH and start >= clear and (after is None or end <= after.start)
        yield Event(event.index, start, end) if fits else event
        clear = end if fits else event.end
