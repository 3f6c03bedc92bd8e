"""Key places of a moving target to its place at any time: smooth between the keys, still before and after them."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

from facescript.ir.values import Point

Cubic = tuple[float, float, float, float]
"""One coordinate between two keys, as a cubic of the part 0..1 of the way: the factors of 1, u, u^2, u^3."""

KEPT = 1024
"""As many ways between two keys are kept worked out."""

Stretch = tuple[float, float]


class Path:
    """The place at a time: each coordinate a monotone cubic through its keys (Fritsch and Butland's slopes).

    It never overshoots a key, and its speed is continuous, zero at the first and the last key. In a stretch `lost` the
    place is the one at the stretch's start: nothing is known of another.
    """

    def __init__(self, times: Sequence[float], places: Sequence[Point], lost: Sequence[Stretch] = ()) -> None:
        self.times, self.places, self.lost = times, places, lost
        self._froms = [start for start, _ in lost]
        self._spans: dict[int, tuple[Cubic, ...]] = {}

    def known(self, time: float) -> float:
        """The time up to `time` at which it was last known where the target is."""
        stretch = bisect_right(self._froms, time) - 1
        return self._froms[stretch] if stretch >= 0 and time < self.lost[stretch][1] else time

    def at(self, time: float) -> Point:
        times = self.times
        if self.lost:
            time = self.known(time)
        if time <= times[0] or len(times) == 1:
            return self.places[0]
        if time >= times[-1]:
            return self.places[-1]
        index = bisect_right(times, time) - 1
        u = (time - times[index]) / (times[index + 1] - times[index])
        (a, b, c, d), (e, f, g, h), (i, j, k, m) = self._spans.get(index) or self._span(index)
        return Point(a + u * (b + u * (c + u * d)), e + u * (f + u * (g + u * h)), i + u * (j + u * (k + u * m)))

    def _span(self, index: int) -> tuple[Cubic, ...]:
        """The cubics of x, y and z from the key `index` to the next."""
        if len(self._spans) >= KEPT:
            self._spans.clear()
        made = self._spans[index] = tuple(self._cubic(axis, index) for axis in "xyz")
        return made

    def _cubic(self, axis: str, index: int) -> Cubic:
        first = max(0, index - 1)
        near = [getattr(place, axis) for place in self.places[first : index + 3]]
        here, span = index - first, self.times[index + 1] - self.times[index]
        start, end = (_slope(self.times, near, first, here + side) * span for side in (0, 1))
        low, way = near[here], near[here + 1] - near[here]
        return low, start, 3 * way - 2 * start - end, start + end - 2 * way


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
