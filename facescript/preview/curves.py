"""Channels of a face to the curves that the preview's timeline draws."""

from __future__ import annotations

from collections.abc import Iterable
from math import floor

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import INDEX, POSE, channels_of
from facescript.performance.performance import Performance
from facescript.plot.looks import look
from facescript.schedule.score import Score

EVERY = 0.01
"""Seconds from one value to the next: a saccade of 20 ms has two."""

MOST = 60_000
"""Values of a curve: from ten minutes on they stand wider apart."""

CHUNK = 8192
"""Values taken at once."""

DECIMALS = {"deg": 2, "cm": 2, "1": 3}


def curves(score: Score, performance: Performance, face: str, names: Iterable[str]) -> dict[str, object] | None:
    """What the message `curves` says but for its version: of each channel that the face has its values from 0 s on,
    one each `every` seconds, the least and the greatest of them, and how it is drawn. None for no seen face."""
    parts = next((each.parts for each in score.faces if each.name == face), None)
    if parts is None or face not in performance.faces:
        return None
    has = channels_of(parts)
    found = [name for name in dict.fromkeys(names) if name in has]
    every = max(EVERY, score.duration / MOST)
    values = _sampled(performance, face, found, every)
    channels = [_curve(name, number, row, every) for number, (name, row) in enumerate(zip(found, values, strict=True))]
    return {"face": face, "channels": channels}


def _sampled(performance: Performance, face: str, names: list[str], every: float) -> NDArray[np.float64]:
    """The channels side by side: array[channel, moment]."""
    columns = [INDEX[name] for name in names]
    times = np.arange(floor(performance.duration / every + 1e-9) + 1, dtype=np.float64) * every
    values = np.empty((len(columns), len(times)))
    for first in range(0, len(times) if columns else 0, CHUNK):
        part = slice(first, first + CHUNK)
        values[:, part] = performance.faces[face].sample(times[part])[:, columns].T
    return values


def _curve(name: str, number: int, values: NDArray[np.float64], every: float) -> dict[str, object]:
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
