"""What lies behind the faces at a time: colours, gradients and pictures, and the way from one to the next."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.ir.acts import SetBackground
from facescript.rig.picture import Linear, Paint, Stop
from facescript.schedule.score import Score
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


Layer = str | Photo | Backdrop
"""A colour `#rrggbb`, a picture, or the art's own."""

Ground = tuple[tuple[Layer, float], ...]
"""Layers, lowest first, each with the share (0..1) by which it covers those before it; the first covers all."""


class Grounds:
    """The backgrounds of a score over time. `own` is the art's backdrop paint."""

    def __init__(self, score: Score, own: Paint) -> None:
        acts = [(act, _layer(act.verb)) for act in score.acts if isinstance(act.verb, SetBackground)]
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


def _layer(background: SetBackground) -> Layer:
    if background.picture is not None:
        return Photo(background.picture)
    return _opaque(background.colour or "#ffffff")


def _opaque(colour: str) -> str:
    """`#rrggbb[aa]` on white as `#rrggbb`."""
    if len(colour) < 9:
        return colour
    alpha = int(colour[7:9], 16) / 255
    mixed = [round(int(colour[at : at + 2], 16) * alpha + WHITE * (1 - alpha)) for at in (1, 3, 5)]
    return "#" + "".join(f"{channel:02x}" for channel in mixed)
