"""A question about a face's channels to their values over the whole film."""

from __future__ import annotations

import numpy as np

from facescript.backends.job import Job
from facescript.performance.channels import INDEX, POSE
from facescript.preview.messages import Message, text

MOST = 6_000
"""Values of a channel."""

FINEST = 1 / 60
"""Seconds between two of them, at least."""

CHANNELS = 12
"""Channels of one question."""


def curves(job: Job, version: int, asked: Message) -> bytes:
    """The message `curves` that answers {face, channels}; names that are none are left out."""
    face, names = str(asked.get("face")), asked.get("channels")
    known = job.performance.faces.get(face) is not None and isinstance(names, list)
    wanted = [name for name in names if name in INDEX][:CHANNELS] if known and isinstance(names, list) else []
    every = max(FINEST, job.end / MOST)
    frames = job.performance.sample_face(face, np.arange(0.0, job.end, every)) if wanted else np.zeros((0, len(POSE)))
    told = []
    for name in wanted:
        values = frames[:, INDEX[name]].round(4)
        least, most = float(values.min()), float(values.max())
        channel = POSE[INDEX[name]]
        told.append({"name": name, "unit": channel.unit, "least": least, "most": most, "values": values.tolist()})
    return text("curves", version=version, face=face, every=every, channels=told)
