"""A performance to the one moment that stands for it: eyes open, and as much in the face as there ever is."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.performance.channels import INDEX, MUSCLES, SIDES

Floats = NDArray[np.float64]

LOOKS = 240
"""Moments looked at, evenly over the stretch."""

EXPRESSIVE = [INDEX[f"{muscle}.{side}"] for muscle in MUSCLES for side in SIDES]
LIDS = [INDEX[f"lid.{side}"] for side in SIDES]

SHUT = 4.0
"""Muscles that a shut eye outweighs: a blink tells nothing."""

TALK = 1.0
"""The same for a mouth open as far as the nose is from it."""

HERE = 2.0
"""The same that a face is worth which is there."""


def telling_moment(job: Job, start: float | None = None, end: float | None = None) -> float:
    """Seconds; the first of the best from `start` to `end`, which are the job's own where they are not said."""
    first, last = job.start if start is None else start, job.end if end is None else end
    times = np.linspace(first, last, LOOKS, endpoint=False)
    worth = np.zeros(LOOKS)
    for face in (face.name for face in job.score.faces if face.seen):
        poses = job.performance.sample_face(face, times)
        shut = np.maximum(poses[:, LIDS], 0.0).sum(axis=1)
        talk = np.maximum(poses[:, INDEX["mouth.open"]], 0.0)
        shown = poses[:, EXPRESSIVE].sum(axis=1) - SHUT * shut - TALK * talk + HERE
        worth += np.where(_present(job, face, times), shown, 0.0)
    return float(times[np.argmax(np.round(worth, 3))])


def _present(job: Job, face: str, times: Floats) -> NDArray[np.bool_]:
    """Whether a face is in the scene."""
    scenes = job.score.scenes
    place = np.searchsorted([scene.start for scene in scenes], times, side="right") - 1
    return np.array([face in scene.faces for scene in scenes])[np.maximum(place, 0)]
