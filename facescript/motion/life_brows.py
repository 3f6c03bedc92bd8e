"""Turns a life into brow raises, there and back."""

from __future__ import annotations

from collections.abc import Iterable

from facescript.motion.dice import events
from facescript.motion.life_model import Living, Moved, moved, pulses
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

RAISE = through((0.0, 0.0), (0.35, 1.0), (0.6, 1.0), (1.0, 0.0))


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
    curve = pulses(found, lambda k: dice.between(FAINTEST, STRONGEST, "brows", k, "height"), RAISE)
    yield moved(curve, **{f"brow_{part}_{side}": 1.0 for part in ("inner", "outer") for side in ("left", "right")})
