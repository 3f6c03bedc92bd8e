"""Cells to the poses that their face takes: what each asks, blended by the law as in a film."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from facescript.ir.play import Face, Film
from facescript.ir.values import Mix, PicturePlace, Term
from facescript.motion.compose import Asked, compose
from facescript.motion.drivers import ROWS, mix_column
from facescript.motion.gaze.track import GazeTrack
from facescript.performance.channels import MOUTH
from facescript.performance.performance import Frames, Performance
from facescript.rig.picture import Shape
from facescript.schedule.score import Score, TimedScene
from facescript.sheet.cells import Cell
from facescript.stage.actor import BACKDROP
from facescript.stage.stage import Stage

Floats = NDArray[np.float64]

HEAD, CLOSE = (1.2, -1 / 15), (1.9, 0.0)
"""How large the art box is in its cell, and how far above the cell's middle: a whole head, or eyes and mouth."""


@dataclass(frozen=True, slots=True)
class Portraits:
    """One face's cells as geometry: `points` array[cell, point, 2] in px, `opacity` array[cell, shape] 0..1, `turns`
    array[cell, shape] in radians (`rig.picture.Picture`)."""

    shapes: tuple[Shape, ...]
    points: Floats
    opacity: Floats
    turns: Floats


def portraits(face: Face, cells: Sequence[Cell], side: int, close: bool) -> Portraits:
    """The face in the cells, each `side` px wide and high, with nothing behind it; whole, or `close`."""
    size, lift = CLOSE if close else HEAD
    posed = replace(face, place=PicturePlace(0.0, lift), size=size)
    scene = TimedScene("sheet", (face.name,), 0.0, float(len(cells)))
    score = Score(Film(side, side), (posed,), (), (scene,), (), (), (), scene.end)
    performance = Performance({face.name: Posing(poses(score, cells))}, scene.end)
    stage = Stage(score, performance, _no_picture)
    frames = stage.frames(np.arange(len(cells), dtype=np.float64))
    ahead = np.array([shape.group != BACKDROP for shape in stage.shapes])
    return Portraits(stage.shapes, frames.points, frames.opacity * ahead, frames.turns)


def poses(score: Score, cells: Sequence[Cell]) -> Frames:
    """array[cell, channel] of the score's one face."""
    count, still = len(cells), np.zeros((len(ROWS), len(cells)))
    rest = np.zeros(count)
    gaze = GazeTrack(score, score.faces[0])
    turns = np.array([cell.turn for cell in cells], dtype=np.float64)
    sight, head = gaze.sight(rest), gaze.head(rest)
    sight[:, :2] += turns + np.array([cell.gaze for cell in cells])
    shown = np.stack([mix_column(Mix((Term(cell.label, 1.0, cell.drivers),))) for cell in cells], axis=1)
    spoken = np.array([cell.spoken or (0.0,) * len(MOUTH) for cell in cells])
    speaks = np.array([float(cell.spoken is not None) for cell in cells])
    return compose(Asked(shown, still, still, sight, head + turns, spoken, speaks))


class Posing:
    """Poses held for a second each, one after another (`performance.FaceCurves`)."""

    def __init__(self, poses: Frames) -> None:
        self._poses = poses

    def sample(self, times: Floats) -> Frames:
        """Poses at `times` (seconds, any order): array[len(times), channel]."""
        held: Frames = self._poses[np.clip(times.astype(np.intp), 0, len(self._poses) - 1)]
        return held


def _no_picture(path: str) -> bytes:
    raise AssertionError(f"a sheet has no background, but asks for {path}")
