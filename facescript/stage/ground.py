"""What lies behind the faces at a time: colours, gradients, pictures or nothing, and the way from one to the next."""

from __future__ import annotations

import math
from dataclasses import dataclass

from facescript.ir.acts import Gradient, SetBackground
from facescript.rig.picture import Linear, Paint, Radial, Stop
from facescript.schedule.score import Score, TimedAct
from facescript.stage.timeline import Timeline

PAPER = Linear((Stop(0.0, "#f4f2ee"), Stop(1.0, "#e4ddd2")))
"""Behind faces whose art brings no backdrop."""

WHITE = 255
"""What a translucent background colour lies on."""


@dataclass(frozen=True, slots=True)
class Photo:
    """A picture file of the project, scaled to fill the film and cut where it is too long."""

    path: str


@dataclass(frozen=True, slots=True)
class Backdrop:
    """The art's own: a paint that fills the film; the rest of the art's backdrop is drawn with the faces."""

    paint: Paint


@dataclass(frozen=True, slots=True)
class Clear:
    """Nothing: what lies under the picture shows."""


Layer = Paint | Photo | Backdrop | Clear
"""A colour `#rrggbb` or a gradient over the whole film, a picture, the art's own, or nothing."""

Ground = tuple[tuple[Layer, float], ...]
"""Layers, lowest first, each with the share (0..1) by which it replaces those before it; the first covers all."""

CORNERS = math.sqrt(0.5)
"""The radius at which a gradient around the middle reaches the film's corners, in fractions of its sides."""


class Grounds:
    """The backgrounds of a score over time. `own` is the art's backdrop paint; `clear` is the first act that lets
    what lies under the picture show, None where the picture is opaque throughout."""

    def __init__(self, score: Score, own: Paint) -> None:
        size = score.film.width, score.film.height
        acts = [(act, _layer(act.verb, size)) for act in score.acts if isinstance(act.verb, SetBackground)]
        self.clear: TimedAct | None = next((act for act, layer in acts if isinstance(layer, Clear)), None)
        first: Layer = Backdrop(own)
        self._timeline = Timeline(score, first, acts)

    def at(self, time: float) -> Ground:
        return self._timeline.layers(time)


def own_share(ground: Ground) -> float:
    """How much of the art's own backdrop shows, 0..1."""
    shown = 0.0
    for layer, share in ground:
        shown = shown * (1.0 - share) + (share if isinstance(layer, Backdrop) else 0.0)
    return shown


def _layer(background: SetBackground, size: tuple[int, int]) -> Layer:
    if background.picture is not None:
        return Photo(background.picture)
    if background.gradient is not None:
        return _paint(background.gradient, size)
    return Clear() if background.colour is None else _opaque(background.colour)


def _paint(gradient: Gradient, size: tuple[int, int]) -> Paint:
    """A gradient as the paint of a rectangle of `size` px; across the film it runs at its angle in pixels."""
    last = len(gradient.colours) - 1
    stops = tuple(Stop(number / last, _opaque(colour)) for number, colour in enumerate(gradient.colours))
    if gradient.towards is None:
        return Radial(stops, radius=CORNERS)
    angle = math.radians(gradient.towards)
    # Paints count in fractions of the rectangle: there the lines of one colour stand square on (x, y).
    x, y = size[0] * math.cos(angle), -size[1] * math.sin(angle)
    reach = (abs(x) + abs(y)) / (2 * (x * x + y * y))
    x, y = x * reach, y * reach
    return Linear(stops, (0.5 - x, 0.5 - y), (0.5 + x, 0.5 + y))


def _opaque(colour: str) -> str:
    """`#rrggbb[aa]` on white as `#rrggbb`."""
    if len(colour) < 9:
        return colour
    alpha = int(colour[7:9], 16) / 255
    mixed = [round(int(colour[at : at + 2], 16) * alpha + WHITE * (1 - alpha)) for at in (1, 3, 5)]
    return "#" + "".join(f"{channel:02x}" for channel in mixed)
