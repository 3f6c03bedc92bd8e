"""Key places of a moving target to its place at any time: smooth between the keys, still before and after them."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

from facescript.ir.values import Point

Piece = tuple[float, float, float, float]
"""One coordinate between two keys: its value and its slope (times the span) at the first, then at the second."""


class Path:
    """The place at a time: each coordinate a monotone cubic through its keys (Fritsch and Butland's slopes).

    It never overshoots a key, and its speed is continuous, zero at the first and the last key.
    """

    def __init__(self, times: Sequence[float], places: Sequence[Point]) -> None:
        self.times, self.places = times, places
        self._spans: dict[int, tuple[Piece, ...]] = {}

    def at(self, time: float) -> Point:
        times = self.times
        if time <= times[0] or len(times) == 1:
            return self.places[0]
        if time >= times[-1]:
            return self.places[-1]
        index = bisect_right(times, time) - 1
        u = (time - times[index]) / (times[index + 1] - times[index])
        x, y, z = (_cubic(piece, u) for piece in self._span(index))
        return Point(x, y, z)

    def _span(self, index: int) -> tuple[Piece, ...]:
        """The pieces of x, y and z from the key `index` to the next; worked out once."""
        known = self._spans.get(index)
        if known is None:
            known = self._spans[index] = tuple(self._piece(axis, index) for axis in "xyz")
        return known

    def _piece(self, axis: str, index: int) -> Piece:
        first = max(0, index - 1)
        near = [getattr(place, axis) for place in self.places[first : index + 3]]
        here, span = index - first, self.times[index + 1] - self.times[index]
        start, end = (_slope(self.times, near, first, here + side) * span for side in (0, 1))
        return near[here], start, near[here + 1], end


def _cubic(piece: Piece, u: float) -> float:
    """The Hermite cubic of a piece at the part `u` of its span."""
    low, start, high, end = piece
    return (
        low * (1 + 2 * u) * (1 - u) ** 2 + start * u * (1 - u) ** 2 + high * u * u * (3 - 2 * u) + end * u * u * (u - 1)
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
