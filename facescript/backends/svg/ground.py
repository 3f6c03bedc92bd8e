"""The ground over time to SVG: a rectangle of changing colour, above it what is no colour, as opaque as it shows.

A ground that is nothing has no element: where it shows, the rectangle lets the page through.
"""

from __future__ import annotations

import base64
from collections.abc import Iterable
from hashlib import sha256

import numpy as np
from lxml import etree
from numpy.typing import NDArray

from facescript.backends.svg.keys import Swing
from facescript.backends.svg.paint import Paints
from facescript.backends.svg.track import Clock, Track, animate, svg
from facescript.rig.picture import Linear, Radial
from facescript.stage.ground import Backdrop, Clear, Ground, Layer, Photo

Floats = NDArray[np.float64]

SHADE = 0.02
"""The smallest step of a shape's opacity worth a number."""

VEIL = 0.004
"""The same of a ground: it fills the film, so that a little of it would be seen."""

COLOUR_OFF = 1.5
"""How far a colour may be off, of 255."""

KINDS = {
    b"\x89PNG": "image/png",
    b"\xff\xd8\xff": "image/jpeg",
    b"GIF8": "image/gif",
    b"RIFF": "image/webp",
    b"BM": "image/bmp",
}
"""First bytes of pictures that browsers show, and what they are called."""


Above = Linear | Radial | Photo | Backdrop
"""What is neither a colour nor nothing, and has an element of its own."""


class Behind:
    """Follows the grounds of frames in time order; `layers` are those that are no colour, in the order they come.

    `colour` is the rectangle's as of the last moment, `solid` its opacity, and both stay while other layers hide it.
    """

    def __init__(self) -> None:
        self.layers: list[Above] = []
        self.rows: list[tuple[float, Floats, dict[Above, float]]] = []
        self.colour = np.full(3, 255.0)
        self.solid = 0.0
        self.solids: list[tuple[float, Floats]] = []

    def take(self, time: float, ground: Ground) -> None:
        """The ground of the next moment; what does not differ from the one before is kept once."""
        shares = _shares(ground)
        colours = {layer: share for layer, share in shares.items() if isinstance(layer, str)}
        if total := sum(colours.values()):
            self.colour = sum((_rgb(layer) * share for layer, share in colours.items()), np.zeros(3)) / total
        if low := total + shares.get(Clear(), 0.0):
            self.solid = total / low
        others = {layer: share for layer, share in shares.items() if not isinstance(layer, str | Clear)}
        self.layers += [layer for layer in others if layer not in self.layers]
        self.rows.append((time, self.colour, _covers(others, self.layers, low)))
        self.solids.append((time, np.array([self.solid / VEIL])))

    def elements(self, size: tuple[int, int], paints: Paints, clock: Clock) -> Iterable[etree._Element]:
        """The rectangle and the layers above it, animated; times count from the first moment."""
        box = {"width": str(size[0]), "height": str(size[1])}
        solid = _opacity(self.solids)
        if not solid.still or solid.values[0] != "0":
            rectangle = svg("rect", **box)
            animate(rectangle, "fill", self._colours(), clock)
            if not solid.still or solid.values[0] != "1":
                animate(rectangle, "opacity", solid, clock)
            yield rectangle
        for layer in self.layers:
            if isinstance(layer, Photo):
                element = svg("use", href=f"#{photo_name(layer)}")
            else:
                element = svg("rect", **paints.fill(layer.paint if isinstance(layer, Backdrop) else layer), **box)
            animate(element, "opacity", self._covering(layer), clock)
            yield element

    def _colours(self) -> Track:
        keys = _keys([(time, colour) for time, colour, _ in self.rows], COLOUR_OFF)
        texts = ["#" + "".join(f"{min(max(part, 0), 255):02x}" for part in values) for _, values in keys]
        return Track([time for time, _ in keys], texts)

    def _covering(self, layer: Above) -> Track:
        return _opacity([(time, np.array([covers.get(layer, 0.0) / VEIL])) for time, _, covers in self.rows])


def _opacity(rows: list[tuple[float, Floats]]) -> Track:
    keys = _keys(rows, 1.0)
    texts = [f"{min(max(values[0] * VEIL, 0.0), 1.0):.3f}".rstrip("0").rstrip(".") for _, values in keys]
    return Track([time for time, _ in keys], texts)


def _shares(ground: Ground) -> dict[Layer, float]:
    """How much of each layer shows; the sum is 1."""
    shares: dict[Layer, float] = {}
    for layer, share in ground:
        shares = {other: old * (1 - share) for other, old in shares.items()}
        shares[layer] = shares.get(layer, 0.0) + share
    return shares


def _covers(others: dict[Above, float], order: list[Above], below: float) -> dict[Above, float]:
    """The opacity of each layer, drawn in `order` over what shows by `below`, that gives it its share."""
    covers = {}
    for layer in order:
        share = others.get(layer, 0.0)
        below += share
        covers[layer] = share / below if below > 0 else 0.0
    return covers


def _keys(rows: list[tuple[float, Floats]], off: float) -> list[tuple[float, NDArray[np.int64]]]:
    swing = Swing(np.array([0]), len(rows[0][1]), off)
    swing.begin(*rows[0])
    for row in rows[1:]:
        swing.push(*row)
    swing.finish()
    return swing.keys[0]


def _rgb(colour: str) -> Floats:
    return np.array([int(colour[at : at + 2], 16) for at in (1, 3, 5)], dtype=np.float64)


def photo_name(photo: Photo) -> str:
    """The id of a picture, the same whatever else there is."""
    return f"photo-{sha256(photo.path.encode()).hexdigest()[:8]}"


def picture_kind(data: bytes) -> str:
    """What a picture's bytes are, as browsers call it."""
    return next((kind for first, kind in KINDS.items() if data.startswith(first)), "application/octet-stream")


def photo_address(data: bytes) -> str:
    """A picture's bytes as an address that holds them."""
    return f"data:{picture_kind(data)};base64,{base64.b64encode(data).decode('ascii')}"


def photo_element(photo: Photo, data: bytes, size: tuple[int, int]) -> etree._Element:
    """A picture that fills the film, to be used; what is clear in it is white."""
    box = {"width": str(size[0]), "height": str(size[1])}
    group = svg("g", id=photo_name(photo))
    group.append(svg("rect", fill="#ffffff", **box))
    group.append(svg("image", href=photo_address(data), preserveAspectRatio="xMidYMid slice", **box))
    return group
