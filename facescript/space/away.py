"""What is looked at to somewhere else, where a look away goes: by the seed, as far and in the directions people do."""

from __future__ import annotations

from facescript.ir.random import between, chance
from facescript.ir.values import Towards
from facescript.space.reach import Direction

COMFORT = (28.0, 14.0, 20.0)
"""How far a look away goes from straight ahead at most: sideways, up, down, deg."""

AWAY = (12.0, 20.0)
"""How far a look away goes from what it leaves, deg."""


def averted(leaving: Direction, seed: int, *place: object) -> Towards:
    """Somewhere else than `leaving`, by the seed: seven in ten to a side, two down, one up (motion.md section 8)."""
    draw, size = chance(seed, "away", *place, "where"), between(*AWAY, seed, "away", *place, "size")
    side, up, down = COMFORT
    if draw < 0.7:
        way = size if draw < 0.35 else -size
        yaw = leaving[0] + way if abs(leaving[0] + way) <= side else leaving[0] - way
        return Towards(min(side, max(-side, yaw)), min(up, max(-down, leaving[1])))
    way = -size if draw < 0.9 else size
    pitch = leaving[1] + way if -down <= leaving[1] + way <= up else leaving[1] - way
    return Towards(min(side, max(-side, leaving[0])), min(up, max(-down, pitch)))
