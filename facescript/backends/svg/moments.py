"""A job to the moments at which its picture is looked at for key frames: closer together where something is quick."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.performance.channels import Channel

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

TICK = 0.008
"""Seconds: all key times are whole multiples of it."""

STEP = 2
"""Ticks between two moments looked at where nothing is quick."""

BEFORE = 1e-6
"""Seconds: how shortly before a jump the picture is looked at."""

BEND = {"deg": 0.25, "cm": 0.02, "1": 0.006}
"""How far a channel may bend away from a straight line within STEP ticks before the moments between are looked at."""

HEAD_BEND = 0.04
"""The same for head angles, deg: the whole face hangs on them."""


def moments_of(job: Job) -> Floats:
    """The moments to look at: every STEP ticks, every tick where a channel bends, both sides of every jump."""
    if job.at is not None:
        return np.array([job.at])
    last = max(1, round((job.end - job.start) / TICK))
    ticks = np.arange(0, -(-last // STEP) * STEP + 1)
    bent = np.repeat(_bent(job, ticks), STEP)
    chosen = (ticks % STEP == 0) | np.append(bent, False)
    times = job.start + ticks[chosen & (ticks <= last)] * TICK
    jumps = _jumps(job)
    return np.unique(np.concatenate([times, jumps, jumps - BEFORE]))


def _bent(job: Job, ticks: Ints) -> NDArray[np.bool_]:
    """For each stretch of STEP ticks, whether any channel leaves the straight line across it by its BEND."""
    found = np.zeros(len(ticks) // STEP, dtype=bool)
    limit = _limits(job.performance.channels)
    for first in range(0, len(found), 500):
        rows = ticks[first * STEP : (first + 500) * STEP + 1]
        values = job.performance.sample(np.asarray(job.start + rows * TICK, dtype=np.float64))
        count = (len(rows) - 1) // STEP
        ends = values[::STEP][: count + 1]
        for part in range(1, STEP):
            inner = values[part::STEP][:count]
            line = ends[:-1] + (ends[1:] - ends[:-1]) * (part / STEP)
            found[first : first + count] |= (np.abs(inner - line) > limit).any(axis=1)
    return found


def _limits(channels: Sequence[Channel]) -> Floats:
    """The BEND of every column of a sample."""
    heads = [one.name.startswith("head") and one.unit == "deg" for one in channels]
    return np.array([HEAD_BEND if head else BEND[one.unit] for head, one in zip(heads, channels, strict=True)])


def _jumps(job: Job) -> Floats:
    """Moments at which the picture may jump: scenes, and acts that take no time."""
    scenes = [scene.start for scene in job.score.scenes]
    sudden = [act.start for act in job.score.acts if act.settled == act.start]
    ends = [act.released for act in job.score.acts if act.end == act.released < math.inf]
    inside = {time for time in scenes + sudden + ends if job.start < time < job.end}
    return np.array(sorted(inside))
