"""The ground over time to SVG: a rectangle of changing colour, above it what is no colour, as opaque as it shows."""

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
from facescript.stage.ground import Backdrop, Ground, Photo

Floats = NDArray[np.float64]

SHADE = 0.02
"""The smallest step of opacity worth a number."""

COLOUR_OFF = 1.5
"""How far a colour may be off, of 255."""

KINDS = {b"\x89PNG": "image/png", b"\xff\xd8\xff": "image/jpeg", b"GIF8": "image/gif", b"RIFF": "image/webp"}
"""First bytes of pictures that browsers show, and what they are called."""


class Behind:
    """Follows the grounds of frames in time order; `layers` are those that are no colour, in the order they come."""

    def __init__(self) -> None:
        self.layers: list[Backdrop | Photo] = []
        self.rows: list[tuple[float, Floats, dict[Backdrop | Photo, float]]] = []
        self.colour = np.full(3, 255.0)

    def take(self, time: float, ground: Ground) -> None:
        """The ground of the next moment; what does not differ from the one before is kept once."""
        shares = _shares(ground)
        colours = {layer: share for layer, share in shares.items() if isinstance(layer, str)}
        if total := sum(colours.values()):
            self.colour = sum((_rgb(layer) * share for layer, share in colours.items()), np.zeros(3)) / total
        others = {layer: share for layer, share in shares.items() if not isinstance(layer, str)}
        self.layers += [layer for layer in others if layer not in self.layers]
        self.rows.append((time, self.colour, _covers(others, self.layers, total)))

    def elements(self, size: tuple[int, int], paints: Paints, clock: Clock) -> Iterable[etree._Element]:
        """The rectangle and the layers above it, animated; times count from the first moment."""
        box = {"width": str(size[0]), "height": str(size[1])}
        rectangle = svg("rect", **box)
        animate(rectangle, "fill", self._colours(), clock)
        yield rectangle
        for layer in self.layers:
            if isinstance(layer, Photo):
                element = svg("use", href=f"#{photo_name(layer)}")
            else:
                element = svg("rect", **paints.fill(layer.paint), **box)
            animate(element, "opacity", self._covering(layer), clock)
            yield element

    def _colours(self) -> Track:
        keys = _keys([(time, colour) for time, colour, _ in self.rows], COLOUR_OFF)
        texts = ["#" + "".join(f"{min(max(part, 0), 255):02x}" for part in values) for _, values in keys]
        return Track([time for time, _ in keys], texts)

    def _covering(self, layer: Backdrop | Photo) -> Track:
        rows = [(time, np.array([covers.get(layer, 0.0) / SHADE])) for time, _, covers in self.rows]
        keys = _keys(rows, 1.0)
        texts = [f"{min(max(values[0] * SHADE, 0.0), 1.0):.2f}".rstrip("0").rstrip(".") for _, values in keys]
        return Track([time for time, _ in keys], texts)


def _shares(ground: Ground) -> dict[str | Backdrop | Photo, float]:
    """How much of each layer shows; the sum is 1."""
    shares: dict[str | Backdrop | Photo, float] = {}
    for layer, share in ground:
        shares = {other: old * (1 - share) for other, old in shares.items()}
        shares[layer] = shares.get(layer, 0.0) + share
    return shares


def _covers(
    others: dict[Backdrop | Photo, float], order: list[Backdrop | Photo], below: float
) -> dict[Backdrop | Photo, float]:
    """The opacity of each layer, drawn in `order` over colours that show by `below`, that gives it its share."""
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


def photo_element(photo: Photo, data: bytes, size: tuple[int, int]) -> etree._Element:
    """A picture that fills the film, to be used."""
    kind = next((kind for first, kind in KINDS.items() if data.startswith(first)), "application/octet-stream")
    address = f"data:{kind};base64,{base64.b64encode(data).decode('ascii')}"
    box = {"width": str(size[0]), "height": str(size[1]), "preserveAspectRatio": "xMidYMid slice"}
    return svg("image", id=photo_name(photo), href=address, **box)
