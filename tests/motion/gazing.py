"""A face, targets and looks made by hand, planned and sampled to the channels a reader of the .csv sees."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from bars import Trace

from facescript.ir.acts import GazeManner, Glance, Life, Look, Voice
from facescript.ir.play import Face, Film, FixedTarget, MovingTarget, Target
from facescript.ir.values import AtCamera, AtTarget, Point
from facescript.motion.gaze.track import GazeTrack, eyes, midline
from facescript.schedule.score import Score, TimedAct, TimedScene
from facescript.space.direction import towards
from facescript.space.planner import GazeRequest, plan_gaze
from facescript.space.room import Room
from facescript.text import Source, Span

HERE = Span(Source("made.face", ""), 0, 0)
FAR_CM = 300.0


def face(gaze: str = "") -> Face:
    return Face("ada", "woman", Voice(), Life("still"), HERE, gaze=gaze)


def film(screen: float = 1.0) -> Film:
    """A film whose face has the middle of its eyes (and so straight ahead) within the picture's centre column."""
    return Film(screen=screen, seed=1)


def target(name: str, yaw: float, pitch: float = 0.0, distance: float = FAR_CM, of: Film | None = None) -> FixedTarget:
    """A target that the face sees at `yaw` and `pitch`, `distance` cm from its eyes."""
    up = Room(of or film(), [face()], []).point("ada", AtCamera(), 0.0).y
    x, y, z = towards(yaw, pitch)
    return FixedTarget(name, Point(x * distance, up + y * distance, z * distance), HERE)


def moving(name: str, keys: Sequence[tuple[float, float, float]], distance: float = FAR_CM) -> MovingTarget:
    """A moving target by its keys: time, yaw, pitch."""
    places = tuple(target("", yaw, pitch, distance).place for _, yaw, pitch in keys)
    return MovingTarget(name, tuple(key[0] for key in keys), places, HERE)


def request(
    order: int, aim: str | object, start: float, manner: GazeManner | None = None, **more: object
) -> GazeRequest:
    aim = AtTarget(aim) if isinstance(aim, str) else aim
    return GazeRequest((order, 0), aim, manner or GazeManner(), start, **more)


def score(targets: Sequence[Target], requests: Sequence[GazeRequest], who: Face, of: Film, duration: float) -> Score:
    plans = plan_gaze(Room(of, [who], targets), who, requests)
    acts = []
    for each in requests:
        verb = (Glance if each.glance else Look)(each.aim, each.manner)
        times = each.onset, plans[each.key][0].landed, each.released, each.released
        acts.append(TimedAct(each.key[0], verb, "ada", 0, *times, HERE, plan=plans[each.key]))
    acts.sort(key=lambda act: (act.start, act.order))
    scene = TimedScene("main", ("ada",), 0.0, duration)
    return Score(of, (who,), tuple(targets), (scene,), tuple(acts), (), (), duration)


def trace(
    targets: Sequence[Target],
    requests: Sequence[GazeRequest],
    duration: float = 2.5,
    who: Face | None = None,
    of: Film | None = None,
    rate: float = 1000.0,
) -> Trace:
    """The channels of eyes, head and gaze, sampled at `rate`."""
    who, of = who or face(), of or film()
    return sample(GazeTrack(score(targets, requests, who, of, duration), who), duration, rate)


def sample(track: GazeTrack, duration: float, rate: float = 1000.0) -> Trace:
    times = np.arange(0.0, duration, 1.0 / rate)
    head = np.concatenate([track.head(times), np.zeros((len(times), 1))], axis=1)
    both = eyes(track.sight(times), head)
    channels = {f"head.{axis}": head[:, index] for index, axis in enumerate(("yaw", "pitch", "roll"))}
    for side, number in (("left", 0), ("right", 1)):
        for index, axis in enumerate(("yaw", "pitch", "roll")):
            channels[f"eye.{side}.{axis}"] = both[:, number, index]
    points = midline(both, head)
    return Trace(times, channels | {"gaze.yaw": points[:, 0], "gaze.pitch": points[:, 1]})
