"""A whole recording and its text to about when each sentence is said: the voice warped onto it, coarsely."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.speech.align.activity import Stretch
from facescript.speech.align.features import Floats, with_change
from facescript.speech.align.reference import HOP, Reference
from facescript.speech.align.warp import Indices, warp

COARSE = 4
"""Frames that one coarse frame stands for."""

KEPT = 0.12
"""Seconds of quiet kept around speech: of a long pause no more counts, however long it is."""

REACH = 400
"""Coarse frames (16 s) that a speaker may be ahead of the best way so far, or behind."""


@dataclass(frozen=True, slots=True)
class Course:
    """`frames` are those of the recording that were compared, `places` the voice's frame for each, never backwards."""

    frames: Indices
    places: NDArray[np.float64]

    def moment(self, place: float) -> float:
        """Seconds of the recording at which a frame of the voice is heard."""
        return float(self.frames[min(int(np.searchsorted(self.places, place)), len(self.frames) - 1)]) * HOP

    def between(self, first: int, count: int) -> NDArray[np.float64]:
        """The voice's frame for each of `count` frames of the recording from `first` on."""
        return np.interp(np.arange(first, first + count), self.frames, self.places)


def course(bands: Floats, spoken: Sequence[Stretch], references: Sequence[Reference]) -> Course:
    """The way of a recording, `bands` frame by frame and `spoken` where there is speech, through the references."""
    frames = _kept(len(bands), spoken)
    voice = np.concatenate([each.bands for each in references])
    way = warp(_coarse(bands[frames]), _coarse(voice)[None], REACH)[0].path
    middles = np.minimum((np.arange(len(way)) + 0.5) * COARSE, len(frames) - 1)
    places = np.interp(np.arange(len(frames)), middles, (way + 0.5) * COARSE)
    return Course(frames, places)


def _kept(count: int, spoken: Sequence[Stretch]) -> Indices:
    """The frames of speech and a little around it."""
    kept = np.zeros(count, np.bool_)
    for each in spoken:
        kept[max(round((each.start - KEPT) / HOP), 0) : round((each.end + KEPT) / HOP) + 1] = True
    return np.flatnonzero(kept)


def _coarse(bands: Floats) -> Floats:
    """Means of `COARSE` frames each, as they are compared."""
    starts = np.arange(0, len(bands), COARSE)
    sums = np.add.reduceat(bands, starts, axis=0)
    counts = np.diff(np.append(starts, len(bands))).astype(np.float32)
    means: Floats = (sums / counts[:, None]).astype(np.float32)
    return with_change(means, 1)
