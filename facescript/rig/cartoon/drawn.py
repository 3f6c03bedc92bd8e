"""A kind as data and the looks chosen -> the parts it is drawn from, in drawing order, and its measures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from typing import Any

from facescript.ir.kind import Fill, Kind, KindOutline, KindPoint, KindShape, Measures, Tone
from facescript.performance.channels import SIDES
from facescript.rig.cartoon.outline import POINTED, Depths, Loop, Part, disc, loop, mirror, ribbon, spot
from facescript.rig.cartoon.palette import Palette, mix
from facescript.rig.picture import Linear, Paint, Radial, Stop

Choices = Mapping[str, str]
"""What is chosen of a kind's looks, by name."""


def parts_of(kind: Kind, palette: Palette, choices: Choices) -> tuple[Part, ...]:
    """All parts, back to front; of shapes that stand on both sides the face's right is drawn first."""
    shapes = [shape for shape in kind.shapes if _chosen(shape, choices)]
    eyes = [name for each in kind.eyes for name in ((each.name,) if each.name else ("right", "left"))]
    parts = [part for run in _runs(shapes) for part in _laid(run, palette, eyes)]
    there = {part.id for part in parts}
    return tuple(replace(part, clip=tuple(_own(name, part.id, there) for name in part.clip)) for part in parts)


def measured(measures: Measures, lists: Sequence[str] = ()) -> dict[str, Any]:
    """Measures as the fields of a style: a number, or several; `lists` may stand more than once."""
    found: dict[str, Any] = {}
    for name, values in measures.values:
        field = name.replace("-", "_")
        if name in lists:
            found[field] = (*found.get(field, ()), values)
        else:
            found[field] = values[0] if len(values) == 1 else values
    return found


def _chosen(shape: KindShape, choices: Choices) -> bool:
    return all(choices.get(name) in wanted for name, wanted in shape.when)


def _runs(shapes: Sequence[KindShape]) -> Iterator[list[KindShape]]:
    """Shapes as they are laid down: those of one layer that stand on each side in a run, any other alone."""
    for (group, sides), run in groupby(shapes, key=lambda shape: (shape.group, shape.sides)):
        if group and sides == "each":
            yield list(run)
        else:
            yield from ([shape] for shape in run)


def _laid(run: Sequence[KindShape], palette: Palette, eyes: Sequence[str]) -> Iterator[Part]:
    """The parts of a run; those of the layer `eye` once for each eye, others of each side for both."""
    if not run[0].sides:
        yield from (_part(shape, palette) for shape in run)
        return
    sides = eyes if run[0].group == "eye" and run[0].sides == "each" else SIDES[::-1]
    for side in sides:
        yield from (_sided(shape, palette, side) for shape in run)


def _part(shape: KindShape, palette: Palette) -> Part:
    made = [outlined(outline) for outline in shape.outlines]
    loops, depths = tuple(each[0] for each in made), tuple(each[1] for each in made)
    paint = _paint(shape.fill, palette, mirrored=False)
    return Part(shape.id, shape.group, shape.law, paint, loops, shape.opacity, shape.clip, shape.depth, depths)


def _sided(shape: KindShape, palette: Palette, side: str) -> Part:
    part = _part(shape, palette)
    group = f"{part.group}-{side}" if shape.sides == "each" else part.group
    part = replace(part, id=f"{part.id}-{side}", group=group)
    if side != "right":
        return part
    loops, depths = tuple(mirror(each) for each in part.loops), tuple(each[::-1] for each in part.depths)
    return replace(part, loops=loops, depths=depths, fill=_paint(shape.fill, palette, mirrored=True))


def outlined(outline: KindOutline) -> tuple[Loop, Depths]:
    """An outline's anchors, and the depth of each that has one of its own."""
    points = [(*point.numbers, 1) if point.sharp else point.numbers for point in outline.points]
    depths = tuple(point.depth for point in outline.points)
    if outline.form == "half":
        right = loop(*points)
        return right + mirror(right)[1:-1], depths + depths[1:-1][::-1]
    if outline.form == "stroke":
        there = slice(_pointed(outline.points[-1]), len(depths) - _pointed(outline.points[0]))
        return ribbon(*points), depths + depths[::-1][there]
    if outline.form in ("spot", "disc"):
        x, y, rx, ry = outline.points[0].numbers
        return (spot if outline.form == "spot" else disc)(x, y, rx, ry), depths * 4
    return loop(*points), depths


def _pointed(point: KindPoint) -> bool:
    return point.numbers[2] < POINTED


def _own(clip: str, part: str, there: set[str]) -> str:
    """A clip's id for a part: that of its own side or eye, if there is one."""
    own = f"{clip}-{part.rpartition('-')[2]}"
    return own if own in there else clip


def _paint(fill: Fill, palette: Palette, mirrored: bool) -> Paint:
    if fill.form == "plain":
        return _colour(fill.stops[0].tone, palette)
    stops = tuple(Stop(stop.at, _colour(stop.tone, palette), stop.opacity) for stop in fill.stops)
    if fill.form == "round":
        x, y, radius = fill.where
        return Radial(stops, (x, y), radius)
    x0, y0, x1, y1 = fill.where
    if fill.outward and mirrored:
        x0, x1 = 1.0 - x0, 1.0 - x1
    return Linear(stops, (x0, y0), (x1, y1))


def _colour(tone: Tone, palette: Palette) -> str:
    first = palette.get(tone.name, tone.name)
    return mix(first, palette.get(tone.other, tone.other), tone.share) if tone.other else first
