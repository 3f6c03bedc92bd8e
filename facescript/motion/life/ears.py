"""Turns a life into flicks of an ear, for faces whose ears move."""

from __future__ import annotations

from collections.abc import Iterable

from facescript.motion.dice import Event
from facescript.motion.life.model import Living, Moved, going_on, moved, pulses
from facescript.performance.channels import SIDES
from facescript.performance.easing import through

SHORTEST, LONGEST = 0.28, 0.45
"""Seconds that a flick takes (ours)."""

VARIATION = 0.6
"""Coefficient of variation of the waits, as for blinks."""

FAINTEST, STRONGEST = 0.25, 0.6
"""How far the ear goes back (ours)."""

BOTH = 0.15
"""Share of flicks that both ears make."""

FLICK = through((0.0, 0.0), (0.22, -1.0), (0.42, 0.25), (0.62, -0.5), (1.0, 0.0))
"""Back, a little over, back again and at rest, by the share of its length."""


def ears(life: Living) -> Iterable[Moved]:
    """One ear or both, as often as the knob `brows` says: what brows are to people, ears are to an animal."""
    rate = life.knobs.get("brows", life.station.brow_rate if life.announcing else 0.0)
    if rate <= 0.0 or "ear.left" not in life.channels:
        return
    mean = max(60.0 / rate - (SHORTEST + LONGEST) / 2.0, LONGEST)
    dice = life.dice
    found = tuple(
        going_on(
            life,
            "ears",
            lambda number: dice.log_normal(mean, VARIATION, "ears", number, "gap"),
            lambda number: dice.between(SHORTEST, LONGEST, "ears", number, "length"),
        )
    )
    for side in SIDES:
        flicks = (event for event in found if side in _sides(life, event))
        curve = pulses(flicks, lambda number: dice.between(FAINTEST, STRONGEST, "ears", number, "height"), FLICK)
        yield moved(curve, **{f"ear_{side}": 1.0})


def _sides(life: Living, event: Event) -> tuple[str, ...]:
    drawn = life.dice.chance("ears", event.index, "side")
    if drawn < BOTH:
        return SIDES
    return SIDES[:1] if drawn < (1.0 + BOTH) / 2.0 else SIDES[1:]
