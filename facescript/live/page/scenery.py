"""Frames of a run to what is around its faces, as pages are told of it: the ground, the view, and who is there."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from facescript.backends.page.figure import layer_of
from facescript.live.model import Frame, Layout
from facescript.live.page.picture import Pose
from facescript.performance.channels import INDEX
from facescript.performance.performance import REST, Performance
from facescript.schedule.score import Score
from facescript.stage.ground import Ground, Layer, own_share
from facescript.stage.stage import Stage
from facescript.web.messages import text

SUDDEN = 0.2
"""A view whose scale changes by more from one frame to the next is cut to: nothing leads over."""


@dataclass(frozen=True, slots=True)
class Scene:
    """A frame apart from its faces' points: `head` is what pages are told of it, `layers` messages that they have to
    know before, and `pose` what is to be drawn."""

    head: dict[str, object]
    layers: list[bytes]
    pose: Pose


class Scenery:
    """What is around the faces of a run; `told` are the messages of all layers so far."""

    def __init__(self, score: Score, layout: Layout, pictures: Callable[[str], bytes]) -> None:
        self._stage = Stage(score, Performance({}, 0.0), pictures)
        self._layout, self._columns = layout, [_columns(layout, face) for face in layout.faces]
        self._score, self._setting = score, self._stage.setting(score)
        self._layers: dict[Layer, int] = {}
        self.told: list[bytes] = []
        self._seen: tuple[float, tuple[float, ...]] = (0.0, ())
        self._cuts = 0

    def scene(self, frame: Frame, score: Score) -> Scene:
        """A frame of the run whose score is that now."""
        if score is not self._score:
            self._score, self._setting = score, self._stage.setting(score)
        around = self._setting.at(np.array([frame.time]))
        scale, left, top = around.views[0].tolist()
        present, ground = tuple(float(there[0]) for there in around.present), around.grounds[0]
        self._cuts += abs(scale - self._seen[0]) > SUDDEN * self._seen[0] or present != self._seen[1]
        self._seen = scale, present
        layers = list(self._new(ground))
        self.told += layers
        behind = [[self._layers[layer], round(share, 4)] for layer, share in ground]
        view = [round(scale, 5), round(left, 3), round(top, 3)]
        head = {"number": frame.number, "time": frame.time, "cuts": self._cuts, "view": view, "ground": behind}
        return Scene(head, layers, self._pose(frame, own_share(ground), present))

    def _pose(self, frame: Frame, own: float, present: tuple[float, ...]) -> Pose:
        channels = np.repeat(REST[None], len(self._columns), axis=0)
        for row, (here, there) in zip(channels, self._columns, strict=True):
            row[there] = frame.values[here]
        return Pose(frame.time, own, present, channels)

    def _new(self, ground: Ground) -> Iterator[bytes]:
        """Messages of layers that pages do not know yet."""
        for layer, _ in ground:
            if layer not in self._layers:
                self._layers[layer] = len(self._layers)
                yield text("layer", layer=layer_of(layer, self._stage.pictures))


def _columns(layout: Layout, face: str) -> tuple[list[int], list[int]]:
    """The columns of a face in a run's frames, and those of the same channels in a pose."""
    prefix = f"{face}." if len(layout.faces) > 1 else ""
    here = [place for place, name in enumerate(layout.names) if name.startswith(prefix)]
    return here, [INDEX[layout.names[place].removeprefix(prefix)] for place in here]
