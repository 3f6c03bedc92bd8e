"""One moment of a stage to an SVG picture, with the outlines as they are drawn: quickly made, and not small."""

from __future__ import annotations

import numpy as np
from lxml import etree
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.backends.svg.animation import Animation
from facescript.backends.svg.ground import Behind
from facescript.backends.svg.layers import picture_groups, showings
from facescript.backends.svg.path import decimal
from facescript.backends.svg.track import Clock, Track, svg
from facescript.rig.picture import Contour, Shape

Floats = NDArray[np.float64]


def still(job: Job, time: float) -> str:
    """The picture at a time, as wide and high as what holds it lets it be."""
    stage = job.stage
    drawn = stage.frames(np.array([time]))
    behind = Behind()
    behind.take(0.0, drawn.grounds[0])
    count = len(stage.shapes)
    moment = Animation(
        1.0,
        (),
        tuple(_once(_outline(shape, drawn.points[0])) for shape in stage.shapes),
        (None,) * count,
        tuple(_once(decimal(opacity)) for opacity in drawn.opacity[0].tolist()),
        tuple(bool(shape.clip) for shape in stage.shapes),
        (0,) * count,
        ((),),
        behind,
    )
    whole = svg("svg", viewBox=f"0 0 {stage.width} {stage.height}")
    whole.extend(picture_groups(stage, showings(moment, None), Clock.around(0.0), []))
    return str(etree.tostring(whole, encoding="unicode"))


def _once(text: str) -> Track:
    return Track((0.0,), (text,))


def _outline(shape: Shape, points: Floats) -> str:
    return "".join(_contour(each, points) for each in shape.contours)


def _contour(contour: Contour, points: Floats) -> str:
    first, *rest = points[contour.first : contour.first + contour.count].round(1).tolist()
    return f"M{first[0]:g} {first[1]:g}C{' '.join(f'{x:g} {y:g}' for x, y in rest)}z"
