"""A stage over time to key frames of outlines and opacities, each within half a pixel of the performance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.backends.svg.carry import Carrier, carriers
from facescript.backends.svg.course import Course
from facescript.backends.svg.curves import Curves, curves
from facescript.backends.svg.ground import SHADE, Behind
from facescript.backends.svg.keys import Swing
from facescript.backends.svg.moments import moments_of
from facescript.backends.svg.seen import Sight
from facescript.backends.svg.slide import Slide
from facescript.backends.svg.spread import spread
from facescript.backends.svg.track import Carried, Track
from facescript.backends.svg.written import carrier_tracks, outline_track, shade_track, slide_track
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

CHUNK = 2048
"""Moments drawn at once."""


@dataclass(frozen=True, slots=True)
class Animation:
    """Outline and opacity of every shape over time, the transforms that carry it, and what lies behind all.

    Outlines and translations are in `quantum` pixels; a shape that `slides` is moved as a whole besides. `curved` are
    the outlines' curves, `cut` is what a clip ever cuts, and `carried` says which of the carriers is whose.
    """

    quantum: float
    curved: tuple[Curves, ...]

    outlines: tuple[Track, ...]
    slides: tuple[Track | None, ...]
    opacities: tuple[Track, ...]
    cut: tuple[bool, ...]
    carried: tuple[int, ...]
    carriers: tuple[tuple[Carried, ...], ...]
    behind: Behind


def animation(job: Job, curved: Sequence[Curves] = ()) -> Animation:
    """The key frames of a job's stretch, with the curves of another stretch where they are given. Memory holds a chunk
    of frames and the keys found."""
    shapes = job.stage.shapes
    columns = [_columns(shape) for shape in shapes]
    moments = moments_of(job)
    unit = UNIT if job.at is None else UNIT_STILL
    carried, carrying = carriers(job, shapes, columns, moments, unit / 2)
    courses = _courses(job, _Carried(moments, columns, carried, carrying), curved)
    shades = Swing(np.arange(len(shapes)), len(shapes), 1.0)
    behind = Behind()
    cut: set[int] = set()
    for first in range(0, len(moments), CHUNK):
        chunk = moments[first : first + CHUNK]
        drawn = job.stage.frames(chunk)
        sight = Sight(shapes, columns, drawn.points, drawn.opacity)
        shown = sight.shown(chunk)
        cut |= {place for place, shape in enumerate(shapes) if shape.clip and place not in cut and sight.cut(place)}
        courses = spread(courses, partial(_followed, chunk, sight, shown), job.hands())
        for time, opacity, ground in zip(chunk.tolist(), shown, drawn.grounds, strict=True):
            (shades.push if shades.begun else shades.begin)(time, opacity / SHADE)
            behind.take(time - moments[0], ground)
        job.progress(first + len(chunk), len(moments))
    shades.finish()
    start = float(moments[0])
    return Animation(
        unit / 2,
        tuple(course.curves for course in courses),
        tuple(outline_track(course.keys, course.curves, start) for course in courses),
        tuple(slide_track(course.slide, start) if course.slide else None for course in courses),
        tuple(shade_track(keys, start) for keys in shades.keys),
        tuple(place in cut for place in range(len(shapes))),
        carried,
        tuple(carrier_tracks(carrier, start) for carrier in carrying),
        behind,
    )


class _Carried(NamedTuple):
    """The moments, the points of each shape, and which carrier is whose."""

    moments: Floats
    columns: Sequence[Ints]
    carried: Sequence[int]
    carrying: Sequence[Carrier]


def _courses(job: Job, on: _Carried, curved: Sequence[Curves]) -> list[Course]:
    """What every shape's outline is followed by, before any of it is."""
    unit, fit = (UNIT, FIT) if job.at is None else (UNIT_STILL, FIT_STILL)
    some = _telling(job, on.moments)
    seen = job.stage.frames(some).points
    shapes = job.stage.shapes
    bounds = {name for shape in shapes for name in shape.clip}
    given: Sequence[Curves | None] = curved or [None] * len(shapes)

    def begun(place: int) -> Course:
        shape, column = shapes[place], on.columns[place]
        carrier = on.carrying[on.carried[place]]
        inside = carrier.inside(some, seen[:, column], unit / 2)
        fitted = given[place] or curves(inside, [contour.count for contour in shape.contours], fit)
        off = OFF / carrier.largest()
        return Course(place, column, carrier, off, unit, fitted, Slide.of(inside), shape.id in bounds)

    return spread(range(len(shapes)), begun, job.hands())


def _followed(chunk: Floats, sight: Sight, shown: Floats, course: Course) -> Course:
    course.follow(chunk, sight, shown[:, course.place])
    return course


def _telling(job: Job, moments: Floats) -> Floats:
    """Moments by which outlines are fitted: some evenly, and those where a channel is at its highest or lowest."""
    some = moments[np.unique(np.linspace(0, len(moments) - 1, 1000).astype(np.intp))]
    values = job.performance.sample(some)
    evenly = np.linspace(0, len(some) - 1, 40).astype(np.intp)
    chosen: Floats = some[np.unique(np.concatenate([evenly, values.argmax(axis=0), values.argmin(axis=0)]))]
    return chosen


def _columns(shape: Shape) -> Ints:
    """The rows of the point array that a shape's contours use, in turn."""
    return np.concatenate([np.arange(contour.first, contour.first + contour.count) for contour in shape.contours])
