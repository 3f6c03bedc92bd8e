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

    `aim` is definite: a person is its target, the nearest of a crowd a number, `away` a direction. `parts` says which
    parts the shift uses ("eyes only", "head only", else both). `eye_done` is when the line of sight has run its
    course: where the eyes then wait at the end of their reach for the head, `landed` is later. `head_from` is what the
    head's share is counted from. `unreachable` is by how many degrees the gaze stays short of the target at worst, and
    `worst` when that is; `at_times` whether the target is out of reach, or lost, for a part of the time only; `lost`
    whether nobody knows where it is. `needs` is how long the shift takes, in s, where its `over` asked for less than
    eyes or head can do; else 0.
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
    worst: float = 0.0
    at_times: bool = False
    lost: bool = False
    eye_done: float = 0.0
    head_from: tuple[float, float] = (0.0, 0.0)
    needs: float = 0.0

    @property
    def starts(self) -> float:
        """When the shift begins: the later start wins the parts it uses (rule 5 of the blending law)."""
        return min(self.eye_onset, self.head_onset)

    @property
    def uses_eyes(self) -> bool:
        return self.parts != "head only"

    @property
    def uses_head(self) -> bool:
        return self.parts != "eyes only"
