"""Faces and their sections to a page: a grid of places for each section's cells, with titles and labels around them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import ceil

from facescript.ir.play import Face
from facescript.plot.font import fit, width
from facescript.plot.looks import GREY, INK, PAPER
from facescript.plot.marks import LARGE, LARGEST, SMALL, Drawing, Mark, Text, box
from facescript.sheet.cells import FIRST, Cell, Section

COLUMNS = 7
"""Cells beside each other: as many as the grids of poses have. Of the first section, which is large, all its cells."""

CELL, SMALLEST, BIGGEST = 160, 64, 320
"""The side of a cell unless one is asked for, and the least and the most, px."""

MARGIN, GAP = 32, 10
"""Around the page, and between cells, px."""

TITLE, HEADING, LABEL, BETWEEN = 40, 40, 26, 40
"""Heights of a face's name, of a section's title, of a label below its cell, and of what is free between faces, px."""

HIGHEST = 20_000
"""Pixels of the highest page."""

GROUND = "#f3f0ea"
"""Behind every face."""


class SheetFault(Exception):
    """A sheet that cannot be drawn: a code and the values of its sentence."""

    def __init__(self, code: str, **values: object) -> None:
        super().__init__(code)
        self.code, self.values = code, values


@dataclass(frozen=True, slots=True)
class Spot:
    """Where a face stands in a cell: the left upper corner and the side, px; `close` is how it is seen."""

    face: Face
    cell: Cell
    left: int
    top: int
    side: int
    close: bool


@dataclass(frozen=True, slots=True)
class Page:
    """All but the faces, and where these stand, face by face."""

    drawing: Drawing
    spots: tuple[Spot, ...]


@dataclass(frozen=True, slots=True)
class Grid:
    """A section `top` px below its face's edge: `heading` px of title, then `columns` cells of `side` px a row."""

    section: Section
    top: int
    heading: int
    columns: int
    side: int

    @property
    def bottom(self) -> int:
        return self.top + self.heading + ceil(len(self.section.cells) / self.columns) * (self.side + LABEL)

    def spots(self, face: Face, top: int) -> Iterator[Spot]:
        """Its places for a face whose upper edge is at `top`."""
        for number, cell in enumerate(self.section.cells):
            row, column = divmod(number, self.columns)
            across, down = column * (self.side + GAP), row * (self.side + LABEL)
            upper = top + self.top + self.heading + down
            yield Spot(face, cell, MARGIN + across, upper, self.side, self.section.close)


def lay_out(name: str, faces: Sequence[Face], sections: Sequence[Section], side: int) -> Page:
    """The page of a script or kind called `name`: a block a face, cells of `side` px. Raises `SheetFault`."""
    room = COLUMNS * (side + GAP) - GAP
    grids = _grids(sections, side, room)
    block = grids[-1].bottom + BETWEEN
    wide, height = room + 2 * MARGIN, 2 * MARGIN + len(faces) * block - BETWEEN
    if height > HIGHEST:
        raise SheetFault("FS933", height=height, most=HIGHEST)
    marks: list[Mark] = [box(0, 0, wide, height, PAPER)]
    spots: list[Spot] = []
    for number, face in enumerate(faces):
        top = MARGIN + number * block
        marks += [*_told(name, face, top, room), *_titles(grids, top)]
        spots += [spot for grid in grids for spot in grid.spots(face, top)]
    marks += [mark for spot in spots for mark in _around(spot)]
    told = f"{len(spots)} pictures. " + ". ".join(section.title for section in sections)
    return Page(Drawing(wide, height, name, told, marks), tuple(spots))


def _grids(sections: Sequence[Section], side: int, room: int) -> list[Grid]:
    """The sections one under another; the first is as wide as the page."""
    count = len(FIRST.cells)
    grids = [Grid(FIRST, 0, TITLE, count, (room - (count - 1) * GAP) // count)]
    for section in sections:
        grids.append(Grid(section, grids[-1].bottom, HEADING, COLUMNS, side))
    return grids


def _told(name: str, face: Face, top: int, room: int) -> Iterator[Mark]:
    """What a face is called, and on the right what it is like."""
    kind = name == face.kind
    title = fit(name if kind else f"{face.name}, {name}", LARGEST, room)
    looks = "" if kind else ", ".join([face.kind, *(f"{what} {how}" for what, how in face.looks)])
    left = width(title, LARGEST) + 2 * GAP
    yield Text(MARGIN, top + LARGEST, title, LARGEST, "start", INK)
    if looks:
        yield Text(MARGIN + room, top + LARGEST, fit(looks, SMALL, room - left), SMALL, "end", GREY)


def _titles(grids: Sequence[Grid], top: int) -> Iterator[Mark]:
    for grid in grids[1:]:
        yield Text(MARGIN, top + grid.top + grid.heading - GAP, grid.section.title, LARGE, "start", INK)


def _around(spot: Spot) -> Iterator[Mark]:
    """A cell's ground and label."""
    yield box(spot.left, spot.top, spot.left + spot.side, spot.top + spot.side, GROUND)
    label = fit(spot.cell.label, SMALL, spot.side)
    yield Text(spot.left + spot.side / 2, spot.top + spot.side + SMALL + 4, label, SMALL, "middle", GREY)
