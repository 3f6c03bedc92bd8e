"""Ranges to ticks: where they stand and how they are written; times to pixels."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor, log10

CLOCK = (1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0)
"""Steps of time from one second on, s."""

LONG = 120.0
"""From this time on times are written as minutes and seconds, s."""

APART = 70.0
"""Pixels from one tick of time to the next, at least."""


@dataclass(frozen=True, slots=True)
class Scale:
    """The time axis: seconds `start` to `end` from `left` to `right`, px."""

    left: float
    right: float
    start: float
    end: float

    @property
    def columns(self) -> int:
        """Whole pixels from left to right."""
        return max(1, int(self.right - self.left))

    @property
    def second(self) -> float:
        """Pixels a second."""
        return (self.right - self.left) / (self.end - self.start)

    def x(self, time: float) -> float:
        """Where a time is; what lies outside is at the edge."""
        return self.left + (min(max(time, self.start), self.end) - self.start) * self.second

    def shows(self, start: float, end: float) -> bool:
        """Whether something from `start` to `end` can be seen."""
        return start < self.end and end > self.start

    def ticks(self) -> list[tuple[float, str]]:
        """Times worth a line, and how they are written."""
        step = time_step((self.end - self.start) / ((self.right - self.left) / APART))
        return [(time, written_time(time, step, self.end)) for time in ticks(self.start, self.end, step)]


def time_step(least: float) -> float:
    """The next round step of time from `least` s on."""
    if least <= CLOCK[0]:
        return round_step(least)
    return next((step for step in CLOCK if step >= least), ceil(least / CLOCK[-1]) * CLOCK[-1])


def round_step(least: float) -> float:
    """The next of 1, 2, 5, 10, 20, ... (and 0.5, 0.2, ...) from `least` on."""
    size = 10.0 ** floor(log10(least))
    return next(factor * size for factor in (1.0, 2.0, 5.0, 10.0) if factor * size >= least * (1 - 1e-9))


def ticks(low: float, high: float, step: float) -> list[float]:
    """The multiples of `step` from `low` to `high`."""
    first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
    return [number * step for number in range(first, last + 1)]


def written_time(time: float, step: float, end: float) -> str:
    """A time as 2.5, or in what is long as 1:30."""
    decimals = max(0, ceil(-log10(step) - 1e-9))
    if end < LONG:
        return f"{time:.{decimals}f}"
    minutes, seconds = divmod(round(time, decimals), 60)
    return f"{minutes:.0f}:{seconds:0{3 + decimals if decimals else 2}.{decimals}f}"


def written(value: float, step: float) -> str:
    """A value with as many decimals as its step needs."""
    text = f"{value:.{max(0, ceil(-log10(step) - 1e-9))}f}"
    return text.lstrip("-") if float(text) == 0 else text
