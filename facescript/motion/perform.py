"""Turns a score into a performance: every seen face's channels as pure functions of time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from facescript.ir.acts import SetLife
from facescript.ir.play import Face
from facescript.motion.blend import gesture_left
from facescript.motion.compose import Asked, compose, head_pose
from facescript.motion.dice import Dice
from facescript.motion.drivers import ROWS, Floats, rows
from facescript.motion.expression import Expression
from facescript.motion.gaze.track import GazeTrack
from facescript.motion.gesture import Gestures
from facescript.motion.hair import Hair
from facescript.motion.life.lives import Lives, lives
from facescript.motion.life.memory import Memory
from facescript.motion.mouth import MouthTrack
from facescript.motion.recorded import Recorded, Turned
from facescript.performance.channels import POSE, channels_of
from facescript.performance.performance import Frames, Performance
from facescript.schedule.score import Score, TimedAct, TimedLine, TimedScene
from facescript.speech.mouth.own import table_of

_PLACE = rows(("head.x", "head.y"))
_TURNS = rows(("head.yaw", "head.pitch", "head.roll"))
_SIGHTS = rows(("gaze.yaw", "gaze.pitch"))

Memories = dict[tuple[str, int], Memory]
"""What is remembered of a face's life in each scene, by the scene's name and how often it was played before."""


def perform(score: Score) -> Performance:
    """The curves of all seen faces."""
    seen = {face.name: face for face in score.faces if face.seen}
    motions = {name: FaceMotion(score, face) for name, face in seen.items()}
    hair = {name: motion.hair() for name, motion in motions.items() if seen[name].hair != "still"}
    channels = {name: channels_of(face.parts) for name, face in seen.items()}
    return Performance(dict(motions), score.duration, channels, hair)


@dataclass(frozen=True, slots=True)
class SceneMotion:
    """What one face does in one scene besides gaze and speech; the scene holds until the next one starts (seconds)."""

    start: float
    end: float
    expression: Expression
    gestures: Gestures
    lives: Lives
    recorded: Recorded
    heeded: Heeded


class FaceMotion:
    """One face over the whole film. Its sources stay apart in `asked`, so that each can be looked at alone."""

    def __init__(
        self, score: Score, face: Face, memories: Memories | None = None, before: FaceMotion | None = None
    ) -> None:
        """In a run there are `memories` of its lives, and what would be as it was `before` is taken from there."""
        self.scenes: tuple[SceneMotion, ...] = tuple(_scenes(score, face, memories, before.scenes if before else ()))
        self._gazing = _gazing(score, face)
        same = before is not None and before._gazing == self._gazing
        track = before.gaze if before else None
        self.gaze: GazeTrack = track if track is not None and same else GazeTrack(score, face, track)
        spoken = tuple(line for line in score.lines if line.face == face.name)
        self._saying = _saying(spoken)
        same = before is not None and before._saying == self._saying
        self.mouth: MouthTrack = (
            before.mouth if before is not None and same else MouthTrack(spoken, table_of(score.visemes))
        )

    def sample(self, times: Floats) -> Frames:
        """Poses at `times` (seconds, any order): array[len(times), len(POSE)]."""
        times = np.ascontiguousarray(times, dtype=np.float64)
        if np.all(times[1:] >= times[:-1]):
            return compose(self.asked(times))
        order = np.argsort(times, kind="stable")
        frames = np.empty((len(times), len(POSE)))
        frames[order] = compose(self.asked(times[order]))
        return frames

    def hair(self) -> Hair:
        """How hair trails behind the face's head as it is drawn."""
        return Hair(self.head, [(scene.start, scene.end) for scene in self.scenes])

    def head(self, times: Floats) -> Floats:
        """The head at `times` (sorted) as it is drawn: array[n, 5], yaw, pitch, roll (deg), x, y (cm)."""
        asked = self.asked(times)
        drive = asked.sum
        return np.concatenate([head_pose(asked.head, drive), drive[_PLACE]]).T

    def scene(self, time: float) -> SceneMotion | None:
        """The scene that plays at `time`, where the face is in it."""
        return next((scene for scene in self.scenes if scene.start <= time < scene.end), None)

    def asked(self, times: Floats) -> Asked:
        """What each source asks at `times` (sorted), before the law blends them."""
        expression, gestures, life = (np.zeros((len(ROWS), len(times))) for _ in range(3))
        for scene in self.scenes:
            window = slice(*np.searchsorted(times, [scene.start, scene.end]))
            if window.start < window.stop:
                expression[:, window] = scene.expression.at(times[window])
                gestures[:, window] = scene.gestures.at(times[window])
                life[:, window] = scene.lives.at(times[window])
        sight, head = self.gaze.sight(times), self.gaze.head(times)
        if gestures[_TURNS].any():
            gestures[_TURNS] *= gesture_left(self.gaze.turning(times, head))
        asked = Asked(expression, gestures, life, sight, head, *self.mouth.sample(times))
        return self._with_takes(asked, times)

    def _with_takes(self, asked: Asked, times: Floats) -> Asked:
        """What is asked where takes are played: they turn head and eyes, and life waits on what they have."""
        played = [scene for scene in self.scenes if scene.recorded]
        if not played:
            return asked
        turned = Turned.nowhere(len(times))
        for scene in played:
            window = slice(*np.searchsorted(times, [scene.start, scene.end]))
            if window.start < window.stop:
                turned.lay(window, scene.recorded.turned(times[window]))
                asked.life[:, window] *= 1.0 - scene.expression.recorded(times[window])
        share = turned.head_share[:, None]
        asked.life[_TURNS] *= 1.0 - turned.head_share
        asked.life[_SIGHTS] *= 1.0 - turned.eye_share
        asked.expression[_TURNS[2]] += turned.head[:, 2] * turned.head_share
        head = asked.head * (1.0 - share) + turned.head[:, :2] * share
        return replace(asked, head=head, turned=turned)


Heeded = tuple[object, ...]
"""All that the lives of a face in a scene hang on."""


def _gazing(score: Score, face: Face) -> Heeded:
    """All that the gaze of a face hangs on."""
    plans = [(act.scene, act.plan) for act in score.acts if act.face == face.name and act.plan]
    return plans, score.scenes, score.targets


def _saying(lines: Sequence[TimedLine]) -> Heeded:
    """All that the mouth of a face hangs on."""
    return tuple((line.spoken, line.start, line.cut, line.volume) for line in lines)


def _heeded(acts: Sequence[TimedAct], lines: Sequence[TimedLine], scene: TimedScene, memory: Memory | None) -> Heeded:
    gazing = [(act.verb, act.start, act.end, act.plan) for act in acts if act.plan or isinstance(act.verb, SetLife)]
    return gazing, _saying(lines), scene, memory


def _scenes(
    score: Score, face: Face, memories: Memories | None, before: Sequence[SceneMotion]
) -> Iterator[SceneMotion]:
    """The scenes a face is in; it is neutral in the others."""
    starts = [scene.start for scene in score.scenes]
    for number, scene in enumerate(score.scenes):
        if face.name not in scene.faces:
            continue
        acts = tuple(act for act in score.acts if act.face == face.name and act.scene == number)
        lines = tuple(line for line in score.lines if line.face == face.name and scene.start <= line.start < scene.end)
        again = _times_before(score.scenes, number)
        dice = Dice(score.film.seed, (face.name, scene.name, again))
        memory = None if memories is None else memories.setdefault((scene.name, again), Memory())
        heeded = _heeded(acts, lines, scene, memory)
        same = next((one.lives for one in before if one.heeded == heeded), None)
        yield SceneMotion(
            scene.start,
            starts[number + 1] if number + 1 < len(starts) else np.inf,
            Expression(acts, scene.start, scene.end),
            Gestures(acts),
            same or lives(face.life, acts, lines, scene.start, scene.end, dice, channels_of(face.parts), memory),
            Recorded(acts),
            heeded,
        )


def _times_before(scenes: tuple[TimedScene, ...], number: int) -> int:
    """How often a scene has been played before: one that is begun again lives anew."""
    again = scenes[number].again
    if again is not None:
        return again
    return sum(scene.name == scenes[number].name for scene in scenes[:number])
