"""Poses of a run's faces to what its pages draw: how far every point has gone from where it rests.

Each frame tells all, so that a page may miss any of them. A point takes two numbers of 16 bits.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.backends.page.figure import outlines
from facescript.backends.page.motion import LEVELS, TURN
from facescript.ir.play import Face, Film
from facescript.live.page.hair import Trail
from facescript.performance.channels import INDEX, POSE
from facescript.performance.performance import REST, Performance
from facescript.schedule.score import Score
from facescript.space.layout import BOX, lay_out
from facescript.stage.ground import PAPER, Backdrop
from facescript.stage.stage import Moments, Stage, StageFrames
from facescript.web.messages import numbers

Floats = NDArray[np.float64]

FURTHEST = 32767
"""Steps of a point from where it rests, at most."""

REACH = 0.75
"""How far that is, in longer sides of the film."""

WHOLE = (1.0, 0.0, 0.0)
"""The view of the whole picture, which is what is drawn: pages look at it through the run's own."""

WAITING = {
    "shut": {"lid.left": 1.0, "lid.right": 1.0},
    "turned": {"head.yaw": 6.0, "head.roll": 1.5, "eye.left.yaw": -6.0, "eye.right.yaw": -6.0},
    "bowed": {"head.pitch": -4.0, "eye.left.pitch": 4.0, "eye.right.pitch": 4.0},
}
"""Poses that a page which hears nothing more mixes into a face that waits: channels that are not at rest."""


@dataclass(frozen=True, slots=True)
class Pose:
    """A frame to be drawn: its `time` (s), how much of the art's own backdrop shows, whether each face is there, and
    the channels of all faces, array[face, channel]."""

    time: float
    own: float
    present: tuple[float, ...]
    channels: Floats


class Picture:
    """What the pages of one run draw of its faces."""

    def __init__(self, film: Film, faces: Sequence[Face]) -> None:
        score = Score(film, tuple(faces), (), (), (), (), (), 0.0)
        self._stage = Stage(score, Performance({}, 0.0), _nothing)
        self._seen = [face for face in faces if face.seen]
        self._trails = [Trail() if face.hair != "still" else None for face in self._seen]
        self._step = REACH * max(film.width, film.height) / FURTHEST
        self._rest = self._still(REST)
        self._box = _box(film, faces)

    def figure(self, about: Mapping[str, object]) -> Iterator[bytes]:
        """What a page is told at first: outlines and where points rest, then a message for each pose of `WAITING`."""
        rest = [part.astype("<f4").tobytes() for part in (self._rest.points[0].T, self._rest.opacity[0])]
        yield numbers("figure", rest, **outlines(self._stage), step=self._step, box=self._box, **about)
        for name, channels in WAITING.items():
            pose = REST.copy()
            pose[[INDEX[channel] for channel in channels]] = list(channels.values())
            yield numbers("waiting", self._packed(self._still(pose)), pose=name)

    def draw(self, poses: Sequence[Pose]) -> list[bytes]:
        """The numbers of frames, in the order of their times: one takes numpy nearly as long as several."""
        channels = np.stack([pose.channels for pose in poses])
        for number, trail in enumerate(self._trails):
            if trail is not None:
                for row, pose in zip(channels[:, number], poses, strict=True):
                    trail.follow(row, pose.time)
        present = np.array([pose.present for pose in poses])
        moments = Moments(
            tuple(channels.transpose(1, 0, 2)),
            tuple(present.T),
            tuple(((Backdrop(PAPER), pose.own),) for pose in poses),
            np.array([WHOLE] * len(poses)),
        )
        return self._packed(self._stage.drawn(moments))

    def _still(self, pose: Floats) -> StageFrames:
        """All faces in one pose."""
        poses = (pose[None],) * len(self._seen)
        present = (np.ones(1),) * len(poses)
        return self._stage.drawn(Moments(poses, present, (((Backdrop(PAPER), 1.0),),), np.array([WHOLE])))

    def _packed(self, drawn: StageFrames) -> list[bytes]:
        """Of each frame the steps from rest, all x, then all y; the shapes' opacities; the shapes' turns."""
        steps = ((drawn.points - self._rest.points[0]) / self._step).clip(-FURTHEST, FURTHEST).transpose(0, 2, 1)
        parts = steps.reshape(len(steps), -1), drawn.opacity * LEVELS, drawn.turns / TURN
        return [row.tobytes() for row in np.rint(np.concatenate(parts, axis=1)).astype("<i2")]


def _box(film: Film, faces: Sequence[Face]) -> tuple[float, float, float, float]:
    """What of the film has faces in it: left, top, right and bottom of their art boxes, film px."""
    standings = lay_out(film, faces).standings.values()
    corners = np.array([each.px(corner) for each in standings for corner in ((0.0, 0.0), (BOX, BOX))])
    if not len(corners):
        return 0.0, 0.0, float(film.width), float(film.height)
    left, top = np.maximum(corners.min(axis=0), 0.0).tolist()
    right, bottom = np.minimum(corners.max(axis=0), (film.width, film.height)).tolist()
    return left, top, right, bottom


def _nothing(path: str) -> bytes:
    """Pictures lie behind the faces, and are told by who knows of them."""
    raise FileNotFoundError(path)


WIDTH = len(POSE)
