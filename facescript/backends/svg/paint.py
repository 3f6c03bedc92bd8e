"""Paints to SVG: colours that style sheets can change by their names, gradients as elements that shapes share."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from lxml import etree

from facescript.backends.svg.track import svg
from facescript.rig.picture import Linear, Paint, Radial, Shape, Tone

Key = tuple[object, ...]

RULES = "@supports (fill:color-mix(in srgb,var(--a),red)){%s}"
"""Programs that know no variables pass this over and see the plain colours of the attributes."""


class Paints:
    """The paints of one group of shapes: each gradient is written once and named after the first shape that has it.

    Elements with a tone of the palette carry a class of its name, for which `rules` has the variable.
    """

    def __init__(self, owner: str, shapes: Iterable[Shape]) -> None:
        self.owner = owner
        self.names: dict[Key, str] = {}
        for shape in shapes:
            if not isinstance(shape.fill, str):
                self.names.setdefault(_key(shape.fill), f"{shape.id}-paint")
        self.used: dict[str, Linear | Radial] = {}
        self.tones: dict[tuple[str, str], Tone] = {}

    def fill(self, paint: Paint) -> dict[str, str]:
        """The attributes that fill a shape."""
        if isinstance(paint, str):
            return self._colour("fill", paint)
        name = self.names[_key(paint)]
        self.used[name] = paint
        return {"fill": f"url(#{name})"}

    def elements(self) -> Iterator[etree._Element]:
        """The gradients used, in the order of first use."""
        for name, paint in self.used.items():
            element = _gradient(paint, name)
            for stop in paint.stops:
                opacity = {"stop_opacity": _n(stop.opacity)} if stop.opacity < 1 else {}
                element.append(
                    svg("stop", offset=_n(stop.offset), **self._colour("stop_color", stop.colour), **opacity)
                )
            yield element

    def rules(self) -> list[str]:
        """The style sheet's rules for what `fill` and `elements` gave."""
        return [
            f".{self._class(what, tone)}{{{what.replace('_', '-')}:{_variable(tone)}}}"
            for (what, _), tone in self.tones.items()
        ]

    def _colour(self, what: str, colour: str) -> dict[str, str]:
        if not isinstance(colour, Tone):
            return {what: colour}
        self.tones.setdefault((what, colour.name), colour)
        return {what: str(colour), "class_": self._class(what, colour)}

    def _class(self, what: str, tone: Tone) -> str:
        """One a face, as faces have the same tones in other colours, and one a property."""
        return "-".join(filter(None, (self.owner, what.removesuffix("_color"), tone.name.replace(".", "-"))))


def _variable(colour: str) -> str:
    """A colour as CSS: the variable of its name, or the mixture of variables."""
    if not isinstance(colour, Tone):
        return colour
    if colour.mixture is None:
        return f"var(--{colour.name.replace('.', '-')},{colour})"
    one, other, share = colour.mixture
    return f"color-mix(in srgb,{_variable(one)},{_variable(other)} {_n(100 * share)}%)"


def _key(paint: Linear | Radial) -> Key:
    """What tells gradients apart: tones of one colour and two names are two."""
    return (paint, *(getattr(stop.colour, "name", "") for stop in paint.stops))


def _gradient(paint: Linear | Radial, name: str) -> etree._Element:
    if isinstance(paint, Linear):
        (x1, y1), (x2, y2) = paint.start, paint.end
        return svg("linearGradient", id=name, x1=_n(x1), y1=_n(y1), x2=_n(x2), y2=_n(y2))
    (cx, cy), radius = paint.centre, paint.radius
    return svg("radialGradient", id=name, cx=_n(cx), cy=_n(cy), r=_n(radius))


def _n(value: float) -> str:
    return f"{value:.4f}".rstrip("0").rstrip(".") or "0"
