"""Curves to what a picture can show of them: the least and the greatest value in each column of pixels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import INDEX
from facescript.performance.performance import FaceCurves, Frames
from facescript.plot.axis import Scale

Floats = NDArray[np.float64]

RATE = 1000.0
"""Samples a second: a saccade of 20 ms has twenty."""

MOST = 2_000_000
"""Samples of a face in all: from 33 minutes on they stand wider apart, in a film of four hours by 7 ms."""

CHUNK = 8192
"""Samples taken at once, about."""

STRAIGHT = 0.05
"""A point nearer than this to the way between its neighbours is left out, px."""


@dataclass(frozen=True, slots=True)
class Envelope:
    """One curve: `times` (s) and `values`, array[column, 2], the extremes of each column as they come in time."""

    times: Floats
    values: Floats

    @property
    def low(self) -> float:
        return float(self.values.min())

    @property
    def high(self) -> float:
        return float(self.values.max())


def envelopes(face: FaceCurves, curves: Sequence[tuple[str, ...]], scale: Scale) -> list[Envelope]:
    """An envelope a curve, each the mean of some channels, sampled at `RATE` or finer, a chunk at a time."""
    columns, length = scale.columns, scale.end - scale.start
    each = max(2, ceil(min(length * RATE, MOST) / columns))
    rows = [np.array([INDEX[name] for name in names], dtype=np.intp) for names in curves]
    times = np.empty((len(curves), columns, 2))
    values = np.empty_like(times)
    stride = max(1, CHUNK // each)
    for first in range(0, columns, stride):
        count = min(stride, columns - first)
        moments = scale.start + length * (first + (np.arange(count * each) + 0.5) / each) / columns
        frames = face.sample(moments)
        for number, row in enumerate(rows):
            window = slice(first, first + count)
            times[number, window], values[number, window] = _extremes(moments, frames, row, each)
    return [Envelope(*pair) for pair in zip(times, values, strict=True)]


def _extremes(moments: Floats, frames: Frames, row: NDArray[np.intp], each: int) -> tuple[Floats, Floats]:
    """The least and the greatest of every `each` samples with their times, in the order of these."""
    samples = frames[:, row].mean(axis=1).reshape(-1, each)
    places = np.sort(np.stack([samples.argmin(axis=1), samples.argmax(axis=1)], axis=1), axis=1)
    rows = np.arange(len(samples))[:, None]
    return moments.reshape(-1, each)[rows, places], samples[rows, places]


def straightened(x: Floats, y: Floats) -> tuple[tuple[float, float], ...]:
    """The points (px) of a line without those that change nothing that can be seen; x never falls."""
    points = list(zip(x.tolist(), y.tolist(), strict=True))
    kept = [points[0]]
    low, high = -np.inf, np.inf
    for last, point in pairwise(points):
        slope = _slope(kept[-1], point)
        if not low <= slope <= high and last != kept[-1]:
            kept.append(last)
            low, high = -np.inf, np.inf
        start = kept[-1]
        low = max(low, _slope(start, (point[0], point[1] - STRAIGHT)))
        high = min(high, _slope(start, (point[0], point[1] + STRAIGHT)))
    return tuple(kept if kept[-1] == points[-1] else [*kept, points[-1]])


def _slope(start: tuple[float, float], point: tuple[float, float]) -> float:
    run = point[0] - start[0]
    return (point[1] - start[1]) / run if run > 0 else float(np.copysign(np.inf, point[1] - start[1]))
