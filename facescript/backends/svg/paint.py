"""Paints to SVG: colours as they are, gradients as elements that shapes share."""

from __future__ import annotations

from lxml import etree

from facescript.backends.svg.track import svg
from facescript.rig.picture import Linear, Paint, Radial


class Paints:
    """The gradients of a picture, each written once."""

    def __init__(self) -> None:
        self.names: dict[Linear | Radial, str] = {}

    def fill(self, paint: Paint) -> str:
        """What stands in a shape's `fill`."""
        if isinstance(paint, str):
            return paint
        return f"url(#{self.names.setdefault(paint, f'paint-{len(self.names) + 1}')})"

    def elements(self) -> list[etree._Element]:
        """The gradient elements, in the order of first use."""
        return [_gradient(paint, name) for paint, name in self.names.items()]


def _gradient(paint: Linear | Radial, name: str) -> etree._Element:
    if isinstance(paint, Linear):
        (x1, y1), (x2, y2) = paint.start, paint.end
        element = svg("linearGradient", id=name, x1=_n(x1), y1=_n(y1), x2=_n(x2), y2=_n(y2))
    else:
        (cx, cy), radius = paint.centre, paint.radius
        element = svg("radialGradient", id=name, cx=_n(cx), cy=_n(cy), r=_n(radius))
    for stop in paint.stops:
        opacity = {"stop_opacity": _n(stop.opacity)} if stop.opacity < 1 else {}
        element.append(svg("stop", offset=_n(stop.offset), stop_color=stop.colour, **opacity))
    return element


def _n(value: float) -> str:
    return f"{value:.4f}".rstrip("0").rstrip(".") or "0"
