"""Events on a trace: blinks, fast movements of gaze, and stretches in which something is so."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from bars import ONSET_SHARE, Floats, Trace
from numpy.typing import NDArray

DEEP = 0.3
"""How far a lid closes and opens again, at least, in a blink."""

BEFORE, AFTER = 0.15, 0.4
"""Seconds around the moment of a shut lid in which it comes from its opening and goes back to it."""


LONGEST = 200
"""Samples at 1000 Hz in which a lid closes; it opens within twice as many."""


@dataclass(frozen=True, slots=True)
class Blink:
    """A blink: when it begins, is shut furthest and ends (s), how far it shuts the eye (1: wholly), and the peak
    speeds of its closing and opening (1/s). Onset and end are where the lid's speed is 5 % of the phase's peak."""

    onset: float
    shut: float
    end: float
    depth: float
    closing_speed: float
    opening_speed: float

    @property
    def closing_ms(self) -> float:
        return (self.shut - self.onset) * 1000


def shut_moments(times: Floats, lid: Floats) -> list[float]:
    """When each blink of a trace is shut furthest, s; a lid that stays shut counts once."""
    step = times[1] - times[0]
    before, after = round(BEFORE / step), round(AFTER / step)
    padded = np.pad(lid, (before, after), mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, before + after + 1)
    low = np.maximum(windows[:, : before + 1].min(axis=1), windows[:, before:].min(axis=1))
    shut = (lid >= windows.max(axis=1)) & (lid - low >= DEEP)
    return [float(times[first]) for first, _ in stretches(shut)]


def blink_at(trace: Trace, moment: float) -> Blink:
    """The blink of a trace that is shut furthest about a moment."""
    lid = trace.channels["lid.left"]
    speed = trace.speed(lid)
    near = np.flatnonzero(np.abs(trace.times - moment) < 0.02)
    shut = int(near[lid[near].argmax()])
    first = max(0, shut - LONGEST)
    closing = first + int(speed[first : shut + 1].argmax())
    opening = int(shut + speed[shut : shut + 2 * LONGEST].argmin())
    still = np.flatnonzero(speed[:closing] <= ONSET_SHARE * speed[closing])
    onset = int(still[-1]) + 1 if len(still) else 0
    rested = np.flatnonzero(speed[opening:] >= ONSET_SHARE * speed[opening])
    end = opening + int(rested[0]) if len(rested) else len(lid) - 1
    times = trace.times
    return Blink(
        float(times[onset]), float(times[shut]), float(times[end]), float(lid[shut]), float(speed[closing]),
        float(-speed[opening]),
    )  # fmt: skip


def stretches(so: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last (not included) index of every stretch in which something is so."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], so, [False]]).astype(int)))
    return [(int(first), int(last)) for first, last in edges.reshape(-1, 2)]


def joined(found: Sequence[tuple[int, int]], gap: int) -> list[tuple[int, int]]:
    """The stretches, those at most `gap` apart made one."""
    kept: list[tuple[int, int]] = []
    for first, last in found:
        if kept and first - kept[-1][1] <= gap:
            kept[-1] = kept[-1][0], last
        else:
            kept.append((first, last))
    return kept
