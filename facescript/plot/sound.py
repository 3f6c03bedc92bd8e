"""The lines of a face to how loud they are in each column of pixels."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.plot.axis import Scale
from facescript.schedule.score import TimedLine

WINDOW = 0.01
"""Seconds over which sound is measured: about two swings of a low voice."""


def energy(lines: Sequence[TimedLine], scale: Scale) -> NDArray[np.float64]:
    """How loud a face is, array[column]: the greatest root mean square over 10 ms, 1 at the loudest of the stretch."""
    loud = np.zeros(scale.columns)
    for line in lines:
        if scale.shows(line.start, line.end):
            _lay(loud, line, scale)
    most = loud.max()
    return loud / most if most > 0 else loud


def _lay(loud: NDArray[np.float64], line: TimedLine, scale: Scale) -> None:
    step = max(1, round(WINDOW * line.spoken.rate))
    sound = np.frombuffer(line.spoken.pcm, dtype="<i2")[: round((line.end - line.start) * line.spoken.rate)]
    windows = sound[: len(sound) // step * step].reshape(-1, step).astype(np.float64)
    levels = np.sqrt((windows**2).mean(axis=1)) * line.volume
    middles = line.start + (np.arange(len(levels)) + 0.5) * step / line.spoken.rate
    if not len(levels):
        return
    edges = scale.start + (scale.end - scale.start) * np.arange(len(loud) + 1) / len(loud)
    within = (middles >= edges[0]) & (middles < edges[-1])
    np.maximum.at(loud, np.searchsorted(edges, middles[within], side="right") - 1, levels[within])
    # Where a column is shorter than a window, sound goes on from one to the next.
    inside = (edges[:-1] >= line.start) & (edges[1:] <= line.end)
    between = np.interp((edges[:-1] + edges[1:]) / 2, middles, levels)
    loud[inside] = np.maximum(loud[inside], between[inside])
