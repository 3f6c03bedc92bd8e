"""The recorded performances of a face in a scene to what they ask: of its drivers, of its head, of its eyes.

A take is laid where a `show` would be: it is the base on the channels that it has, and a later `show` covers it
(rule 5). Head and eyes it takes from gaze, until a later look takes them back. Life waits on all that a take has.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from facescript.ir.acts import Glance, Look, Perform, Scan, Take
from facescript.motion.drivers import BLINKS, ROWS, Drive, Floats, number
from facescript.performance.channels import INDEX, MUSCLES, SIDES
from facescript.performance.curves import Ramp
from facescript.performance.limits import KNEE
from facescript.performance.performance import REST
from facescript.schedule.defaults import JOINED
from facescript.schedule.score import TimedAct
from facescript.shapes.measures import shut
from facescript.shapes.takes.played import played

TURNS = ("head.yaw", "head.pitch", "head.roll")
EYES = tuple(f"eye.{side}.{axis}" for side in SIDES for axis in ("yaw", "pitch", "roll"))

LIMITED = (
    *(f"{muscle}.{side}" for muscle in (*MUSCLES, "muzzle", "ear", "lid") for side in SIDES),
    *("mouth.round", "mouth.teeth", "mouth.tongue"),
)
"""Drivers that the soft limit bends: they are asked for so that what was recorded comes of it."""

FULLEST = 0.9999
"""Of the room above the soft limit's knee, how much is asked for at most."""


@dataclass(frozen=True, slots=True)
class Recording:
    """A take as drives, by frames: `asks` array[frame, row], on the rows `has` (0 or 1, array[row]); `head`
    array[frame, 3] and `eyes` array[frame, 6], deg, where `turns` and `looks` say that it has them."""

    times: Floats
    asks: Floats
    has: Floats
    head: Floats
    eyes: Floats
    turns: bool
    looks: bool


@lru_cache(maxsize=8)
def recording(take: Take) -> Recording:
    """A take as what it asks for; worked out once for all that play it."""
    found = played(take)
    asks, has = np.zeros((len(found.times), len(ROWS))), np.zeros(len(ROWS))
    for name in found.channels:
        if name in TURNS or name in EYES:
            continue
        asks[:, ROWS[name]] = found.poses[:, INDEX[name]] - REST[INDEX[name]]
        has[ROWS[name]] = 1.0
    for side, blink in zip(SIDES, BLINKS, strict=True):
        if has[ROWS[f"lid.{side}"]]:
            lid, pitch = (found.poses[:, INDEX[name]] for name in (f"lid.{side}", f"eye.{side}.pitch"))
            asks[:, ROWS[f"lid.{side}"]] = shut(lid, pitch)
            has[ROWS[blink]] = 1.0
    bent = [ROWS[name] for name in LIMITED if has[ROWS[name]]]
    asks[:, bent] = _unbent(asks[:, bent])
    head, eyes = (found.poses[:, [INDEX[name] for name in names]] for names in (TURNS, EYES))
    turns, looks = (any(name in found.channels for name in names) for names in (TURNS, EYES))
    return Recording(found.times, asks, has, head, eyes, turns, looks)


def _unbent(values: Floats) -> Floats:
    """What has to be asked for so that the soft limit makes it these values, either way from rest."""
    far = np.abs(values)
    above = np.clip((far - KNEE) / (1.0 - KNEE), 0.0, FULLEST)
    return np.copysign(np.where(far > KNEE, KNEE + (1.0 - KNEE) * np.arctanh(above), far), values)


@dataclass(frozen=True, slots=True)
class Playing:
    """A take as it is played from `start` on (s), `rise` and `fall` how it comes in and lets go."""

    act: TimedAct
    recording: Recording
    start: float
    speed: float
    rise: Ramp
    fall: Ramp

    def weight(self, times: Floats) -> Floats:
        return self.rise.at(times) * (1.0 - self.fall.at(times))

    def asks(self, times: Floats) -> Drive:
        """What it asks at its full weight: array[row, time]."""
        return self._at(self.recording.asks, times).T

    def turns(self, times: Floats) -> tuple[Floats, Floats]:
        """Head, array[n, 3], and eyes, array[n, 6], deg."""
        return self._at(self.recording.head, times), self._at(self.recording.eyes, times)

    def _at(self, rows: Floats, times: Floats) -> Floats:
        """Rows of the frames at times, straight from each to the next."""
        frames, at = self.recording.times, np.maximum(times - self.start, 0.0) * self.speed
        after = np.clip(np.searchsorted(frames, at, side="right"), 1, max(len(frames) - 1, 1))
        if len(frames) == 1:
            return np.repeat(rows, len(times), axis=0)
        share = np.clip((at - frames[after - 1]) / (frames[after] - frames[after - 1]), 0.0, 1.0)[:, None]
        return rows[after - 1] * (1.0 - share) + rows[after] * share


def playing(act: TimedAct) -> Playing:
    """A play of the score."""
    assert isinstance(act.verb, Perform)
    rise = Ramp(act.start, min(act.start + JOINED, act.released))
    return Playing(act, recording(act.verb.take), act.start, number(act.verb.speed), rise, Ramp(act.released, act.end))


@dataclass(frozen=True, slots=True)
class Turned:
    """Where takes turn head and eyes, deg, and how far they own them (0..1): `head` array[n, 3] by `head_share`
    array[n], `eyes` array[n, 2, 3] by `eye_share`."""

    head: Floats
    head_share: Floats
    eyes: Floats
    eye_share: Floats

    @classmethod
    def nowhere(cls, count: int) -> Turned:
        """At so many times, nothing is turned."""
        return cls(np.zeros((count, 3)), np.zeros(count), np.zeros((count, 2, 3)), np.zeros(count))

    @classmethod
    def of_eyes(cls, eyes: Floats, share: Floats) -> Turned:
        """Where the eyes are turned alone."""
        return cls(np.zeros((len(share), 3)), np.zeros(len(share)), eyes, share)

    def lay(self, window: slice, other: Turned) -> None:
        """What is turned in a stretch of the times."""
        for own, its in zip(
            (self.head, self.head_share, self.eyes, self.eye_share),
            (other.head, other.head_share, other.eyes, other.eye_share),
            strict=True,
        ):
            own[window] = its


class Recorded:
    """All that is played of one face in one scene; `acts` are the face's there, sorted by (start, order)."""

    def __init__(self, acts: Sequence[TimedAct]) -> None:
        plays = [act for act in acts if isinstance(act.verb, Perform)]
        looks = [act for act in acts if isinstance(act.verb, (Look, Glance, Scan))] if plays else []
        self._plays = [(playing(act), [look for look in looks if _after(look, act)]) for act in plays]

    def __bool__(self) -> bool:
        return bool(self._plays)

    def turning(self, part: int, time: float) -> TimedAct | None:
        """The latest play that turns the head (`part` 0) or the eyes (1) at a time."""
        at = np.array([time])
        for item, looks in reversed(self._plays):
            has = (item.recording.turns, item.recording.looks)[part]
            if has and item.weight(at)[0] * _left(looks, part, at)[0] > 0.0:
                return item.act
        return None

    def turned(self, times: Floats) -> Turned:
        """Head and eyes at `times` (sorted)."""
        head, eyes = np.zeros((len(times), 3)), np.zeros((len(times), 6))
        shares = [np.zeros(len(times)), np.zeros(len(times))]
        for item, looks in self._plays:
            weight = item.weight(times)
            if not np.any(weight):
                continue
            made = item.turns(times)
            has = item.recording.turns, item.recording.looks
            for part, (whole, own) in enumerate(zip((head, eyes), made, strict=True)):
                if has[part]:
                    now = weight * _left(looks, part, times)
                    before = shares[part] * (1.0 - now)
                    shares[part] = before + now
                    share = np.divide(now, shares[part], out=np.zeros_like(now), where=shares[part] > 0.0)[:, None]
                    whole += (own - whole) * share
        return Turned(head, shares[0], eyes.reshape(-1, 2, 3), shares[1])


def _after(look: TimedAct, act: TimedAct) -> bool:
    """Whether a look is later than a play, and begins while that lasts."""
    return (act.start, act.order) < (look.start, look.order) and look.start < act.released


PARTS = ("head", "eyes")


def _left(looks: Sequence[TimedAct], part: int, times: Floats) -> Floats:
    """What later looks leave of a part to a take, array[n], 0..1."""
    left = np.ones_like(times)
    for look in looks:
        if look.verb.manner.parts != f"{PARTS[1 - part]} only":  # type: ignore[union-attr]
            rise = Ramp(look.start, look.start + JOINED)
            fall = Ramp(look.released, look.released + JOINED)
            left = left * (1.0 - rise.at(times) * (1.0 - fall.at(times)))
    return left
