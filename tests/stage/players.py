"""A score made by hand and a face of few shapes, for tests of the stage."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from facescript.ir.acts import Gradient, Life, SetBackground, Verb, View, Voice
from facescript.ir.play import Face, Film
from facescript.ir.values import PicturePlace
from facescript.performance.channels import INDEX
from facescript.performance.performance import REST, Frames, Performance
from facescript.rig.picture import Contour, Linear, Picture, Shape, Stop
from facescript.schedule.score import FOREVER, Score, TimedAct, TimedScene
from facescript.space.layout import BOX, EYES
from facescript.text import Source, Span

NOWHERE = Span(Source("test.face", ""), 0, 0)
FILM = Film(1280, 720)
WALL = Linear((Stop(0.0, "#ffeedd"), Stop(1.0, "#ddccbb")))


def block(left: float, top: float, right: float, bottom: float) -> np.ndarray:
    """A rectangle as four straight cubics."""
    corners = np.array([(left, top), (right, top), (right, bottom), (left, bottom), (left, top)], dtype=float)
    return np.repeat(corners, 3, axis=0)[1:-1]


def scenery(face: Face) -> tuple[tuple[Shape, ...], Picture]:
    """A wall that fills the art box, and a disc on it."""
    wall = Shape("wall", "background", (Contour(0, 13),), WALL, moving=False)
    disc = Shape("disc", "background", (Contour(13, 13),), "#cc9966", moving=False)
    points = np.concatenate([block(0, 0, 720, 720), block(60, 60, 660, 660)])
    return (wall, disc), Picture(points[None], np.ones((1, 2)), np.zeros((1, 2)))


class BlockRig:
    """Rectangles: a body cut off by the box, a head that turns, a mouth inside the head."""

    box, eyes, eye_distance = (BOX, BOX), EYES, 116.0
    places = (block(160, 500, 560, 720), block(200, 120, 520, 520), block(300, 440, 420, 480))
    shapes = tuple(
        Shape(name, group, (Contour(13 * number, 13),), fill, clip)
        for number, (name, group, fill, clip) in enumerate([
            ("body", "clothes", "#224488", ()),
            ("head", "face", "#eebb99", ()),
            ("mouth", "mouth", "#aa3333", ("head",)),
        ])
    )  # fmt: skip

    def draw(self, frames: Frames) -> Picture:
        points = np.repeat(np.concatenate(self.places)[None], len(frames), axis=0)
        points[:, 13:, 0] += frames[:, [INDEX["head.yaw"]]]
        return Picture(points, np.ones((len(frames), 3)), np.zeros((len(frames), 3)))


class Turning:
    """A head that turns as a sine of time."""

    def sample(self, times: np.ndarray) -> Frames:
        frames = np.repeat(REST[None], len(times), axis=0)
        frames[:, INDEX["head.yaw"]] = 10 * np.sin(3 * times)
        return frames


def face(name: str, place: PicturePlace | None = None, size: float = 1.0, kind: str = "woman") -> Face:
    return Face(name, kind, Voice(), Life("still"), NOWHERE, place=place, size=size)


def act(verb: Verb, start: float, settled: float, scene: int = 0) -> TimedAct:
    return TimedAct(0, verb, None, scene, start, settled, FOREVER, FOREVER, NOWHERE)


def background(colour: str | None, start: float, over: float = 0.0, scene: int = 0) -> TimedAct:
    return act(SetBackground(colour, None, over), start, start + over, scene)


def gradient(*colours: str, towards: float | None = -90.0) -> TimedAct:
    return act(SetBackground(None, None, gradient=Gradient(colours, towards)), 0.0, 0.0)


def view(of: str | None, zoom: float, start: float, over: float = 0.0) -> TimedAct:
    return act(View(of, zoom, over), start, start + over)


def score_of(
    faces: Sequence[Face],
    acts: Sequence[TimedAct] = (),
    scenes: Sequence[TimedScene] = (),
    film: Film = FILM,
    duration: float = 10.0,
) -> Score:
    whole = TimedScene("main", tuple(each.name for each in faces), 0.0, duration)
    return Score(film, tuple(faces), (), tuple(scenes) or (whole,), tuple(acts), (), (), duration)


def performance_of(score: Score) -> Performance:
    return Performance({each.name: Turning() for each in score.faces if each.seen}, score.duration)
