"""Spoken lines to the mouth's channels over time, and to how much speech owns the mouth."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import MOUTH
from facescript.schedule.score import TimedLine
from facescript.speech.model import Spoken
from facescript.speech.mouth.effort import Effort, normal_level
from facescript.speech.mouth.mouthing import DECAY, PAUSE, breath, lead, mouth_shapes
from facescript.speech.mouth.room import GAP, arranged
from facescript.speech.mouth.shape import AXES, MouthShape
from facescript.speech.mouth.visemes import PLAIN, Table

Floats = NDArray[np.float64]
Numbers = NDArray[np.intp]

RISE, FALL = 0.12, 0.2
"""Seconds in which speech takes the mouth before its first movement, and gives it back after it has come to rest."""

LET_GO = 0.5
"""A rest as long as this inside speech gives the mouth back."""

AHEAD, LONGEST = 0.04, 0.25
"""Seconds by which the corners are at a rounded vowel before its other parts are, and the longest that they are on
their way to any shape."""

ROUNDING = 2.0
"""How much a rounded shape's dominance over the corners is above that of others: it is seen sooner and stays longer."""


class Axis:
    """One axis of the mouth: the shapes that hold it, and how it goes from one to the next.

    Every moment lies on a shape or on the way from one to the next, so that at most two weigh, the second's dominance
    rising by a smooth curve as the first's falls, and their weights are what each has of both. Curves have no corner.
    """

    def __init__(self, name: str, shapes: Sequence[MouthShape]) -> None:
        held = [index for index, shape in enumerate(shapes) if shape.holds(name)]
        self._place = np.array(held, dtype=np.intp)
        chosen = [shapes[index] for index in held]
        columns = [MOUTH.index(part) for part in AXES[name]]
        self._values = np.array([shape.values for shape in chosen]).reshape(-1, len(MOUTH))[:, columns]
        rounded = np.array([name == "corners" and shape.rounded for shape in chosen], dtype=bool)
        self._dominance = np.where(rounded, ROUNDING, 1.0)
        self._off = np.array([shape.off for shape in chosen])
        self._on = np.array([shape.on for shape in chosen])
        if name == "corners":
            self._set_off(rounded)

    def _set_off(self, rounded: NDArray[np.bool_]) -> None:
        """The corners come early to what is rounded, and set off late for what is far."""
        before = np.concatenate([[-np.inf], self._off[:-1]])
        early = np.maximum(self._on - AHEAD * rounded, np.minimum(before + GAP, self._on))
        self._on = early
        after = np.concatenate([self._on[1:], [np.inf]])
        self._off = np.maximum(self._off, after - LONGEST)
        self._off[-1:] = self._on[-1:]

    def sample(self, times: Floats) -> Floats:
        """At `times` (seconds, any order): array[n, part] in the order of `shape.AXES`."""
        first, second, share = self._weights(times)
        part = share[:, np.newaxis]
        values: Floats = (1 - part) * self._values[first] + part * self._values[second]
        return values

    def weights(self, times: Floats) -> tuple[Numbers, Numbers, Floats]:
        """The two shapes (numbers of the track's) that weigh at each time, and the second one's weight; the first
        one's is the rest."""
        first, second, share = self._weights(times)
        return self._place[first], self._place[second], share

    def _weights(self, times: Floats) -> tuple[Numbers, Numbers, Floats]:
        last = len(self._on) - 1
        first = np.clip(np.searchsorted(self._on, times, side="right") - 1, 0, last)
        second = np.minimum(first + 1, last)
        way = np.maximum(self._on[second] - self._off[first], 1e-9)
        risen = _smooth((times - self._off[first]) / way) * (second > first)
        coming, going = self._dominance[second] * risen, self._dominance[first] * (1.0 - risen)
        return first, second, coming / (coming + going)


class MouthTrack:
    """The mouth of one face over the whole film, a pure function of time: each of its axes by itself."""

    def __init__(self, lines: Sequence[TimedLine], table: Table = PLAIN) -> None:
        self.shapes = _with_rests(lines, table)
        self._axes = {name: Axis(name, self.shapes) for name in AXES}
        self._active = np.array(_active(self.shapes)).reshape(-1, 2)

    def sample(self, times: Floats) -> tuple[Floats, Floats]:
        """At `times` (seconds, any order): array[n, 8] in the order and units of `channels.MOUTH`, and array[n], 0..1,
        how far speech owns the mouth."""
        values = np.zeros((len(times), len(MOUTH)))
        if not self.shapes:
            return values, np.zeros(len(times))
        for name, axis in self._axes.items():
            values[:, [MOUTH.index(part) for part in AXES[name]]] = axis.sample(times)
        return values, self._activity(times)

    def weights(self, times: Floats, part: str = "open") -> tuple[Numbers, Numbers, Floats]:
        """The two shapes (numbers of `self.shapes`) that weigh at each time on a part of the mouth, and the second
        one's weight; the first one's is the rest."""
        if not self.shapes:
            none = np.zeros(len(times), dtype=np.intp)
            return none, none, np.zeros(len(times))
        name = next(axis for axis, parts in AXES.items() if part in parts)
        return self._axes[name].weights(times)

    def _activity(self, times: Floats) -> Floats:
        starts, ends = self._active[:, 0], self._active[:, 1]
        near = np.clip(np.searchsorted(starts, times, side="right") - 1, 0, len(starts) - 1)
        return _smooth((times - starts[near]) / RISE) * (1 - _smooth((times - ends[near]) / FALL))


def _smooth(share: Floats) -> Floats:
    """0 to 1 without a corner at either end."""
    kept = np.clip(share, 0, 1)
    return kept * kept * (3 - 2 * kept)


def _with_rests(lines: Sequence[TimedLine], table: Table) -> tuple[MouthShape, ...]:
    """The shapes of all lines in the film's time, the mouth at rest before, between and after them."""
    found: list[MouthShape] = []
    rested = 0.0
    normal = normal_level([line.spoken for line in lines])
    for line in sorted(lines, key=lambda line: line.start):
        shapes = _in_film(line, normal, table)
        if not shapes:
            continue
        sounding = [phone for phone in line.spoken.phones if phone.symbol]
        begins = min(line.start + sounding[0].start - lead(sounding[0], table), shapes[0].on - 2 * GAP)
        rest = _rest(found, rested, begins, shapes[0].on)
        parted = breath(begins, shapes[0].on, sounding[0], table) if rest else []
        found += [*rest, *parted, *shapes]
        rested = max(min(line.start + sounding[-1].end, line.end), shapes[-1].off) + DECAY
    return arranged([*found, MouthShape("rest", rested, rested)] if found else [])


def _rest(before: Sequence[MouthShape], rested: float, begins: float, on: float) -> list[MouthShape]:
    """The rest between the shapes `before`, after which the mouth could be still from `rested` on, and the next shape
    at `on`, for which it begins to move at `begins`."""
    if not before:
        return [MouthShape("rest", begins, begins)]
    if rested <= begins:
        return [MouthShape("rest", rested, begins)]
    middle = (before[-1].off + on) / 2
    return [MouthShape("rest", middle, middle)] if on - before[-1].off >= PAUSE else []


def _in_film(line: TimedLine, normal: float, table: Table) -> list[MouthShape]:
    """A line's shapes at their times, from its first sound on; none begins after a cut."""
    limit, shapes = line.end, _shapes(line, normal, table)
    kept = [shape.later(line.start, limit) for shape in shapes if shape.on + line.start < limit]
    moving = [index for index, shape in enumerate(kept) if shape.name != "rest"]
    return kept[moving[0] : moving[-1] + 1] if moving else []


_Manner = tuple[float, float, Table]
_SHAPES: WeakKeyDictionary[Spoken, tuple[_Manner, tuple[MouthShape, ...]]] = WeakKeyDictionary()


def _shapes(line: TimedLine, normal: float, table: Table) -> tuple[MouthShape, ...]:
    """A line's shapes from its start on, kept as long as the line itself is: an edited script speaks most lines as it
    did before."""
    manner = normal, line.volume, table
    found = _SHAPES.get(line.spoken)
    if found is None or found[0] != manner:
        shapes = mouth_shapes(line.spoken.phones, Effort(line.spoken, normal, line.volume), table)
        found = _SHAPES[line.spoken] = manner, shapes
    return found[1]


def _active(shapes: Sequence[MouthShape]) -> list[tuple[float, float]]:
    """For each stretch of speech between long rests: when activity begins to rise, and when it begins to fall."""
    rests = [s for s in shapes if s.name == "rest" and (s in (shapes[0], shapes[-1]) or s.off - s.on >= LET_GO)]
    return [(before.off - RISE, after.on) for before, after in pairwise(rests)]
