"""A planned gaze shift: when eyes and head set off and arrive, and where they go."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.ir.values import Aim


@dataclass(frozen=True, slots=True)
class GazePlan:
    """One shift of gaze, seconds from the film's start, degrees in the face's own drawn frame (yaw + the viewer's
    right, pitch + up).

    The eyes leave at `eye_onset` and the line of sight lands at `landed`; the head moves from `head_onset` to
    `head_done` towards `head_share` of the target's direction (yaw, pitch). `released` is when the shift lets go and
    what it covered comes back (inf: until the next). `instant` shifts (`over 0ms`) jump.
    """

    aim: Aim
    parts: str
    eye_onset: float
    landed: float
    head_onset: float
    head_done: float
    head_share: tuple[float, float]
    amplitude: float
    released: float = float("inf")
    instant: bool = False
    unreachable: float = 0.0
