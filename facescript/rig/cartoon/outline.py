"""Points and widths as an artist notes them -> closed outlines of anchors, and the parts that a face is drawn from."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from facescript.rig.cartoon.spline import Anchor
from facescript.rig.picture import Paint

Point = Sequence[float]
"""x, y in px from the eyes' middle, y down; a third number that is not 0 marks a corner."""

Loop = tuple[Anchor, ...]

Depths = tuple[float | None, ...]
"""The depth of each anchor of an outline, in d; None where the part's law says."""

Spine = tuple[tuple[float, float], ...]


class Ribbon(tuple[Anchor, ...]):
    """A stroke's or a spot's outline that knows its middle at each anchor: what is thin lies at one depth across."""

    spine: Spine

    @classmethod
    def along(cls, outline: Loop, spine: Spine) -> Ribbon:
        ribbon = cls(outline)
        ribbon.spine = spine
        return ribbon


def spine(outline: Loop) -> Spine:
    """Where the depth of each anchor is taken: the stroke's middle, or the anchor itself."""
    return outline.spine if isinstance(outline, Ribbon) else tuple((x, y) for x, y, _ in outline)


POINTED = 0.02
"""A ribbon's end narrower than this is a point."""


@dataclass(frozen=True, slots=True)
class Part:
    """One shape of a face at rest: what it is filled with, how deep it lies (`depth`), what bounds it.

    `opacity` is that at rest; muscles may change it (`tone.py`). A part without `loops` has them from the eye or the
    mouth, which draw their own outlines. `z` is its depth in d where the law leaves it open, `depths` that of anchors
    that have one of their own.
    """

    id: str
    group: str
    depth: str
    fill: Paint
    loops: tuple[Loop, ...] = ()
    opacity: float = 1.0
    clip: tuple[str, ...] = ()
    z: float | None = None
    depths: tuple[Depths, ...] = ()


def loop(*points: Point) -> Loop:
    """A closed outline through `points`."""
    return tuple((float(p[0]), float(p[1]), len(p) > 2 and bool(p[2])) for p in points)


def disc(x: float, y: float, rx: float, ry: float) -> Loop:
    """An ellipse: four smooth anchors, from the right, clockwise as seen."""
    return loop((x + rx, y), (x, y + ry), (x - rx, y), (x, y - ry))


def spot(x: float, y: float, rx: float, ry: float) -> Ribbon:
    """A small ellipse that lies at one depth: a light, a blush, a jewel."""
    return Ribbon.along(disc(x, y, rx, ry), ((x, y),) * 4)


def ribbon(*points: Point) -> Ribbon:
    """A stroke as an outline; points are x, y, width and, where it bends sharply, a fourth number."""
    left: list[Anchor] = []
    right: list[Anchor] = []
    last = len(points) - 1
    for i, (x, y, width, *corner) in enumerate(points):
        before, after = points[max(i - 1, 0)], points[min(i + 1, last)]
        dx, dy = after[0] - before[0], after[1] - before[1]
        length = math.hypot(dx, dy) or 1.0
        nx, ny = -dy / length * width / 2, dx / length * width / 2
        sharp = i in (0, last) or bool(corner)
        left.append((x + nx, y + ny, sharp))
        right.append((x - nx, y - ny, sharp))
    there = [(float(p[0]), float(p[1])) for p in points]
    back = there[:]
    if points[last][2] < POINTED:
        right.pop()
        back.pop()
    if points[0][2] < POINTED:
        right.pop(0)
        back.pop(0)
    return Ribbon.along(tuple(left + right[::-1]), tuple(there + back[::-1]))


def mirror(outline: Loop) -> Loop:
    """The outline on the other side of the face, running the same way round."""
    turned = tuple((-x, y, corner) for x, y, corner in reversed(outline))
    if isinstance(outline, Ribbon):
        return Ribbon.along(turned, tuple((-x, y) for x, y in reversed(outline.spine)))
    return turned


def both(part: Part) -> tuple[Part, Part]:
    """A part drawn for the image's right side (the face's left), and its mirror image; ids end in the face's side."""
    left = replace(part, id=f"{part.id}-left")
    right = replace(part, id=f"{part.id}-right", loops=tuple(mirror(outline) for outline in part.loops))
    return right, left
