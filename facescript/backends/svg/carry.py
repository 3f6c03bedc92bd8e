"""Head movement to transforms of groups: what is carried along need not be written again in every outline."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.backends.svg.ease import Keys
from facescript.backends.svg.limit import Apart
from facescript.performance.channels import INDEX
from facescript.performance.performance import REST, FaceCurves, Frames, Performance
from facescript.rig.picture import Shape, unturned
from facescript.stage.stage import Stage

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

HEAD = [INDEX[f"head.{name}"] for name in ("yaw", "pitch", "roll", "x", "y", "scale")]

EVERY = 3
"""Of the moments looked at, how many apart those are that decide the carrying: it need not be exact, only near."""

PLACE = 0.2
"""Quanta: the step of translations."""

ANGLE = 0.01
"""Degrees: the step of rotations and skews."""

SIZE = 0.0002
"""The step of scales."""

OFF = 1.5
"""Steps a transform may be off; outlines must make good what it is, so it is little."""

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
class Carrier:
    """One transform over time: translation in PLACEs, (rotation, skew) in ANGLEs, (width, height) in SIZEs.

    As SMIL has it: translate, then rotate, then skewX, then scale.
    """

    places: Keys = field(default_factory=Keys)
    angles: Keys = field(default_factory=Keys)
    sizes: Keys = field(default_factory=Keys)

    def follow(self, times: Floats, places: Floats, matrices: Floats) -> None:
        """Go on through more moments: places array[moment, 2] in quanta, matrices array[moment, 2, 2]."""
        (a, c), (b, d) = matrices.transpose(1, 2, 0)
        width = np.hypot(a, b)
        height = (a * d - b * c) / width
        skew = (a * c + b * d) / width / height
        angles = np.degrees(np.stack([np.unwrap(np.arctan2(b, a)), np.arctan(skew)], axis=1))
        _follow(self.places, times, places / PLACE)
        _follow(self.angles, times, angles / ANGLE)
        _follow(self.sizes, times, np.stack([width, height], axis=1) / SIZE)

    def undo(self, times: Floats, points: Floats) -> Floats:
        """Points in quanta, array[moment, point, xy], as they stand inside the group."""
        turn, skew = np.radians(self.angles.at(times) * ANGLE).T
        width, height = (self.sizes.at(times) * SIZE).T
        cos, sin = np.cos(turn)[:, None], np.sin(turn)[:, None]
        x, y = (points - self.places.at(times)[:, None] * PLACE).transpose(2, 0, 1)
        x, y = x * cos + y * sin, y * cos - x * sin
        x = x - y * np.tan(skew)[:, None]
        return np.stack([x / width[:, None], y / height[:, None]], axis=2)

    def inside(self, times: Floats, points: Floats, quantum: float) -> Floats:
        """The same in pixels."""
        within: Floats = self.undo(times, points / quantum) * quantum
        return within

    def largest(self) -> float:
        """By how much at most it makes what is off larger."""
        scales = [float(values.max()) * SIZE for values in self.sizes.values]
        skews = [abs(float(values[1])) * ANGLE for values in self.angles.values]
        return max(1.0, max(scales)) * (1 + float(np.tan(np.radians(max(skews)))))


def _follow(keys: Keys, times: Floats, rows: Floats) -> None:
    keys.follow(times, rows, Apart(rows, OFF))


def carriers(
    job: Job, shapes: Sequence[Shape], columns: Sequence[Ints], moments: Floats, quantum: float
) -> tuple[tuple[int, ...], tuple[Carrier, ...]]:
    """Which carrier is whose shape's, and the carriers: how the head alone would move their points, as one affine.

    Shapes of a group, and those that clip each other, share a carrier. Inside it they stand upright however the film
    begins: a gradient, which fills an upright box there, is rolled with the head.
    """
    of = shared(shapes, job.stage.owners)
    parts = [_telling(shapes, columns, [place for place, own in enumerate(of) if own == number]) for number in set(of)]
    heads = Performance({name: HeadOnly(curves) for name, curves in job.performance.faces.items()}, job.end)
    stage = Stage(job.score, heads, job.pictures)
    found = tuple(Carrier() for _ in parts)
    some = _some(moments)
    start = stage.frames(some[:1])
    rolled = [float(start.turns[0, np.equal(of, number)].mean()) for number in range(len(parts))]
    rests = [unturned(start.points[0, part] / quantum, turn) for part, turn in zip(parts, rolled, strict=True)]
    for begin in range(0, len(some), CHUNK):
        chunk = some[begin : begin + CHUNK]
        points = stage.frames(chunk).points / quantum
        for part, rest, carrier in zip(parts, rests, found, strict=True):
            carrier.follow(chunk, *_affine(rest, points[:, part]))
    return of, found


def _telling(shapes: Sequence[Shape], columns: Sequence[Ints], places: Sequence[int]) -> Ints:
    """The points of some shapes by which they are carried: not those of what is hidden for the most part by a clip,
    where there are others."""
    free = [place for place in places if not shapes[place].clip]
    return np.concatenate([columns[place] for place in free or places])


def _affine(rest: Floats, points: Floats) -> tuple[Floats, Floats]:
    """The middle of points array[moment, point, xy], and the matrices that best make them of the rest's."""
    middle = points.mean(axis=1)
    before = rest - rest.mean(axis=0)
    spread = before.T @ before + np.eye(2) * 1e-6
    return np.asarray(middle), (points - middle[:, None]).transpose(0, 2, 1) @ before @ np.linalg.inv(spread)


def _some(moments: Floats) -> Floats:
    """Every EVERYth moment, the last, and both sides of every jump."""
    chosen = np.arange(len(moments)) % EVERY == 0
    near = np.diff(moments, append=moments[-1] + 1) < 1e-4
    chosen |= near | np.roll(near, 1)
    chosen[[0, -1]] = True
    return np.asarray(moments[chosen])


def shared(shapes: Sequence[Shape], owners: Sequence[str]) -> tuple[int, ...]:
    """The number of each shape's carrier."""
    group = {shape.id: (owner, shape.group) for shape, owner in zip(shapes, owners, strict=True)}
    leader = {name: name for name in group.values()}
    for shape in shapes:
        for clip in shape.clip:
            one, other = leader[group[shape.id]], leader[group[clip]]
            leader = {name: one if led == other else led for name, led in leader.items()}
    numbers = {led: number for number, led in enumerate(dict.fromkeys(leader.values()))}
    return tuple(numbers[leader[group[shape.id]]] for shape in shapes)
