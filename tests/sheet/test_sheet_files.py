"""Sheets as files: all pictures in their places on the page, SVG and HTML that stand alone, the same bytes again."""

from __future__ import annotations

import re
from itertools import combinations, pairwise
from pathlib import Path

import numpy as np
import pytest
from chromium import Page as Browser
from chromium import program
from goldens import page_of, page_of_kind
from lxml import etree
from PIL import Image

from facescript.plot.marks import Text
from facescript.sheet.html import write_html
from facescript.sheet.page import GROUND, Page, SheetFault, Spot
from facescript.sheet.png import write_png
from facescript.sheet.svg import write_svg

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def page() -> Page:
    return page_of("face ada = woman, hair #e0b35c\nface bruno = man\n", side=64)


def apart(first: Spot, second: Spot) -> bool:
    across = first.left + first.side <= second.left or second.left + second.side <= first.left
    return across or first.top + first.side <= second.top or second.top + second.side <= first.top


def test_cells_lie_apart_and_on_the_page(page: Page) -> None:
    drawing = page.drawing
    for spot in page.spots:
        assert spot.left > 0 and spot.left + spot.side < drawing.width
        assert spot.top > 0 and spot.top + spot.side < drawing.height
    assert all(apart(*pair) for pair in combinations(page.spots, 2))
    lines = sorted({mark.y for mark in drawing.marks if isinstance(mark, Text)})
    assert all(after - before > 12 for before, after in pairwise(lines))


def test_texts_lie_beside_the_cells(page: Page) -> None:
    for mark in page.drawing.marks:
        if isinstance(mark, Text):
            assert not any(spot.top - 2 < mark.y < spot.top + spot.side + mark.size - 2 for spot in page.spots), mark
    assert len([mark for mark in page.drawing.marks if isinstance(mark, Text) and mark.text == "happiness"]) == 2


def test_a_page_is_bounded() -> None:
    with pytest.raises(SheetFault) as fault:
        page_of("".join(f"face f{number} = woman\n" for number in range(40)))
    assert fault.value.code == "FS933"


def test_png_has_a_face_in_every_cell_and_no_two_alike(page: Page, tmp_path: Path) -> None:
    write_png(page, tmp_path / "sheet.png")
    pixels = np.asarray(Image.open(tmp_path / "sheet.png"))
    ground = np.array([int(GROUND[at : at + 2], 16) for at in (1, 3, 5)])
    pictures = [pixels[s.top : s.top + s.side, s.left : s.left + s.side] for s in page.spots]
    assert all(0.2 < (each != ground).any(axis=2).mean() < 0.9 for each in pictures)
    heads = {each.tobytes() for each, spot in zip(pictures, page.spots, strict=True) if spot.cell.turn != (0, 0)}
    assert len(heads) == sum(spot.cell.turn != (0, 0) for spot in page.spots)
    write_png(page, tmp_path / "again.png")
    assert (tmp_path / "sheet.png").read_bytes() == (tmp_path / "again.png").read_bytes()


def test_svg_stands_alone(page: Page, tmp_path: Path) -> None:
    write_svg(page, tmp_path / "sheet.svg")
    root = etree.parse(tmp_path / "sheet.svg").getroot()
    ids = [element.get("id") for element in root.iter() if element.get("id")]
    assert len(ids) == len(set(ids))
    text = (tmp_path / "sheet.svg").read_text("utf-8")
    assert set(re.findall(r'(?:href="|url\()#([\w-]+)', text)) == set(ids)
    assert "http" not in text.replace("http://www.w3.org/2000/svg", "")
    cells = [element for element in root if element.tag == f"{SVG}svg"]
    assert [cell.findtext(f"{SVG}title") for cell in cells] == [
        f"{spot.face.name}: {spot.cell.label}" for spot in page.spots
    ]
    write_svg(page, tmp_path / "again.svg")
    assert (tmp_path / "sheet.svg").read_bytes() == (tmp_path / "again.svg").read_bytes()


def test_html_holds_the_svg_and_nothing_hostile(tmp_path: Path) -> None:
    page = page_of("face ada = man\n", name="</title><script>x</script>.face", side=64)
    write_html(page, tmp_path / "sheet.html")
    text = (tmp_path / "sheet.html").read_text("utf-8")
    assert text.startswith("<!doctype html>") and text.count("<svg") == 1 + len(page.spots)
    assert "<script" not in text and "src=" not in text


@pytest.mark.skipif(program() is None, reason="no Chromium on this machine")
def test_a_browser_draws_the_svg_as_the_png_is(tmp_path: Path) -> None:
    """In every cell, whose paths come from all over the file; labels are in another font."""
    page = page_of_kind("woman")
    write_png(page, tmp_path / "sheet.png")
    write_html(page, tmp_path / "sheet.html")
    mine = np.asarray(Image.open(tmp_path / "sheet.png")).astype(int)
    with Browser((tmp_path / "sheet.html").as_uri(), page.drawing.width, page.drawing.height) as browser:
        seen = browser.picture().astype(int)
    assert seen.shape == mine.shape
    for spot in page.spots:
        part = slice(spot.top, spot.top + spot.side), slice(spot.left, spot.left + spot.side)
        assert np.abs(seen[part] - mine[part]).mean() < 2.0, spot.cell.label
