"""A score and its performance to the shapes of the whole picture, and their points, opacities and ground over time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.canvas.overlay import Stickers
from facescript.performance.performance import Performance
from facescript.rig.picture import Shape
from facescript.schedule.score import Score, TimedAct
from facescript.space.layout import lay_out
from facescript.stage.actor import BACKDROP, Actor, moved
from facescript.stage.ground import PAPER, Ground, own_share
from facescript.stage.setting import Setting

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class StageFrames:
    """Frames of the film: `points` array[frame, point, 2] in film px (y down), `opacity` array[frame, shape] 0..1,
    `turns` array[frame, shape] in radians (`rig.picture.Picture`), and the ground behind them, one a frame. `views`,
    array[frame, (scale, left, top)], is how the camera has set the points: px of the whole picture times scale plus
    (left, top)."""

    points: Floats
    opacity: Floats
    turns: Floats
    grounds: tuple[Ground, ...]
    views: Floats


@dataclass(frozen=True, slots=True)
class Moments:
    """What frames are drawn from: each face's poses array[frame, channel] and whether it is there (array[frame], 0 or
    1), the ground behind each frame, and `views` as in `StageFrames`. Equal moments look the same."""

    poses: tuple[Floats, ...]
    present: tuple[Floats, ...]
    grounds: tuple[Ground, ...]
    views: Floats


class Stage:
    """The whole picture of a film, a pure function of time.

    `shapes` are in drawing order: the backdrops of all faces, then face by face. With several faces their ids carry
    the face's name (`ada-mouth`); `owners` are the shapes' faces. `pictures` reads a background picture by its path.
    `clear` is the first act that makes the ground transparent, None where none does; `over` is what is laid over the
    picture, None for nothing.
    """

    def __init__(
        self,
        score: Score,
        performance: Performance,
        pictures: Callable[[str], bytes],
        over: Stickers | None = None,
    ) -> None:
        self.over = over
        self.width, self.height = score.film.width, score.film.height
        self.pictures = pictures
        self._performance = performance
        self._layout = lay_out(score.film, score.faces)
        seen = [face for face in score.faces if face.seen]
        self._actors = [Actor(face, self._layout.standings[face.name], score.film) for face in seen]
        self._firsts = np.cumsum([0, *(actor.count for actor in self._actors)]).tolist()
        self._setting = self.setting(score)
        self._place()
        self.clear: TimedAct | None = self._setting.grounds.clear

    def frames(self, times: Floats) -> StageFrames:
        """The picture at `times` (seconds from the film's start, any order)."""
        return self.drawn(self.moments(times))

    def moments(self, times: Floats) -> Moments:
        """What is drawn at `times` (seconds from the film's start, any order)."""
        around = self._setting.at(times)
        poses = tuple(self._performance.sample_face(actor.name, times) for actor in self._actors)
        return Moments(poses, around.present, around.grounds, around.views)

    def setting(self, score: Score) -> Setting:
        """What is around these faces in a score of the same film."""
        paints = [actor.ground for actor in self._actors if actor.ground is not None]
        return Setting(score, self._layout, paints[0] if paints else PAPER, [actor.name for actor in self._actors])

    def drawn(self, moments: Moments) -> StageFrames:
        """The picture of moments."""
        count, grounds, views = len(moments.grounds), moments.grounds, moments.views
        points = np.zeros((count, self._firsts[-1], 2))
        opacity, turns = (np.zeros((count, len(self._order))) for _ in range(2))
        at = 0
        for number, actor in enumerate(self._actors):
            drawn = actor.draw(moments.poses[number])
            mine = slice(at, at + len(actor.shapes))
            points[:, self._firsts[number] : self._firsts[number + 1]] = drawn.points
            opacity[:, mine] = drawn.opacity * moments.present[number][:, None]
            turns[:, mine] = drawn.turns
            at = mine.stop
        opacity = opacity[:, self._order]
        opacity[:, : self._backdrops] *= np.array([own_share(ground) for ground in grounds])[:, None]
        return StageFrames(self._looked_at(points, views), opacity, turns[:, self._order], grounds, views)

    def _place(self) -> None:
        """Join the shapes of all faces, backdrops first."""
        several = len(self._actors) > 1
        joined: list[Shape] = []
        owners: list[str] = []
        for actor, first in zip(self._actors, self._firsts, strict=False):
            joined += moved(actor.shapes, first, f"{actor.name}-" if several else "", self._setting.camera.moves)
            owners += [actor.name] * len(actor.shapes)
        self._order = sorted(range(len(joined)), key=lambda place: joined[place].group != BACKDROP)
        self.shapes: tuple[Shape, ...] = tuple(joined[place] for place in self._order)
        self.owners: tuple[str, ...] = tuple(owners[place] for place in self._order)
        self._backdrops = sum(shape.group == BACKDROP for shape in joined)

    def _looked_at(self, points: Floats, views: Floats) -> Floats:
        """Picture px to film px: the camera's affine of each moment."""
        if not self._setting.camera.moves:
            return points
        seen: Floats = points * views[:, None, :1] + views[:, None, 1:]
        return seen
