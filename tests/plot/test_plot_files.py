"""Plots as files: SVG that any reader takes, PNG that shows what it should."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from lxml import etree
from PIL import Image
from plotting import curves, plot, texts

from facescript.plot.looks import PAPER
from facescript.plot.marks import Drawing, Line, Text, box
from facescript.plot.png import lacking, write_png
from facescript.plot.svg import write_svg

SVG = "{http://www.w3.org/2000/svg}"
SCRIPT = 'face ada = woman\n    life calm\nlook left 10deg\nsay "Here I am"\nnod\n'


def svg_of(drawing: Drawing, folder: Path) -> etree._Element:
    write_svg(drawing, folder / "plot.svg")
    return etree.parse(folder / "plot.svg").getroot()


def png_of(drawing: Drawing, folder: Path) -> np.ndarray:
    write_png(drawing, folder / "plot.png")
    return np.asarray(Image.open(folder / "plot.png"))


def test_svg_says_what_the_drawing_says(tmp_path: Path) -> None:
    drawing = plot(SCRIPT)
    root = svg_of(drawing, tmp_path)
    assert [element.text for element in root.iter(f"{SVG}text")] == texts(drawing)
    assert [element.get("data-channel") for element in root.iter() if "data-channel" in element.attrib] == curves(
        drawing
    )
    assert root.findtext(f"{SVG}title") == "script.face, seed 0"
    assert "ada: Here I am" in (root.findtext(f"{SVG}desc") or "")
    assert {"Here", "am", "nod", "“Here I am”"} <= {element.text for element in root.iter(f"{SVG}text")}


def test_svg_escapes_what_is_hostile(tmp_path: Path) -> None:
    nasty = '<script>alert(1)</script> & ]]> "\x00\x07\ufffe'
    marks = [box(0, 0, 9, 9, PAPER), Text(1, 8, nasty), Line((((0, 0), (9, 9)),), "#000000", name='"><b>')]
    root = svg_of(Drawing(10, 10, nasty, nasty, marks), tmp_path)
    assert {etree.QName(element).localname for element in root.iter()} == {"svg", "title", "desc", "path", "text"}
    assert (root.findtext(f"{SVG}text") or "").startswith("<script>alert(1)</script> & ]]>")


def test_hostile_words_of_a_script(tmp_path: Path) -> None:
    root = svg_of(plot('face ada = woman\nsay "</text><script>x</script> &amp;"\n'), tmp_path)
    assert not list(root.iter(f"{SVG}script"))
    assert any("&amp;" in (element.text or "") for element in root.iter(f"{SVG}text"))


def test_png_is_the_picture_and_the_same_each_time(tmp_path: Path) -> None:
    drawing = plot(SCRIPT, size=(900, 800))
    pixels = png_of(drawing, tmp_path)
    first = (tmp_path / "plot.png").read_bytes()
    assert pixels.shape == (800, 900, 3)
    assert 0.005 < (pixels != 255).any(axis=2).mean() < 0.5
    png_of(plot(SCRIPT, size=(900, 800)), tmp_path)
    assert (tmp_path / "plot.png").read_bytes() == first


def test_png_draws_the_lines_where_they_are(tmp_path: Path) -> None:
    line = Line((((10.0, 20.5), (90.0, 20.5)),), "#d55e00", 3.0)
    pixels = png_of(Drawing(100, 40, "", "", [box(0, 0, 100, 40, PAPER), line]), tmp_path)
    assert (pixels[20, 12:88] == (0xD5, 0x5E, 0x00)).all()
    assert (pixels[[10, 30]] == 255).all()


def test_png_keeps_dense_lines(tmp_path: Path) -> None:
    """A line with thousands of corners is drawn all along."""
    zigzag = tuple((10 + number / 4, 10.0 + 80 * (number % 2)) for number in range(4000))
    pixels = png_of(Drawing(1020, 100, "", "", [box(0, 0, 1020, 100, PAPER), Line((zigzag,), "#0072b2")]), tmp_path)
    assert (pixels[20:80, 12:1008] < 200).any(axis=2).all(axis=0).all()


def test_png_draws_text_at_its_anchor(tmp_path: Path) -> None:
    for anchor, columns in (("start", (50, 100)), ("middle", (25, 75)), ("end", (0, 50))):
        drawing = Drawing(100, 30, "", "", [box(0, 0, 100, 30, PAPER), Text(50, 20, "nnnnn", 14, anchor)])
        inked = np.flatnonzero((png_of(drawing, tmp_path) < 200).any(axis=(0, 2)))
        assert inked.min() >= columns[0] - 1 and inked.max() <= columns[1], anchor


def test_letters_that_the_font_lacks_are_named_once() -> None:
    drawing = Drawing(9, 9, "", "", [Text(0, 0, "été 小明"), Text(0, 0, "小")])
    assert lacking(drawing) == "é小明"


def test_ten_minutes_stay_small(tmp_path: Path) -> None:
    """Talk, gaze, expressions and life."""
    say = 'look left 20deg for 1s\nsay "One two three four five six seven eight"\nshow smile 50% for 1s\nnod\n'
    drawing = plot(f"film 600s long\nface ada = woman\n    life conversation\n{say * 130}")
    write_svg(drawing, tmp_path / "plot.svg")
    write_png(drawing, tmp_path / "plot.png")
    assert (tmp_path / "plot.svg").stat().st_size < 1_000_000
    assert (tmp_path / "plot.png").stat().st_size < 1_000_000
