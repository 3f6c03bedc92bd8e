"""A sheet to an `.svg`: the page, and each face as paths in its places; what two places share is written once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import groupby
from pathlib import Path

import numpy as np
from lxml import etree

from facescript.backends.svg.paint import Paints
from facescript.backends.svg.path import Ints, numbers
from facescript.backends.svg.track import svg
from facescript.plot.svg import document, told
from facescript.rig.picture import Shape, unturned
from facescript.sheet.page import Page, Spot
from facescript.sheet.poses import Floats, Portraits, portraits

SIDE = 720
"""A face is drawn so wide, to whole units, and made small: that is a quarter of a pixel of a usual cell."""

ANGLE = 2
"""Decimals of the degrees that a shape is rolled."""

SHADE = 100
"""Steps of opacity from clear to full."""


def write_svg(page: Page, path: Path) -> None:
    """One self-contained file, the same bytes each time."""
    path.write_bytes(etree.tostring(sheet(page), encoding="utf-8", xml_declaration=True) + b"\n")


def sheet(page: Page) -> etree._Element:
    """The whole page as one `svg` element."""
    root, pens = document(page.drawing), Pens()
    for _, group in groupby(page.spots, key=lambda spot: (spot.face.name, spot.close)):
        spots = list(group)
        drawn = portraits(spots[0].face, [spot.cell for spot in spots], SIDE, spots[0].close)
        for number, spot in enumerate(spots):
            root.append(_portrait(spot, drawn, number, pens.of(spot.face.name, drawn.shapes)))
    definitions = svg("defs")
    definitions.extend(pens.definitions())
    root.insert(2, definitions)
    return root


def _portrait(spot: Spot, drawn: Portraits, number: int, pen: Pen) -> etree._Element:
    """A picture in the picture, which cuts off what goes beyond it."""
    place = {"x": str(spot.left), "y": str(spot.top), "width": str(spot.side), "height": str(spot.side)}
    element = svg("svg", viewBox=f"0 0 {SIDE} {SIDE}", data_face=spot.face.name, **place)
    element.append(told("title", f"{spot.face.name}: {spot.cell.label}"))
    element.extend(pen.paths(drawn, number))
    return element


class Pens:
    """A pen a face."""

    def __init__(self) -> None:
        self._pens: dict[str, Pen] = {}

    def of(self, face: str, shapes: tuple[Shape, ...]) -> Pen:
        """The pen that draws a face of these shapes."""
        return self._pens.setdefault(face, Pen(face, shapes))

    def definitions(self) -> Iterator[etree._Element]:
        """What all that was drawn refers to."""
        for pen in self._pens.values():
            yield from (*pen.paints.elements(), *pen.clips.values())


class Pen:
    """Shapes of one face to elements. Paths, clips and paints that come again are the first ones used again."""

    def __init__(self, face: str, shapes: tuple[Shape, ...]) -> None:
        self.face = face
        self.paints = Paints(face, [replace(shape, id=f"{face}-{shape.id}") for shape in shapes])
        self.clips: dict[tuple[str, ...], etree._Element] = {}
        self._paths: dict[tuple[str, ...], etree._Element] = {}
        self._shared = 0

    def paths(self, drawn: Portraits, number: int) -> Iterator[etree._Element]:
        """The visible shapes of one cell. Those with a gradient are drawn upright, and rolled with all they hold."""
        named = {shape.id: shape for shape in drawn.shapes}
        levels = np.rint(drawn.opacity[number] * SHADE).astype(int).tolist()
        graded = [not isinstance(shape.fill, str) for shape in drawn.shapes]
        angles = (np.degrees(drawn.turns[number]).round(ANGLE) * graded).tolist()
        places = {angle: _upright(drawn.points[number], angle) for angle in set(angles)}
        for shape, level, angle in zip(drawn.shapes, levels, angles, strict=True):
            if level > 0:
                outlines = {name: _outline(named[name], places[angle]) for name in (shape.id, *shape.clip)}
                yield self._path(shape, outlines, level, angle)

    def _path(self, shape: Shape, outlines: dict[str, str], level: int, angle: float) -> etree._Element:
        clip = self._clip(outlines[name] for name in shape.clip) if shape.clip else ""
        look = {**self.paints.fill(shape.fill), "d": outlines[shape.id]}
        look |= {"transform": f"rotate({angle:g})"} if angle else {}
        look |= {"opacity": f"{level / SHADE:g}"} if level < SHADE else {}
        look |= {"clip_path": f"url(#{clip})"} if clip else {}
        first = self._paths.get(key := tuple(look.values()))
        if first is None:
            self._paths[key] = path = svg("path", **look)
            return path
        if first.get("id") is None:
            self._shared += 1
            first.set("id", f"{self.face}-p{self._shared}")
        return svg("use", href=f"#{first.get('id')}")

    def _clip(self, outlines: Iterable[str]) -> str:
        key = tuple(outlines)
        if key not in self.clips:
            self.clips[key] = element = svg("clipPath", id=f"{self.face}-c{len(self.clips) + 1}")
            element.extend(svg("path", d=outline) for outline in key)
        return str(self.clips[key].get("id"))


def _upright(points: Floats, angle: float) -> Ints:
    """Points array[point, xy] that are turned by so many degrees clockwise, turned back, in whole units."""
    return np.rint(unturned(points, np.radians(angle))).astype(np.int64)


def _outline(shape: Shape, places: Ints) -> str:
    """A shape's contours in whole units: relative cubics, which start where the contour before ended."""
    parts, at = [], np.zeros(2, dtype=np.int64)
    for each in shape.contours:
        contour = places[each.first : each.first + each.count]
        anchors = np.repeat(contour[:-1:3], 3, axis=0)
        parts.append(f"m{numbers(contour[0] - at)}c{numbers(contour[1:] - anchors)}")
        at = contour[-1]
    return "".join(parts)
