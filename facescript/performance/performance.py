"""A performance: every channel of every face as a pure function of time."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import CHANNELS, NAMES

Frames = NDArray[np.float64]
"""Poses of one face: array[frame, channel], channels in the order of `performance.channels.NAMES`."""


class FaceCurves(Protocol):
    """One face's channels over time."""

    def sample(self, times: NDArray[np.float64]) -> Frames:
        """Poses at `times` (seconds, any order): array[len(times), len(NAMES)]."""
        ...


class Performance:
    """The curves of all seen faces of a score.

    `duration` is in seconds. `sample` and `pose` have no state: any order, any rate, any chunk gives the same.
    """

    def __init__(self, faces: dict[str, FaceCurves], duration: float) -> None:
        self.faces = faces
        self.duration = duration

    @property
    def names(self) -> tuple[str, ...]:
        """Channel names of all faces; with several faces each carries its face's name in front."""
        if len(self.faces) == 1:
            return NAMES
        return tuple(f"{face}.{name}" for face in self.faces for name in NAMES)

    def sample_face(self, face: str, times: NDArray[np.float64]) -> Frames:
        return self.faces[face].sample(np.asarray(times, dtype=np.float64))

    def sample(self, times: NDArray[np.float64]) -> Frames:
        """All faces side by side: array[frame, len(self.names)]."""
        if not self.faces:
            return np.zeros((len(times), 0))
        return np.concatenate([self.sample_face(face, times) for face in self.faces], axis=1)

    def pose(self, time: float) -> dict[str, float]:
        """All channels at one moment by name."""
        row = self.sample(np.array([time]))[0]
        return dict(zip(self.names, row.tolist(), strict=True))


REST: Frames = np.array([channel.rest for channel in CHANNELS])
"""The rest pose: array[channel]."""
