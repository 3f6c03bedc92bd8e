"""Key places of a moving target to its place at any time: smooth between the keys, still before and after them."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

from facescript.ir.values import Point


def place_at(times: Sequence[float], places: Sequence[Point], time: float) -> Point:
    """The place at `time`: each coordinate a monotone cubic through its keys (Fritsch and Butland's slopes).

    It never overshoots a key, and its speed is continuous, zero at the first and the last key.
    """
    if time <= times[0] or len(times) == 1:
        return places[0]
    if time >= times[-1]:
        return places[-1]
    index = bisect_right(times, time) - 1
    x, y, z = (
        _cubic(times, [getattr(place, axis) for place in places[max(0, index - 1) : index + 3]], index, time)
        for axis in "xyz"
    )
    return Point(x, y, z)


def _cubic(times: Sequence[float], near: Sequence[float], index: int, time: float) -> float:
    """The Hermite cubic of the span `index`; `near` are the keys from one before the span to one after it."""
    first = max(0, index - 1)
    here = index - first
    span = times[index + 1] - times[index]
    u = (time - times[index]) / span
    slopes = [_slope(times, near, first, here + side) * span for side in (0, 1)]
    low, high = near[here], near[here + 1]
    return (
        low * (1 + 2 * u) * (1 - u) ** 2
        + slopes[0] * u * (1 - u) ** 2
        + high * u * u * (3 - 2 * u)
        + slopes[1] * u * u * (u - 1)
    )


def _slope(times: Sequence[float], near: Sequence[float], first: int, at: int) -> float:
    """Speed at the key `first + at`: a weighted harmonic mean of the spans beside it, zero at ends and turns."""
    key = first + at
    if key == 0 or key == len(times) - 1:
        return 0.0
    before, after = times[key] - times[key - 1], times[key + 1] - times[key]
    rise, fall = (near[at] - near[at - 1]) / before, (near[at + 1] - near[at]) / after
    if rise * fall <= 0.0:
        return 0.0
    left, right = 2 * after + before, after + 2 * before
    return (left + right) / (left / rise + right / fall)
