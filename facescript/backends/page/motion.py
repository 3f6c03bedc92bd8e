"""A stage over time to what a page's player adds up: ways of moving, their weights in each frame, and what lies behind.

Frames come in parts of a minute, each unpacked when the page comes to it; memory holds a piece of one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.backends.page.basis import Basis
from facescript.backends.page.packing import packed
from facescript.ir.acts import View
from facescript.rig.picture import Shape
from facescript.stage.ground import Ground
from facescript.stage.stage import Stage, StageFrames

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

RATE = 60.0
"""Frames a second, whatever a film's are: a page draws the straight way from one to the next at any moment, which in
the quickest blinks and looks is 3 px off at worst (6 px at 30 a second)."""

PART = 60.0
"""Seconds of a part."""

PIECE = 400_000
"""Coordinates drawn at once."""

SAMPLE = 240
"""Moments from all over the film that the ways of moving are first found in, at most."""

LEVELS = 255
"""Steps of opacity."""

TURN = 1 / 1024
"""Radians: the step of a turn."""

VIEW = np.array([1 / 65536, 1 / 16, 1 / 16])
"""The steps of a view's scale, left and top."""


@dataclass(frozen=True, slots=True)
class Part:
    """Consecutive frames, the last of which is the next part's first: how many ways of moving each face has in it, and
    rows packed: the weights face by face, then `rest`."""

    ways: tuple[int, ...]
    rows: str


@dataclass(frozen=True, slots=True)
class Motion:
    """All frames, `RATE` a second. `firsts` are the first points of the faces; `cuts` the frames that nothing leads
    over to; `grounds` the ground from a frame on, wherever another begins."""

    frames: int
    part_frames: int
    firsts: tuple[int, ...]
    bases: tuple[Basis, ...]
    parts: tuple[Part, ...]
    cuts: tuple[int, ...]
    grounds: tuple[tuple[int, Ground], ...]


class Gathering:
    """Frames to the weights of ways of moving, which are found as they are asked for."""

    def __init__(self, stage: Stage, sample: StageFrames) -> None:
        self._shapes = stage.shapes
        self._bounds = _bounds(stage.shapes)
        self.faces = _faces(stage)
        points, seen = self._seen(sample)
        self.bases = tuple(Basis(points[:, face], seen[:, face]) for face in self.faces)

    def take(self, frames: StageFrames) -> tuple[list[Ints], Ints]:
        """A piece: the faces' weights array[frame, way], and the rest array[frame, row]: opacities and turns shape by
        shape, and the view."""
        points, seen = self._seen(frames)
        weights = [
            basis.weights(points[:, face], seen[:, face]) for basis, face in zip(self.bases, self.faces, strict=True)
        ]
        graded = np.array([not isinstance(shape.fill, str) for shape in self._shapes], dtype=bool)
        rest = (frames.opacity * LEVELS, frames.turns * graded / TURN, frames.views / VIEW)
        return weights, np.rint(np.concatenate(rest, axis=1)).astype(np.int64)

    def _seen(self, frames: StageFrames) -> tuple[Floats, Floats]:
        """The points where no camera has moved them, and by how much each is enlarged, 0 where it cannot be seen."""
        scale, place = frames.views[:, None, :1], frames.views[:, None, 1:]
        seen = np.zeros(frames.points.shape[:2])
        for number, shape in enumerate(self._shapes):
            shown = (frames.opacity[:, number, None] > 0) | self._bounds[number]
            for each in shape.contours:
                seen[:, each.first : each.first + each.count] = shown
        return (frames.points - place) / scale, seen * scale[..., 0]


def motion(job: Job) -> Motion:
    """The frames of a job's stretch, up to its end."""
    count = max(2, _frame(job.end - job.start) + 1)
    moments = np.minimum(job.start + np.arange(count) / RATE, job.end)
    sample = job.stage.frames(moments[np.unique(np.linspace(0, count - 1, SAMPLE).astype(np.intp))])
    gathering = Gathering(job.stage, sample)
    length = round(PART * RATE)
    parts, grounds = [], list[tuple[int, Ground]]()
    for first in range(0, count - 1, length):
        parts.append(_part(job.stage, gathering, grounds, first, moments[first : first + length + 1]))
        job.progress(min(first + length, count - 1), count - 1)
    firsts = tuple(face.start for face in gathering.faces)
    return Motion(count, length, firsts, gathering.bases, tuple(parts), cuts(job), tuple(grounds))


def _part(stage: Stage, gathering: Gathering, grounds: list[tuple[int, Ground]], first: int, moments: Floats) -> Part:
    pieces = []
    step = max(8, PIECE // max(1, gathering.faces[-1].stop if gathering.faces else 1))
    for at in range(0, len(moments), step):
        frames = stage.frames(moments[at : at + step])
        add_grounds(grounds, first + at, frames.grounds)
        pieces.append(gathering.take(frames))
    ways = tuple(len(basis) for basis in gathering.bases)
    weights = [_joined([piece[0][face] for piece in pieces], count) for face, count in enumerate(ways)]
    rest = np.concatenate([piece[1] for piece in pieces])
    return Part(ways, packed(np.concatenate([*weights, rest], axis=1).T))


def add_grounds(found: list[tuple[int, Ground]], first: int, grounds: Sequence[Ground]) -> None:
    """Adds what lies behind the frames from `first` on, wherever it is another than before."""
    for number, ground in enumerate(grounds, first):
        if not found or found[-1][1] != ground:
            found.append((number, ground))


def _joined(pieces: Sequence[Ints], ways: int) -> Ints:
    """Pieces of weights below each other; those from before a way was found do without it."""
    return np.concatenate([np.pad(piece, ((0, 0), (0, ways - piece.shape[1]))) for piece in pieces])


def _faces(stage: Stage) -> tuple[slice, ...]:
    """The points of each face, in their order."""
    ends: dict[str, int] = {}
    for shape, owner in zip(stage.shapes, stage.owners, strict=True):
        ends[owner] = max(ends.get(owner, 0), *(each.first + each.count for each in shape.contours))
    stops = sorted(ends.values())
    return tuple(slice(first, stop) for first, stop in zip([0, *stops], stops, strict=False))


def _bounds(shapes: Sequence[Shape]) -> list[bool]:
    """Which shapes clip others: they matter where they are not drawn, too."""
    names = {name for shape in shapes for name in shape.clip}
    return [shape.id in names for shape in shapes]


def cuts(job: Job) -> tuple[int, ...]:
    """The frames at which a scene begins or a view is another at once."""
    views = (act for act in job.score.acts if isinstance(act.verb, View) and act.settled - act.start < 1 / RATE)
    times = [*(scene.start for scene in job.score.scenes), *(act.start for act in views)]
    return tuple(sorted({_frame(time - job.start) for time in times if job.start < time < job.end}))


def _frame(time: float) -> int:
    """The first frame at or after a time."""
    return int(np.ceil(time * RATE - 1e-9))
