"""A score to what is around its faces at a time: who is in the scene, what lies behind, where the camera looks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.rig.picture import Paint
from facescript.schedule.score import Score
from facescript.space.layout import Layout
from facescript.stage.ground import Ground, Grounds
from facescript.stage.view import Camera

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Around:
    """What is around the faces at moments: `present`, whether each face is there (array[frame], 0 or 1), the ground
    behind each frame, and `views`, array[frame, (scale, left, top)] (`stage.StageFrames`)."""

    present: tuple[Floats, ...]
    grounds: tuple[Ground, ...]
    views: Floats


class Setting:
    """What is around the `seen` faces of a score over time; `own` is the art's backdrop paint."""

    def __init__(self, score: Score, layout: Layout, own: Paint, seen: Sequence[str]) -> None:
        self.camera = Camera(score, layout)
        self.grounds = Grounds(score, own)
        self._starts = np.array([scene.start for scene in score.scenes])
        self._there = [np.array([float(face in scene.faces) for scene in score.scenes]) for face in seen]

    def at(self, times: Floats) -> Around:
        """What is around at `times`, seconds in any order; a scene's end belongs to the next."""
        scenes = np.maximum(0, np.searchsorted(self._starts, times, side="right") - 1)
        return Around(
            tuple(there[scenes] for there in self._there),
            tuple(self.grounds.at(time) for time in times.tolist()),
            np.array([self.camera.at(time) for time in times.tolist()]).reshape(-1, 3),
        )
