"""The camera: which part of the picture fills the film at a time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from facescript.ir.acts import View
from facescript.schedule.score import Score, TimedAct
from facescript.space.layout import BOX, EYES, Layout
from facescript.stage.timeline import Timeline

CLOSE = 1.6
"""From this zoom on a face is centred on the middle of its head, at 100 % on the middle of its art box."""

HEAD = (EYES[0], EYES[1] - 18.0)
"""The middle of a head with its hair, in the art box."""


@dataclass(frozen=True, slots=True)
class Sight:
    """The picture's point in the film's centre (px), and how much of the film's width of the picture shows (1: all)."""

    x: float
    y: float
    reach: float

    def towards(self, other: Sight, share: float) -> Sight:
        """Part of the way to another sight."""
        rest = 1.0 - share
        return Sight(
            self.x * rest + other.x * share, self.y * rest + other.y * share, self.reach * rest + other.reach * share
        )


class Camera:
    """The views of a score over time."""

    def __init__(self, score: Score, layout: Layout) -> None:
        self._width, self._height = score.film.width, score.film.height
        acts = [(act, act.verb) for act in score.acts if isinstance(act.verb, View)]
        self.moves = bool(acts)
        self._timeline = Timeline(score, self._all(1.0), list(self._sights(acts, layout)))

    def at(self, time: float) -> tuple[float, float, float]:
        """Scale, left and top at a time: picture px times scale plus (left, top) are film px.

        Smooth while a view changes, also where one view interrupts another.
        """
        layers = self._timeline.layers(time)
        sight = layers[0][0]
        for other, share in layers[1:]:
            sight = sight.towards(other, share)
        scale = 1.0 / sight.reach
        return (scale, self._width / 2 - sight.x * scale, self._height / 2 - sight.y * scale)

    def _all(self, zoom: float) -> Sight:
        return Sight(self._width / 2, self._height / 2, 1.0 / zoom)

    def _sights(self, acts: Iterable[tuple[TimedAct, View]], layout: Layout) -> Iterable[tuple[TimedAct, Sight]]:
        for act, view in acts:
            zoom = max(float(view.zoom), 0.01) if isinstance(view.zoom, int | float) else 1.0
            standing = layout.standings.get(view.face) if view.face else None
            if standing is None:
                yield act, self._all(zoom)
                continue
            close = min(1.0, max(0.0, (zoom - 1.0) / (CLOSE - 1.0)))
            middle = BOX / 2 + (HEAD[1] - BOX / 2) * close
            yield act, Sight(*standing.px((HEAD[0], middle)), 1.0 / zoom)
