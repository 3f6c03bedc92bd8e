"""A stage over time to key frames of outlines and opacities, each within half a pixel of the performance."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.backends.svg.carry import ANGLE, PLACE, SIZE, Carrier, carriers
from facescript.backends.svg.curves import Curves, curves
from facescript.backends.svg.ease import Keys
from facescript.backends.svg.ground import SHADE, Behind
from facescript.backends.svg.keys import Swing
from facescript.backends.svg.limit import Edge
from facescript.backends.svg.path import path_text
from facescript.backends.svg.seen import Sight, around
from facescript.backends.svg.track import Carried, Track
from facescript.performance.channels import Channel
from facescript.rig.picture import Shape

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

UNIT = 0.5
"""Pixels: controls are whole multiples of it, joints of half of it. Measured: the smallest files at the same half
pixel."""

UNIT_STILL = 0.1
"""The same of a picture that stands."""

FIT = 0.25
"""Pixels that the outline in fewer numbers may take of what a point may be off."""

FIT_STILL = 0.15
"""The same of a picture that stands."""

OFF = 0.5
"""Pixels a point may be off."""

TICK = 0.008
"""Seconds: all key times are whole multiples of it."""

STEP = 2
"""Ticks between two moments looked at where nothing is quick."""

BEFORE = 1e-6
"""Seconds: how shortly before a jump the picture is looked at."""

CHUNK = 2048
"""Moments drawn at once."""

BEND = {"deg": 0.25, "cm": 0.02, "1": 0.006}
"""How far a channel may bend away from a straight line within STEP ticks before the moments between are looked at."""

HEAD_BEND = 0.04
"""The same for head angles, deg: the whole face hangs on them."""


@dataclass(frozen=True, slots=True)
class Animation:
    """Outline and opacity of every shape over time, the transforms that carry it, and what lies behind all.

    Outlines and translations are in `quantum` pixels; `curved` are the outlines' curves, and `carried` says which of
    the carriers is whose.
    """

    quantum: float
    curved: tuple[Curves, ...]

    outlines: tuple[Track, ...]
    opacities: tuple[Track, ...]
    carried: tuple[int, ...]
    carriers: tuple[tuple[Carried, ...], ...]
    behind: Behind


def animation(job: Job, curved: Sequence[Curves] = ()) -> Animation:
    """The key frames of a job's stretch, with the curves of another stretch where they are given. Memory holds a chunk
    of frames and the keys found."""
    shapes = job.stage.shapes
    unit, fit = (UNIT, FIT) if job.at is None else (UNIT_STILL, FIT_STILL)
    columns = [_columns(shape) for shape in shapes]
    outlines = [Keys() for _ in shapes]
    shades = Swing(np.arange(len(shapes)), len(shapes), 1.0)
    behind = Behind()
    bounds = {name for shape in shapes for name in shape.clip}
    moments = _moments(job)
    carried, carrying = carriers(job, shapes, columns, moments, unit / 2)
    off = [OFF / carrier.largest() for carrier in carrying]
    some = _telling(job, moments)
    seen = job.stage.frames(some).points
    curved = curved or [
        curves(_inside(carrying[number], some, seen[:, column], unit), _lengths(shape), fit)
        for shape, column, number in zip(shapes, columns, carried, strict=True)
    ]
    for first in range(0, len(moments), CHUNK):
        chunk = moments[first : first + CHUNK]
        drawn = job.stage.frames(chunk)
        sight = Sight(shapes, columns, drawn.points, drawn.opacity)
        shown = sight.shown()
        for place, (keys, column, number) in enumerate(zip(outlines, columns, carried, strict=True)):
            kept = around((shown[:, place] >= SHADE / 2) | (shapes[place].id in bounds))
            points = drawn.points[kept][:, column]
            mine = _inside(carrying[number], chunk[kept], points, unit)
            rows = (curved[place].map @ mine / unit).reshape(len(mine), -1)
            allowed = sight.tolerances(place, curved[place].spots, off[number])[kept]
            keys.follow(chunk[kept], rows, Edge.of(curved[place], mine, allowed, unit))
        for time, opacity, ground in zip(chunk.tolist(), shown, drawn.grounds, strict=True):
            (shades.push if shades.begun else shades.begin)(time, opacity / SHADE)
            behind.take(time - moments[0], ground)
        job.progress(first + len(chunk), len(moments))
    shades.finish()
    return Animation(
        unit / 2,
        tuple(curved),
        tuple(_outline(keys, curve, moments[0]) for keys, curve in zip(outlines, curved, strict=True)),
        tuple(_shade(keys, moments[0]) for keys in shades.keys),
        carried,
        tuple(_carried(carrier, moments[0]) for carrier in carrying),
        behind,
    )


def _inside(carrier: Carrier, times: Floats, points: Floats, unit: float) -> Floats:
    """Points array[moment, point, 2] as they stand inside their carrier's group, in pixels there."""
    inside: Floats = carrier.undo(times, points / (unit / 2)) * (unit / 2)
    return inside


def _telling(job: Job, moments: Floats) -> Floats:
    """Moments by which outlines are fitted: some evenly, and those where a channel is at its highest or lowest."""
    some = moments[np.unique(np.linspace(0, len(moments) - 1, 1000).astype(np.intp))]
    values = job.performance.sample(some)
    evenly = np.linspace(0, len(some) - 1, 40).astype(np.intp)
    chosen: Floats = some[np.unique(np.concatenate([evenly, values.argmax(axis=0), values.argmin(axis=0)]))]
    return chosen


def _lengths(shape: Shape) -> list[int]:
    return [contour.count for contour in shape.contours]


def _columns(shape: Shape) -> Ints:
    """The rows of the point array that a shape's contours use, in turn."""
    return np.concatenate([np.arange(contour.first, contour.first + contour.count) for contour in shape.contours])


def _outline(keys: Keys, curved: Curves, start: float) -> Track:
    """An outline in the middle of all, and what is added to it: differences are short."""
    values = [row.reshape(-1, 2) for row in keys.values]
    base = values[0] if len(values) < 3 else np.rint(np.median(values, axis=0)).astype(np.int64)
    added = tuple(path_text(value - base, curved.chains) for value in values)
    times = tuple(time - start for time in keys.times)
    return Track(times, added, keys.eases, base=path_text(base, curved.chains))


def _carried(carrier: Carrier, start: float) -> tuple[Carried, ...]:
    """A carrier as SMIL's transforms, outermost first."""
    places = [f"{x * PLACE:.1f} {y * PLACE:.1f}" for x, y in carrier.places.values]
    turns, skews = ([f"{values[at] * ANGLE:.3f}" for values in carrier.angles.values] for at in (0, 1))
    sizes = [f"{x * SIZE:.4f} {y * SIZE:.4f}" for x, y in carrier.sizes.values]
    kinds = (
        ("translate", places, carrier.places),
        ("rotate", turns, carrier.angles),
        ("skewX", skews, carrier.angles),
        ("scale", sizes, carrier.sizes),
    )
    return tuple(
        Carried(kind, Track([time - start for time in keys.times], texts, keys.eases)) for kind, texts, keys in kinds
    )


def _shade(keys: list[tuple[float, Ints]], start: float) -> Track:
    texts = tuple(f"{min(max(values[0] * SHADE, 0.0), 1.0):.2f}".rstrip("0").rstrip(".") for _, values in keys)
    return Track(tuple(time - start for time, _ in keys), texts)


def _moments(job: Job) -> Floats:
    """The moments to look at: every STEP ticks, every tick where a channel bends, both sides of every jump."""
    if job.at is not None:
        return np.array([job.at])
    last = max(1, round((job.end - job.start) / TICK))
    ticks = np.arange(0, -(-last // STEP) * STEP + 1)
    bent = np.repeat(_bent(job, ticks), STEP)
    chosen = (ticks % STEP == 0) | np.append(bent, False)
    times = job.start + ticks[chosen & (ticks <= last)] * TICK
    jumps = _jumps(job)
    return np.unique(np.concatenate([times, jumps, jumps - BEFORE]))


def _bent(job: Job, ticks: Ints) -> NDArray[np.bool_]:
    """For each stretch of STEP ticks, whether any channel leaves the straight line across it by its BEND."""
    found = np.zeros(len(ticks) // STEP, dtype=bool)
    limit = _limits(job.performance.channels)
    for first in range(0, len(found), 500):
        rows = ticks[first * STEP : (first + 500) * STEP + 1]
        values = job.performance.sample(np.asarray(job.start + rows * TICK, dtype=np.float64))
        count = (len(rows) - 1) // STEP
        ends = values[::STEP][: count + 1]
        for part in range(1, STEP):
            inner = values[part::STEP][:count]
            line = ends[:-1] + (ends[1:] - ends[:-1]) * (part / STEP)
            found[first : first + count] |= (np.abs(inner - line) > limit).any(axis=1)
    return found


def _limits(channels: Sequence[Channel]) -> Floats:
    """The BEND of every column of a sample."""
    heads = [one.name.startswith("head") and one.unit == "deg" for one in channels]
    return np.array([HEAD_BEND if head else BEND[one.unit] for head, one in zip(heads, channels, strict=True)])


def _jumps(job: Job) -> Floats:
    """Moments at which the picture may jump: scenes, and acts that take no time."""
    scenes = [scene.start for scene in job.score.scenes]
    sudden = [act.start for act in job.score.acts if act.settled == act.start]
    ends = [act.released for act in job.score.acts if act.end == act.released < math.inf]
    inside = {time for time in scenes + sudden + ends if job.start < time < job.end}
    return np.array(sorted(inside))
