"""A line of sight and the head's pose to both eyes in the head, and back: the eyes to where they point in the room.

Angles are in deg: yaw + to the viewer's right, pitch + up, roll + clockwise for the viewer. A head is
pitched, then turned about the vertical, then tilted in the picture, as it is drawn (`rig/cartoon/turn.py`). The face's
left eye is on the viewer's right.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.space.reach import EYE_DOWN, EYE_END, EYE_KNEE, EYE_SIDE, EYE_UP, ROUGH

Floats = NDArray[np.float64]

APART_CM = 6.3
"""The distance of the eyes in the room, whatever the face's size, cm."""

WIDE = 85.0
"""Degrees: an eye that is turned further, by a channel of its own, counts as turned so far."""

NEARLY, LAST = 0.974, 0.99999
"""From the first part of their reach on the eyes are slowed that what is added to gaze takes further, to the second."""

GIVE, HALFWAY = 0.08, 5.0
"""By how much earlier, as a part of their reach, the eyes are slowed where more than gaze turns the head, for a shake
may run against a saccade; and the degrees of that at which it is half as much."""


BLUNT = 0.1
"""As a part of how far they are turned in, how near straight ahead the eyes change over from one of them having the
longer way to the other."""


def eyes(sight: Floats, head_pose: Floats, added: Floats | None = None) -> Floats:
    """Both eyes in the head: array[n, 2, 3], left and right; yaw, pitch, roll.

    `sight` is array[n, 3]: yaw and pitch of the line of sight in the room and the distance (cm) at which both eyes
    converge; `head_pose` is array[n, 3]: yaw, pitch, roll as drawn. Each eye points at the one point there is,
    within its reach (bars S8, V1); the head's own motion is undone at once (VOR of gain 1, bars H7, H8). Roll is
    Listing's: an eye has none but what its yaw and pitch bring about. `added`, array[n], is by how many degrees the
    head is turned besides gaze; None: not at all.
    """
    square = np.zeros(len(sight)) if added is None else added * added
    knee = NEARLY - GIVE * (square / (square + HALFWAY * HALFWAY))[:, None]
    yaw, pitch = _slowed(*converged(sight, head_pose), knee, LAST)
    roll = np.degrees(2.0 * np.arctan(np.tan(np.radians(yaw) / 2.0) * np.tan(np.radians(pitch) / 2.0)))
    return np.stack([yaw, pitch, roll], axis=-1)


def in_head(sight: Floats, head_pose: Floats) -> tuple[Floats, Floats]:
    """The line of sight as seen from between the eyes of a turned head: yaw and pitch, array[n] each."""
    return _angles(_to_head(_vectors(sight[:, 0], sight[:, 1]), head_pose))


def converged(sight: Floats, head_pose: Floats) -> tuple[Floats, Floats]:
    """Where each eye in the head would point, were there no end to its reach: yaw and pitch, array[n, 2] each."""
    target = _to_head(_vectors(sight[:, 0], sight[:, 1]), head_pose) * sight[:, 2:3]
    sides = np.array([[APART_CM / 2, 0.0, 0.0], [-APART_CM / 2, 0.0, 0.0]])
    return _angles(target[:, None, :] - sides)


def midline(eye_angles: Floats, head_pose: Floats) -> Floats:
    """Where the eyes' midline points in the room: array[n, 2], yaw and pitch; the inputs are as `eyes` has them.

    The direction from between the eyes to where they meet, near or far: the slopes of both, not their angles, average.
    """
    yaw, pitch = np.radians(np.clip(eye_angles[:, :, 0], -WIDE, WIDE)), np.radians(eye_angles[:, :, 1])
    aside, up = np.tan(yaw), np.tan(pitch) / np.cos(yaw)
    slopes = [(side[:, 0] + side[:, 1]) / 2 for side in (aside, up)]
    return np.stack(_angles(_to_room(np.stack([*slopes, np.ones_like(slopes[0])], axis=-1), head_pose)), axis=-1)


def within_reach(sight: Floats, head: Floats, nearness: Floats) -> Floats:
    """Lines of sight, array[n, 2] (deg), kept where both eyes in a head turned to `head`, array[n, 2], can follow them.

    They converge at `nearness`, array[n] (1/cm): the eye that is turned in has the longer way. The eyes wait at the end
    of their reach for the head, and what comes next sets off from there (bar S8).
    """
    half = np.degrees(np.arctan(nearness * APART_CM / 2))
    aside, up = (sight - head).T
    far = _extent(np.abs(aside) + half, up) >= EYE_KNEE - ROUGH
    if not far.any():
        return sight
    pose = np.concatenate([head[far], np.zeros((np.count_nonzero(far), 1))], axis=1)
    yaw, pitch = _angles(_to_head(_vectors(*sight[far].T), pose))
    scale = _shortened(yaw, pitch, half[far])
    kept = sight.copy()
    kept[far] = np.stack(_angles(_to_room(_vectors(yaw * scale, pitch * scale), pose)), axis=-1)
    return kept


def _shortened(yaw: Floats, pitch: Floats, half: Floats) -> Floats:
    """By what the eyes' midline is shortened so that an eye that is turned in by `half` deg more is within reach."""
    aside = np.hypot(yaw, BLUNT * half)
    extent = _extent(aside + half, pitch)
    sideways, inward = aside / EYE_SIDE, half / EYE_SIDE
    square = np.maximum(_extent(aside, pitch) ** 2, 1e-18)
    mixed = sideways * inward
    room = np.maximum(_bent(extent, EYE_KNEE, EYE_END) ** 2 - inward**2, 0.0)
    scale: Floats = (np.sqrt(mixed * mixed + square * room) - mixed) / square
    return np.where(extent > EYE_KNEE, scale, 1.0)


def _slowed(yaw: Floats, pitch: Floats, knee: Floats | float, end: float) -> tuple[Floats, Floats]:
    """The eyes' angles, beyond the part `knee` of their reach slowed so that they come to `end` without a jolt."""
    extent = _extent(yaw, pitch)
    scale = _bent(extent, knee, end) / np.maximum(extent, 1e-9)
    return yaw * scale, pitch * scale


def _bent(extent: Floats, knee: Floats | float, end: float) -> Floats:
    """A part of the eyes' reach, beyond `knee` bent so that it comes to `end`, evenly slowed."""
    room = end - knee
    over = np.clip(end + room - extent, 0.0, 2.0 * room)
    return np.where(extent > knee, end - over * over / (4.0 * room), extent)


def _extent(yaw: Floats, pitch: Floats) -> Floats:
    """How far the eyes are turned, as a part of their reach."""
    return np.hypot(yaw / EYE_SIDE, pitch / np.where(pitch > 0, EYE_UP, EYE_DOWN))


def _vectors(yaw: Floats, pitch: Floats) -> Floats:
    """Unit vectors array[n, 3] (x to the viewer's right, y up, z to the viewer) of directions."""
    y, p = np.radians(yaw), np.radians(pitch)
    return np.stack([np.sin(y) * np.cos(p), np.sin(p), np.cos(y) * np.cos(p)], axis=-1)


def _angles(vectors: Floats) -> tuple[Floats, Floats]:
    x, y, z = vectors[..., 0], vectors[..., 1], vectors[..., 2]
    return np.degrees(np.arctan2(x, z)), np.degrees(np.arctan2(y, np.hypot(x, z)))


def _matrices(pose: Floats) -> Floats:
    """Rotations array[n, 3, 3] of poses (yaw, pitch, roll) from the head to the room."""
    (sy, sp, sr), (cy, cp, cr) = np.sin(np.radians(pose.T)), np.cos(np.radians(pose.T))
    nil, one = np.zeros_like(sy), np.ones_like(sy)
    yaw = np.array([[cy, nil, sy], [nil, one, nil], [-sy, nil, cy]])
    pitch = np.array([[one, nil, nil], [nil, cp, sp], [nil, -sp, cp]])
    roll = np.array([[cr, sr, nil], [-sr, cr, nil], [nil, nil, one]])
    turned: Floats = np.einsum("ijn,jkn,kln->nil", roll, yaw, pitch)
    return turned


def _to_room(vectors: Floats, pose: Floats) -> Floats:
    turned: Floats = (_matrices(pose) * vectors[:, None, :]).sum(axis=2)
    return turned


def _to_head(vectors: Floats, pose: Floats) -> Floats:
    turned: Floats = (_matrices(pose) * vectors[:, :, None]).sum(axis=1)
    return turned
