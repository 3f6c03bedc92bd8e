"""The rules of the blending law (`language.md`), each from what is asked for to what is drawn.

Every function is pure and works row by row in time, so that each rule can be tested, and asked about, alone.
"""

from __future__ import annotations

import numpy as np

from facescript.motion.drivers import Floats
from facescript.performance.limits import LID_FLOOR, gaze_on_lid, soft_limit
from facescript.space.main_sequence import HEAD_CEILING
from facescript.space.reach import EYE_DOWN, EYE_SIDE, EYE_UP

HEAD_EASE = 5.2
"""Degrees before the end of the head's range from which it is slowed, and as many beyond that are asked for until it is
there: a head that comes up at 320 deg/s is slowed by 10 deg/s in a millisecond at most."""

YIELDING = 0.45
"""How much smaller a gesture of the head is while gaze turns it as fast as it may: a shake alone goes at 210 deg/s,
gaze at up to 185, and a head never at more than 320."""

WIDENED, PRESSED = 0.4, 0.5
"""How much an open mouth or jaw that is shown widens those of speech, and pressed lips narrow them."""

TINY = 1e-200
"""Room where there is none, so that a part of it can be taken."""


def ear_limit(value: Floats) -> Floats:
    """Rule 1 for what moves both ways from its rest: as a muscle's to either side, within -1..1."""
    value = np.asarray(value, dtype=np.float64)
    return np.copysign(soft_limit(np.abs(value)), value)


def lid_limit(value: Floats) -> Floats:
    """Rule 1 for a lid that an expression shuts or widens: as a muscle's, but down to `LID_FLOOR`."""
    value = np.asarray(value, dtype=np.float64)
    return np.where(value < 0.0, np.maximum(value, LID_FLOOR), soft_limit(value))


def blink_together(*blinks: Floats) -> Floats:
    """Blinks that overlap: what each leaves open, multiplied; 0 open, 1 shut."""
    left = np.ones_like(blinks[0])
    for blink in blinks:
        left = left * (1.0 - np.clip(blink, 0.0, 1.0))
    return 1.0 - left


def lid_opening(lid: Floats, blink: Floats) -> Floats:
    """Rule 2: the opening (1 at rest, 0 shut) that an expression's lid and a blink leave."""
    return (1.0 - lid) * (1.0 - blink)


def lid_drawn(lid: Floats, blink: Floats, pitch: Floats) -> Floats:
    """Rule 2 as a whole: the channel `lid.*`. Shut lids stay shut wherever the eye turns."""
    return np.clip(1.0 - lid_opening(lid, blink) * gaze_on_lid(pitch), LID_FLOOR, 1.0)


def speak_over(shown: Floats, spoken: Floats, activity: Floats, pressed: Floats) -> Floats:
    """Rule 3: lip gap or jaw drop. As far as speech sounds (`activity` 0..1) it owns them.

    What is `shown` widens what is spoken and `pressed` lips (0..1) narrow it; where speech closes, it is 0.
    """
    wider = 1.0 + WIDENED * np.clip(shown, 0.0, 1.0)
    narrower = 1.0 - PRESSED * np.clip(pressed, 0.0, 1.0)
    return shown * (1.0 - activity) + spoken * wider * narrower * activity


def gesture_left(speed: Floats) -> Floats:
    """Rule 6: how much is left of a gesture of the head while gaze turns it at `speed` (deg/s): array[n], 0..1."""
    haste = np.square(speed / HEAD_CEILING)
    left: Floats = 1.0 - YIELDING * 2.0 * haste / (1.0 + haste)
    return left


def turn_within(gaze: Floats, added: Floats, limit: float) -> Floats:
    """Rule 6: the head turned by `gaze`, and what is `added`, deg; within `limit` to both sides.

    The sum is exact up to `HEAD_EASE` from the limit, and bends from there on, with the pose of gaze where it is. So a
    shake at the very end of the head's range comes to rest there, and does not strike it.
    """
    asked = _eased_back(np.clip(gaze, -limit, limit), limit) + added
    over = np.clip(limit + HEAD_EASE - np.abs(asked), 0.0, 2.0 * HEAD_EASE)
    bent = np.sign(asked) * (limit - over * over / (4.0 * HEAD_EASE))
    turned = np.where(np.abs(asked) > limit - HEAD_EASE, bent, asked)
    return np.where(added == 0.0, gaze, turned)


def _eased_back(turned: Floats, limit: float) -> Floats:
    """What would have to be asked for so that `turned` comes of it."""
    room = limit - np.abs(turned)
    asked = np.sign(turned) * (limit + HEAD_EASE - np.sqrt(4.0 * HEAD_EASE * room))
    return np.where(room < HEAD_EASE, asked, turned)


def add_within(base: Floats, added: Floats, low: float, high: float) -> Floats:
    """What lays one thing over another in a range: `base` as it is, and what is `added` to it.

    That is the identity up to 0.8 of the room that `base` leaves towards `low` or `high`, bends, and never leaves it.
    """
    room = np.maximum(np.where(added > 0.0, high - base, base - low), TINY)
    return base + np.sign(added) * room * soft_limit(np.abs(added) / room)


def eyes_within(angles: Floats) -> Floats:
    """Eyes in the head, array[n, 2, 3], kept inside the ellipse that they reach."""
    yaw, pitch = angles[..., 0], angles[..., 1]
    extent = np.hypot(yaw / EYE_SIDE, pitch / np.where(pitch > 0.0, EYE_UP, EYE_DOWN))
    kept = angles.copy()
    kept[..., :2] /= np.maximum(extent, 1.0)[..., None]
    return kept
