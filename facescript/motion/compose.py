"""Turns what the sources of a face ask into its poses: the blending law, applied in its order."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facescript.motion.blend import (
    add_within,
    blink_together,
    ear_limit,
    eyes_within,
    lid_drawn,
    lid_limit,
    speak_over,
    turn_within,
)
from facescript.motion.drivers import BLINKS, Drive, Floats, rows
from facescript.motion.gaze.track import eyes, midline
from facescript.motion.recorded import Turned
from facescript.performance.channels import INDEX, MOUTH, MUSCLES, SIDES
from facescript.performance.easing import smooth
from facescript.performance.limits import soft_limit
from facescript.performance.performance import REST, Frames

HEAD_LIMITS = (45.0, 30.0, 30.0)
"""How far the head turns (yaw, pitch, roll), deg to either side."""

BLINK_TURN = 0.9, -1.4
"""Degrees the eye turns in a blink, nasally and up: 1 to 2 deg nasally and down (Doane 1980, bar B6)."""

TURNS, TURNED = 0.15, 0.7
"""How far a blink has shut when the eye sets off and when it has turned. So the eye moves faster than the lid, and is
back before the lids are open (Doane 1980; `motion.md` 5)."""

MOUTH_RANGE = {"wide": (-1.0, 1.0), "round": (0.0, 1.0), "teeth": (0.0, 1.0), "tongue": (0.0, 1.0)}
"""The ranges of the mouth's parts on which speech and expression add; the others have none."""

LEAST_SCALE = 0.05
"""Nothing is drawn smaller than this part of its size."""

_MUSCLES = rows(f"{muscle}.{side}" for muscle in (*MUSCLES, "muzzle") for side in SIDES)
_EARS = rows(f"ear.{side}" for side in SIDES)
_HEAD = rows(f"head.{axis}" for axis in ("yaw", "pitch", "roll"))
_SHIFTS = rows(["head.x", "head.y", *(f"eye.{side}.{axis}" for side in SIDES for axis in "xy")])
_SCALES = rows(["head.scale", *(name for side in SIDES for name in (f"eye.{side}.scale", f"pupil.{side}"))])
_EYES = rows(f"eye.{side}.{axis}" for side in SIDES for axis in ("yaw", "pitch", "roll"))
_LIDS = rows(f"lid.{side}" for side in SIDES)
_BLINKS = rows(BLINKS)
_GAZE = rows(("gaze.yaw", "gaze.pitch"))
_PRESS = rows(f"lip.press.{side}" for side in SIDES)


@dataclass(frozen=True, slots=True)
class Asked:
    """What each source asks at n times. `sight` is array[n, 3] (deg, deg, cm), `head` array[n, 2] (deg), of gaze;
    `spoken` is array[n, 8] in the order of `channels.MOUTH`, and `activity` array[n] how far speech sounds (0..1).
    `turned` is where takes turn the eyes; what they ask of the head is in `head` already."""

    expression: Drive
    gestures: Drive
    life: Drive
    sight: Floats
    head: Floats
    spoken: Floats
    activity: Floats
    turned: Turned | None = None

    @property
    def sum(self) -> Drive:
        return self.expression + self.gestures + self.life


def compose(asked: Asked) -> Frames:
    """The poses: array[n, channel], a pure function of each row of what is asked. No hair moves in them."""
    drive = asked.sum
    pose = np.zeros((len(INDEX), drive.shape[1]))
    pose[_MUSCLES] = soft_limit(drive[_MUSCLES])
    pose[_EARS] = ear_limit(drive[_EARS])
    pose[_SHIFTS] = drive[_SHIFTS]
    pose[_SCALES] = np.maximum(REST[_SCALES, None] + drive[_SCALES], LEAST_SCALE)
    pose[_HEAD] = head_pose(asked.head, drive)
    _look(pose, asked, drive)
    _speak(pose, asked, drive)
    return np.ascontiguousarray(pose.T)


def head_pose(gaze: Floats, drive: Drive) -> Drive:
    """Rule 6: gaze turns the head, gestures, life and channels of the head add."""
    turned = (gaze[:, 0], gaze[:, 1], np.zeros(len(gaze)))
    added = (drive[row] for row in _HEAD)
    axes = zip(turned, added, HEAD_LIMITS, strict=True)
    return np.stack([turn_within(angle, more, limit) for angle, more, limit in axes])


def _look(pose: Drive, asked: Asked, drive: Drive) -> None:
    """Rules 2 and 6: the eyes answer the whole head, so that gaze stays where it is meant; the lids follow the eyes."""
    head = np.ascontiguousarray(pose[_HEAD].T)
    wanted = eyes_wanted(asked, drive, head)
    blinks = blinks_drawn(asked)
    for side, blink in enumerate(blinks):
        pose[_LIDS[side]] = lid_drawn(lid_limit(drive[_LIDS[side]]), blink, wanted[:, side, 1])
    drawn = eyes_within(pulled(wanted, blinks))
    pose[_EYES] = drawn.reshape(-1, 6).T
    pose[_GAZE] = midline(drawn, head).T


def sight_meant(asked: Asked, drive: Drive) -> Floats:
    """The line of sight of gaze, and how far life moves it: array[n, 3], deg, deg, cm."""
    sight = asked.sight.copy()
    sight[:, :2] += drive[_GAZE].T
    return sight


def eyes_wanted(asked: Asked, drive: Drive, head: Floats) -> Floats:
    """Both eyes in the head, array[n, 2, 3], before a blink pulls them; `head` is array[n, 3] as drawn."""
    return eyes_on_sight(asked, drive, head) + drive[_EYES].T.reshape(-1, 2, 3)


def eyes_on_sight(asked: Asked, drive: Drive, head: Floats) -> Floats:
    """Both eyes in the head, array[n, 2, 3], as gaze and life would have them, or a take."""
    added = np.hypot(head[:, 0] - asked.head[:, 0], head[:, 1] - asked.head[:, 1])
    seen = eyes(sight_meant(asked, drive), head, added)
    if asked.turned is None:
        return seen
    share = asked.turned.eye_share[:, None, None]
    return seen * (1.0 - share) + asked.turned.eyes * share


def blinks_drawn(asked: Asked) -> list[Floats]:
    """How far blinks have shut the left and the right lid, array[n] each: 0 open, 1 shut."""
    sources = (asked.expression, asked.gestures, asked.life)
    return [blink_together(*(source[row] for source in sources)) for row in _BLINKS]


def pulled(wanted: Floats, blinks: list[Floats]) -> Floats:
    """The eyes as the blinks turn them, array[n, 2, 3]."""
    drawn = wanted.copy()
    for side, (blink, nasal) in enumerate(zip(blinks, (-1.0, 1.0), strict=True)):
        turned = smooth((blink - TURNS) / (TURNED - TURNS))
        drawn[:, side, 0] += nasal * BLINK_TURN[0] * turned
        drawn[:, side, 1] += BLINK_TURN[1] * turned
    return drawn


def _speak(pose: Drive, asked: Asked, drive: Drive) -> None:
    """Rule 3: speech owns gap and jaw; on the rest of the mouth it and the expression add."""
    spoken = dict(zip(MOUTH, asked.spoken.T, strict=True))
    pressed = lips_pressed(drive)
    for part, values in spoken.items():
        row = INDEX[f"mouth.{part}"]
        if part in ("open", "jaw"):
            most = 1.0 if part == "jaw" else np.inf
            pose[row] = np.clip(speak_over(drive[row], values, asked.activity, pressed), 0.0, most)
        elif part in MOUTH_RANGE:
            pose[row] = add_within(values, drive[row], *MOUTH_RANGE[part])
        else:
            pose[row] = values + drive[row]


def lips_pressed(drive: Drive) -> Floats:
    """How far both lips are pressed together, array[n], 0..1: it narrows what is spoken."""
    pressed: Floats = soft_limit(drive[_PRESS]).sum(axis=0) / 2.0
    return pressed
