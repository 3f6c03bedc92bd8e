"""Head movement to translations of groups: what is carried along need not be written again in every outline."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.backends.svg_ease import Keys
from facescript.performance.channels import INDEX
from facescript.performance.performance import REST, FaceCurves, Frames, Performance
from facescript.rig.picture import Shape
from facescript.stage.stage import Stage

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

HEAD = [INDEX[f"head.{name}"] for name in ("yaw", "pitch", "roll", "x", "y", "scale")]

EVERY = 3
"""Of the moments looked at, how many apart those are that decide the carrying: it need not be exact, only near."""

OFF = 1.0
"""Quanta a translation may be off; outlines make good what it is."""

CHUNK = 256


@dataclass(frozen=True, slots=True)
class HeadOnly:
    """A face's curves with everything at rest but the head."""

    curves: FaceCurves

    def sample(self, times: Floats) -> Frames:
        poses = np.tile(REST, (len(times), 1))
        poses[:, HEAD] = self.curves.sample(times)[:, HEAD]
        return poses


@dataclass(frozen=True, slots=True)
class Carriers:
    """The translations: `of` says which one carries a shape; shapes of a group, and those that clip each other, share
    one."""

    of: tuple[int, ...]
    keys: tuple[Keys, ...]

    def at(self, times: Floats) -> Floats:
        """All translations in quanta, array[moment, carrier, xy]."""
        return np.stack([keys.at(times) for keys in self.keys], axis=1)


def carriers(job: Job, shapes: Sequence[Shape], columns: Sequence[Ints], moments: Floats, quantum: float) -> Carriers:
    """How the head alone would move each carrier's points, on average, from where they are at the first moment."""
    of = _shared(shapes, job.stage.owners)
    parts = [np.concatenate([columns[place] for place, own in enumerate(of) if own == carrier]) for carrier in set(of)]
    heads = Performance({name: HeadOnly(curves) for name, curves in job.performance.faces.items()}, job.end)
    stage = Stage(job.score, heads, job.pictures)
    keys = tuple(Keys() for _ in parts)
    some = _some(moments)
    first: Floats | None = None
    for begin in range(0, len(some), CHUNK):
        chunk = some[begin : begin + CHUNK]
        points = stage.frames(chunk).points
        means = np.stack([points[:, part].mean(axis=1) for part in parts], axis=1) / quantum
        first = means[0] if first is None else first
        for carrier, track in enumerate(keys):
            track.follow(chunk, means[:, carrier] - first[carrier], OFF)
    return Carriers(of, keys)


def _some(moments: Floats) -> Floats:
    """Every EVERYth moment, the last, and both sides of every jump."""
    chosen = np.arange(len(moments)) % EVERY == 0
    near = np.diff(moments, append=moments[-1] + 1) < 1e-4
    chosen |= near | np.roll(near, 1)
    chosen[[0, -1]] = True
    return moments[chosen]


def _shared(shapes: Sequence[Shape], owners: Sequence[str]) -> tuple[int, ...]:
    """The number of each shape's carrier."""
    group = {shape.id: (owner, shape.group) for shape, owner in zip(shapes, owners, strict=True)}
    leader = {name: name for name in group.values()}
    for shape in shapes:
        for clip in shape.clip:
            one, other = leader[group[shape.id]], leader[group[clip]]
            leader = {name: one if led == other else led for name, led in leader.items()}
    numbers = {led: number for number, led in enumerate(dict.fromkeys(leader.values()))}
    return tuple(numbers[leader[group[shape.id]]] for shape in shapes)
