"""What a plot is made of: areas, lines and texts in pixels, from which both writers draw the same picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from facescript.plot.looks import INK

SMALL, LARGE, LARGEST = 11, 14, 17
"""Sizes of text, px: labels; a face's name; the title."""

Point = tuple[float, float]
"""px from the picture's left and top."""


@dataclass(frozen=True, slots=True)
class Area:
    """A filled polygon with an edge of one pixel where `edge` is a colour; `note` is told by an SVG on pointing."""

    points: tuple[Point, ...]
    fill: str
    edge: str = ""
    note: str = ""


@dataclass(frozen=True, slots=True)
class Line:
    """Lines of one look; `dash` are lengths drawn and left out by turns. `name` is the channel that is drawn."""

    parts: tuple[tuple[Point, ...], ...]
    colour: str
    width: float = 1.0
    dash: tuple[float, ...] = ()
    name: str = ""


@dataclass(frozen=True, slots=True)
class Text:
    """One line of text; `y` is its base line, `anchor` says which of its ends or its middle is at `x`."""

    x: float
    y: float
    text: str
    size: int = SMALL
    anchor: str = "start"
    colour: str = INK


Mark = Area | Line | Text


@dataclass(frozen=True, slots=True)
class Drawing:
    """A picture: its size in px, what it is called, what it is of, and its marks, the first undermost."""

    width: int
    height: int
    title: str
    description: str
    marks: Sequence[Mark]


def box(left: float, top: float, right: float, bottom: float, fill: str, edge: str = "") -> Area:
    """A rectangle."""
    return Area(((left, top), (right, top), (right, bottom), (left, bottom)), fill, edge)


def upright(x: float, top: float, bottom: float, colour: str) -> Line:
    """A vertical hairline on whole pixels."""
    return Line((((crisp(x), top), (crisp(x), bottom)),), colour)


def level(left: float, right: float, y: float, colour: str) -> Line:
    """A horizontal hairline on whole pixels."""
    return Line((((left, crisp(y)), (right, crisp(y))),), colour)


def crisp(place: float) -> float:
    """The middle of the nearest pixel, so that a hairline covers it and no other."""
    return round(place - 0.5) + 0.5
