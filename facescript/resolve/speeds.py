"""`speed 80%` of a line to how much faster or slower than usual it is done."""

from __future__ import annotations

from facescript.ir.values import Amount
from facescript.resolve.arithmetic import bounds
from facescript.resolve.lines import Line
from facescript.resolve.units import SHARE, written


def speed_of(line: Line, slowest: float, fastest: float, who: str) -> Amount:
    """The speed, 1 where none is written; `who` begins the sentence that tells its limits. Raises `Refused`."""
    speed = line.amount("speed", SHARE)
    if speed is None:
        return 1.0
    low, high = bounds(speed)
    if low < slowest or high > fastest:
        span = line.spans["speed"]
        limits = f"{who} {written(SHARE, slowest)} to {written(SHARE, fastest)} of the usual speed"
        raise line.project.refuse("FS304", span, text=span.text, limits=limits)
    return speed
