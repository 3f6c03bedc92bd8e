"""How opaque a shape is over time to its attributes and animations, none of which is in effect where nothing changes.

Chromium works out a style anew in every frame for each animation of `opacity` in effect, one that has come to rest and
holds its last value as well: where most shapes' opacity rests, that took a third of all animating.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from lxml import etree

from facescript.backends.svg.track import Track, svg

REST = 1.0
"""Seconds: a shorter rest between two changes is not worth an animation more."""

NEAR = 0.1
"""How far the opacity without any animation may be from the first one: programs that play nothing show it."""


def shade(element: etree._Element, opacity: Track) -> None:
    """Give a path its opacity: as its fill's where it never changes, for which browsers need no layer."""
    if opacity.still:
        if opacity.values[0] != "1":
            element.set("fill-opacity", opacity.values[0])
        return
    resting = _resting(opacity)
    element.set("opacity", resting)
    for first, last in _stretches(opacity, resting):
        element.append(_animation(opacity.times[first : last + 1], opacity.values[first : last + 1], resting))


def _resting(opacity: Track) -> str:
    """The value that is held longest, of those near the first."""
    first = float(opacity.values[0])
    held = {opacity.values[0]: 0.0}
    for (start, value), (end, next_value) in pairwise(zip(opacity.times, opacity.values, strict=True)):
        if value == next_value and abs(float(value) - first) < NEAR:
            held[value] = held.get(value, 0.0) + end - start
    return max(held, key=lambda value: held[value])


def _stretches(opacity: Track, resting: str) -> Iterator[tuple[int, int]]:
    """The first and last key frame of each stretch that is not all at rest."""
    times, values = opacity.times, opacity.values
    first = last = -1
    for key in range(len(times) - 1):
        if values[key] == values[key + 1] == resting:
            continue
        if first >= 0 and times[key] - times[last] >= REST:
            yield first, last
            first = -1
        first, last = key if first < 0 else first, key + 1
    yield first, last


def _animation(times: Sequence[float], values: Sequence[str], resting: str) -> etree._Element:
    """One stretch; it holds its last value where that is not the resting one."""
    start, length = times[0], times[-1] - times[0]
    begin = {"begin": f"{start:.6f}".rstrip("0").rstrip(".") + "s"} if start > 0 else {}
    freeze = {"fill": "freeze"} if values[-1] != resting else {}
    words = {"dur": f"{length:.6f}".rstrip("0").rstrip(".") + "s", "values": ";".join(values)}
    words["keyTimes"] = ";".join(_part((time - start) / length) for time in times)
    return svg("animate", attributeName="opacity", **begin, **freeze, **words)


def _part(share: float) -> str:
    """A key time, to a hundred thousandth, without what need not be written."""
    return f"{share:.5f}".rstrip("0").rstrip(".").removeprefix("0") or "0"
