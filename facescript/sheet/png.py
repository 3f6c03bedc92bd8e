"""A sheet to a `.png`: the page, and each face painted into its places."""

from __future__ import annotations

from itertools import groupby
from pathlib import Path

import numpy as np
from PIL import Image

from facescript.backends.frames import drawing_faults
from facescript.canvas.painter import Painter
from facescript.canvas.thorvg import colour
from facescript.plot.png import picture
from facescript.sheet.page import GROUND, Page, Spot
from facescript.sheet.poses import portraits


def write_png(page: Page, path: Path) -> None:
    """RGB, a pixel a px, the same bytes each time. Raises `JobFailure`."""
    sheet(page).save(path, "PNG", optimize=True)


def sheet(page: Page) -> Image.Image:
    """The whole page in RGB. Raises `JobFailure`."""
    image = picture(page.drawing)
    with drawing_faults():
        for _, spots in groupby(page.spots, key=lambda spot: (spot.face.name, spot.side, spot.close)):
            _paint(image, list(spots))
    return image


def _paint(image: Image.Image, spots: list[Spot]) -> None:
    """Paint one face into places where it is as large."""
    face, side, close = spots[0].face, spots[0].side, spots[0].close
    drawn = portraits(face, [spot.cell for spot in spots], side, close)
    painter = Painter(side, side, drawn.shapes)
    red, green, blue = colour(GROUND)
    ground = np.full((side, side), 0xFF << 24 | red << 16 | green << 8 | blue, dtype=np.uint32)
    for spot, points, opacity, turns in zip(spots, drawn.points, drawn.opacity, drawn.turns, strict=True):
        painter.draw(points, opacity, ground, turns)
        channels = [(painter.pixels >> shift & 0xFF).astype(np.uint8) for shift in (16, 8, 0)]
        image.paste(Image.fromarray(np.stack(channels, axis=-1)), (spot.left, spot.top))
