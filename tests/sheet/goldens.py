"""A kind's sheet as it is drawn now and as it is kept: how far they are apart, and a page that shows it."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from facescript.diagnostics.model import Diagnostics
from facescript.resolve.expressions import expressions
from facescript.resolve.resolver import resolve
from facescript.sheet.cells import sections
from facescript.sheet.page import Page, Spot, lay_out
from facescript.sheet.png import sheet
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

FOLDER = Path(__file__).with_name("golden")
PAGES = Path(__file__).parents[2] / "build" / "sheets"

CELL = 96
"""Wide and high, px: a lid, a lip's corner and a brow can still be told."""

TILE, MEAN, WORST = 16, 0.1, 1.5
"""Tiles of so many px, and the most that a whole sheet and its worst tile may differ, of 255 a channel: room for the
last bit of another machine's sine, not for a brow that rises a fifth less."""

STRONG = 6
"""Times that the picture of a difference shows it."""

Pixels = NDArray[np.uint8]


def page_of(script: str, name: str = "script.face", units: bool = False, side: int = CELL) -> Page:
    """The sheet of a script's faces."""
    diagnostics = Diagnostics()
    tree, world = parse(Source(name, script), diagnostics), World(Path(__file__).parent)
    play = resolve(tree, world, diagnostics)
    assert play is not None, [item.message for item in diagnostics]
    return lay_out(name, play.faces, sections(expressions(tree, world), units), side)


def page_of_kind(kind: str) -> Page:
    return page_of(f"face x = {kind}\n", kind)


@dataclass(frozen=True, slots=True)
class Difference:
    """How far two pictures of one size are apart: array[row, column] of the means of tiles, and of the whole."""

    tiles: NDArray[np.float64]
    mean: float

    @property
    def worst(self) -> float:
        return float(self.tiles.max())

    @property
    def small(self) -> bool:
        return self.mean <= MEAN and self.worst <= WORST

    def at(self, spot: Spot) -> float:
        """The worst tile that a cell has a part in."""
        low, left, high, right = (
            edge // TILE for edge in (spot.top, spot.left, spot.top + spot.side - 1, spot.left + spot.side - 1)
        )
        return float(self.tiles[low : high + 1, left : right + 1].max())


def difference(before: Pixels, after: Pixels) -> Difference:
    """Of two pictures array[y, x, rgb] of one size."""
    apart = np.abs(before.astype(np.int16) - after).mean(axis=2)
    ragged = [(0, -length % TILE) for length in apart.shape]
    padded = np.pad(apart, ragged)
    rows, columns = (length // TILE for length in padded.shape)
    return Difference(padded.reshape(rows, TILE, columns, TILE).mean(axis=(1, 3)), float(apart.mean()))


@dataclass(frozen=True, slots=True)
class Comparison:
    """A kind's sheet before and after; `difference` is None where the sheets are not of one size."""

    kind: str
    page: Page
    before: Pixels
    after: Pixels
    difference: Difference | None

    @property
    def same(self) -> bool:
        return self.difference is not None and self.difference.small

    def told(self) -> str:
        """The result in a line."""
        if self.difference is None:
            before, after = (f"{each.shape[1]}x{each.shape[0]}" for each in (self.before, self.after))
            return f"{self.kind}: the sheet was {before} and is {after}"
        figures = f"{self.difference.mean:.2f} (up to {MEAN}), worst tile {self.difference.worst:.1f} (up to {WORST})"
        cells = ", ".join(spot.cell.label for spot in self.changed()[:8])
        return f"{self.kind}: mean difference {figures}" + (f": {cells}" if cells else "")

    def changed(self) -> list[Spot]:
        """The cells that look other than before, the most changed first."""
        apart = self.difference
        if apart is None:
            return []
        return sorted((spot for spot in self.page.spots if apart.at(spot) > WORST), key=apart.at, reverse=True)


def compare(kind: str) -> Comparison:
    """The kind's sheet now, in the colours of the one that is kept, beside that one."""
    page = page_of_kind(kind)
    drawn, path = sheet(page), FOLDER / f"{kind}.png"
    if not path.exists():
        return Comparison(kind, page, np.zeros((0, 0, 3), np.uint8), np.asarray(drawn), None)
    kept = Image.open(path)
    before, after = (np.asarray(each.convert("RGB")) for each in (kept, _in_colours(drawn, kept)))
    return Comparison(kind, page, before, after, difference(before, after) if before.shape == after.shape else None)


def keep(kind: str) -> None:
    """The sheet as it is now becomes the one that is kept, in as many colours as a palette holds."""
    FOLDER.mkdir(exist_ok=True)
    drawn = sheet(page_of_kind(kind))
    colours = drawn.quantize(256, Image.Quantize.MEDIANCUT, kmeans=1)
    _in_colours(drawn, colours).save(FOLDER / f"{kind}.png", "PNG", optimize=True)


def _in_colours(picture: Image.Image, colours: Image.Image) -> Image.Image:
    """The same picture gives the same pixels; no other way of choosing them comes in between."""
    return picture.quantize(palette=colours, dither=Image.Dither.NONE)


# ------------------------------------------------------------------------------------------------ the page

HEAD = """\
<!doctype html>
<meta charset="utf-8">
<title>{told}</title>
<style>
body {{ font: 13px sans-serif; margin: 24px }}
table {{ border-spacing: 12px }}
td {{ vertical-align: top }}
.cells img {{ width: {wide}px; image-rendering: pixelated }}
</style>
<h1>{told}</h1>
"""


def show(found: Comparison) -> Path:
    """Writes a page with before, after and difference, of the cells that changed and of the whole; gives its path."""
    PAGES.mkdir(parents=True, exist_ok=True)
    path = PAGES / f"{found.kind}.html"
    path.write_text("".join(_parts(found)), "utf-8")
    return path


def _parts(found: Comparison, most: int = 40) -> Iterator[str]:
    yield HEAD.format(told=escape(found.told()), wide=2 * CELL)
    names = "<tr><th><th>before<th>after<th>difference</tr>"
    yield f'<table class="cells">{names}'
    for spot in found.changed()[:most]:
        part = slice(spot.top, spot.top + spot.side), slice(spot.left, spot.left + spot.side)
        yield _row(spot.cell.label, found.before[part], found.after[part])
    yield f"</table><table>{names}{_row('all', found.before, found.after)}</table>"


def _row(label: str, before: Pixels, after: Pixels) -> str:
    pictures = [before, after]
    if before.shape == after.shape:
        apart = np.abs(before.astype(np.int16) - after) * STRONG
        pictures.append(255 - np.minimum(apart, 255).astype(np.uint8))
    return f"<tr><td>{escape(label)}{''.join(f'<td>{_image(each)}' for each in pictures)}</tr>"


def _image(pixels: Pixels) -> str:
    if not pixels.size:
        return "none"
    data = io.BytesIO()
    Image.fromarray(pixels).save(data, "PNG")
    return f'<img src="data:image/png;base64,{base64.b64encode(data.getvalue()).decode()}">'
