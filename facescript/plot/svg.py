"""A plot to an `.svg`: text as text, each curve with its channels' names, each act with its note."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

from lxml import etree

from facescript.backends.svg.document import UNFIT
from facescript.backends.svg.track import SVG, svg
from facescript.plot.font import width
from facescript.plot.marks import Drawing, Line, Mark, Point, Text

FONT = "Aileron, Helvetica, Arial, 'Liberation Sans', sans-serif"
"""Of one width with the font that texts are measured in, or near it; `textLength` sees to the rest."""

STEPS = 10
"""Steps a pixel to which coordinates are rounded."""


def write_svg(drawing: Drawing, path: Path) -> None:
    """One self-contained file, the same bytes each time."""
    path.write_bytes(etree.tostring(document(drawing), encoding="utf-8", xml_declaration=True) + b"\n")


def document(drawing: Drawing) -> etree._Element:
    """The drawing as one `svg` element."""
    size = {"width": str(drawing.width), "height": str(drawing.height)}
    box = {"viewBox": f"0 0 {drawing.width} {drawing.height}", "role": "img"}
    root = etree.Element(f"{{{SVG}}}svg", {**size, **box, "font-family": FONT}, nsmap={None: SVG})
    root.append(told("title", drawing.title))
    root.append(told("desc", drawing.description))
    root.extend(_element(mark) for mark in drawing.marks)
    return root


def _element(mark: Mark) -> etree._Element:
    if isinstance(mark, Text):
        return _text(mark)
    if isinstance(mark, Line):
        return _line(mark)
    edge = {"stroke": mark.edge, "stroke_width": "1"} if mark.edge else {}
    element = svg("path", d=f"{_path(mark.points)}z", fill=mark.fill or "none", **edge)
    if mark.note:
        element.append(told("title", mark.note))
    return element


def _line(line: Line) -> etree._Element:
    dash = {"stroke_dasharray": " ".join(f"{length:g}" for length in line.dash)} if line.dash else {}
    name = {"data_channel": line.name} if line.name else {}
    look = {"fill": "none", "stroke": line.colour, "stroke_width": f"{line.width:g}", "stroke_linejoin": "round"}
    return svg("path", d="".join(_path(part) for part in line.parts), **look, **dash, **name)


def _text(text: Text) -> etree._Element:
    anchor = {"text_anchor": text.anchor} if text.anchor != "start" else {}
    long = {"textLength": f"{width(text.text, text.size):.0f}", "lengthAdjust": "spacingAndGlyphs"}
    place = {"x": _number(round(text.x * STEPS)), "y": _number(round(text.y * STEPS))}
    element = told("text", text.text)
    for name, value in svg("text", **place, font_size=str(text.size), fill=text.colour, **anchor, **long).items():
        element.set(name, value)
    return element


def _path(points: Sequence[Point]) -> str:
    """Straight lines, each from where the one before it ended: small numbers are short."""
    places = [(round(x * STEPS), round(y * STEPS)) for x, y in points]
    (x, y), parts = places[0], []
    for last, (nx, ny) in pairwise(places):
        if (nx, ny) != last:
            parts.append(f"{_number(nx - last[0])} {_number(ny - last[1])}")
    return f"M{_number(x)} {_number(y)}" + (f"l{' '.join(parts)}" if parts else "").replace(" -", "-")


def _number(tenths: int) -> str:
    """A whole number of tenths as short as it can be written."""
    text = f"{tenths / STEPS:.1f}".removesuffix(".0")
    return re.sub(r"^(-?)0\.", r"\1.", text)


def told(tag: str, text: str) -> etree._Element:
    element = svg(tag)
    element.text = UNFIT.sub("\ufffd", text)
    return element
