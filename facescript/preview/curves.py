"""A question about a face's channels to their values over the whole film, and how the page draws them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.backends.job import Job
from facescript.performance.channels import INDEX, POSE, channels_of
from facescript.performance.performance import Performance
from facescript.plot.looks import look
from facescript.web.messages import Message, text

EVERY = 0.01
"""Seconds from one value to the next: a saccade of 20 ms has two."""

MOST = 400_000
"""Values of one answer; where they would be more they stand wider apart."""

CHUNK = 8192
"""Values taken at once."""

DECIMALS = {"deg": 2, "cm": 2, "1": 3}


def curves(job: Job, version: int, asked: Message) -> bytes:
    """The message `curves` that answers {face, channels}; names of what the face does not have are left out.

    Each channel has its values from 0 s on, one each `every` seconds, and the colour and dash of its line.
    """
    face, names = asked.get("face"), asked.get("channels")
    parts = next((each.parts for each in job.score.faces if each.name == face), ())
    known = isinstance(face, str) and face in job.performance.faces and isinstance(names, list)
    wanted = [name for name in channels_of(parts) if name in names] if known and isinstance(names, list) else []
    every = max(EVERY, job.score.duration * len(wanted) / MOST)
    values = _sampled(job.performance, face, wanted, every) if isinstance(face, str) and wanted else np.empty((0, 0))
    told = [_curve(name, number, row, every) for number, (name, row) in enumerate(zip(wanted, values, strict=True))]
    return text("curves", version=version, face=face if known else None, channels=told)


def _sampled(performance: Performance, face: str, names: list[str], every: float) -> NDArray[np.float64]:
    """The channels side by side: array[channel, moment]."""
    columns = [INDEX[name] for name in names]
    times = np.arange(int(performance.duration / every + 1e-9) + 1, dtype=np.float64) * every
    values = np.empty((len(columns), len(times)))
    for first in range(0, len(times), CHUNK):
        part = slice(first, first + CHUNK)
        values[:, part] = performance.faces[face].sample(times[part])[:, columns].T
    return values


def _curve(name: str, number: int, values: NDArray[np.float64], every: float) -> Message:
    unit = POSE[INDEX[name]].unit
    rounded = values.round(DECIMALS[unit])
    colour, dash = look(number)
    return {
        "name": name,
        "unit": unit,
        "least": float(rounded.min()),
        "most": float(rounded.max()),
        "every": every,
        "colour": colour,
        "dash": dash,
        "values": rounded.tolist(),
    }
