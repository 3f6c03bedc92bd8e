"""A plot to a `.png`: areas and lines by ThorVG, text over them in Pillow's own font."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import ceil, dist, floor
from pathlib import Path as File

import numpy as np
from PIL import Image, ImageDraw

from facescript.backends.frames import drawing_faults
from facescript.canvas.lines import Path
from facescript.canvas.thorvg import Canvas
from facescript.plot.font import FINE, drawable, font, has
from facescript.plot.marks import Area, Drawing, Line, Point, Text

ANCHORS = {"start": "ls", "middle": "ms", "end": "rs"}
"""Which end of a text is at its place, in Pillow's words."""


MOST_POINTS = 100
"""Points of a piece of a line: ThorVG leaves out what has too many corners in too little room."""


def write_png(drawing: Drawing, path: File) -> None:
    """RGB, a pixel a px, the same bytes each time. Raises `JobFailure`."""
    picture(drawing).save(path, "PNG", optimize=True)


def picture(drawing: Drawing) -> Image.Image:
    """The drawing in RGB, a pixel a px. Raises `JobFailure`."""
    pixels = np.full((drawing.height, drawing.width), 0xFFFFFFFF, dtype=np.uint32)
    with drawing_faults():
        Canvas(
            pixels, [path for mark in drawing.marks if not isinstance(mark, Text) for path in _outlines(mark)]
        ).draw()
    colours = np.stack([(pixels >> shift & 0xFF).astype(np.uint8) for shift in (16, 8, 0)], axis=-1)
    image = Image.fromarray(colours)
    for mark in drawing.marks:
        if isinstance(mark, Text):
            _write(image, mark)
    return image


def _write(image: Image.Image, mark: Text) -> None:
    """Lay a text over the picture: drawn large, and made small again."""
    text, large = drawable(mark.text), font(mark.size * FINE)
    left, top, right, bottom = large.getbbox(text, anchor=ANCHORS[mark.anchor])
    first = floor(mark.x + left / FINE), floor(mark.y + top / FINE)
    size = ceil((right - left) / FINE) + 2, ceil((bottom - top) / FINE) + 2
    mask = Image.new("L", (size[0] * FINE, size[1] * FINE))
    place = round((mark.x - first[0]) * FINE), round((mark.y - first[1]) * FINE)
    ImageDraw.Draw(mask).text(place, text, 255, large, ANCHORS[mark.anchor])
    image.paste(Image.new("RGB", size, mark.colour), first, mask.reduce(FINE))


def lacking(drawing: Drawing) -> str:
    """The letters of a plot that the font has not, each once."""
    texts = (mark.text for mark in drawing.marks if isinstance(mark, Text))
    return "".join(dict.fromkeys(letter for text in texts for letter in text if not has(letter)))


def _outlines(mark: Area | Line) -> Iterator[Path]:
    if isinstance(mark, Line):
        for part in mark.parts:
            yield from _pieces(part, mark)
        return
    area = Path(mark.points, True, mark.fill, mark.edge)
    if mark.edge:
        area.stroke(1.0)
    yield area


def _pieces(points: Sequence[Point], line: Line) -> Iterator[Path]:
    """A line in pieces that ThorVG can draw, its dashes running on from each to the next."""
    along = 0.0
    for first in range(0, max(1, len(points) - 1), MOST_POINTS):
        part = points[first : first + MOST_POINTS + 1]
        piece = Path(part, False, "", line.colour)
        piece.stroke(line.width, line.dash, along)
        yield piece
        along += sum(dist(*pair) for pair in pairwise(part))
