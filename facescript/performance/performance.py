"""A performance: every channel of every face as a pure function of time."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import HAIR, INDEX, NAMES, POSE, Channel

Frames = NDArray[np.float64]
"""Poses of one face: array[frame, channel], columns in the order of `performance.channels.POSE`."""

NOTHING: Mapping[str, Any] = MappingProxyType({})


class FaceCurves(Protocol):
    """One face's channels over time."""

    def sample(self, times: NDArray[np.float64]) -> Frames:
        """Poses at `times` (seconds, any order): array[len(times), len(POSE)]."""
        ...


class HairCurves(Protocol):
    """How one face's hair trails behind its head over time."""

    def sample(self, times: NDArray[np.float64]) -> NDArray[np.float64]:
        """The channels `HAIR` at `times` (seconds, any order): array[len(times), len(HAIR)], deg."""
        ...


class Performance:
    """The curves of all seen faces of a score.

    `duration` is in seconds, `channels` the names of those that each face has (else those of every face), `hair` the
    hair that moves. `sample` and `pose` have no state: any order, any rate, any chunk gives the same.
    """

    def __init__(
        self,
        faces: dict[str, FaceCurves],
        duration: float,
        channels: Mapping[str, tuple[str, ...]] = NOTHING,
        hair: Mapping[str, HairCurves] = NOTHING,
    ) -> None:
        self.faces = faces
        self.duration = duration
        self._has = {face: channels.get(face, NAMES) for face in faces}
        self._hair = hair

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the channels that the faces have; with several faces each carries its face's name in front."""
        if len(self.faces) == 1:
            return next(iter(self._has.values()))
        return tuple(f"{face}.{name}" for face, names in self._has.items() for name in names)

    @property
    def channels(self) -> tuple[Channel, ...]:
        """The channels of `names`."""
        return tuple(POSE[INDEX[name]] for names in self._has.values() for name in names)

    @property
    def columns(self) -> dict[str, slice | list[int]]:
        """Where the channels that each face has stand in its poses."""
        return {face: _columns(names) for face, names in self._has.items()}

    def sample_face(self, face: str, times: NDArray[np.float64]) -> Frames:
        """One face as it is drawn, its hair too: array[frame, channel]."""
        times = np.asarray(times, dtype=np.float64)
        poses = self.faces[face].sample(times)
        if face in self._hair:
            poses[:, -len(HAIR) :] = self._hair[face].sample(times)
        return poses

    def sample(self, times: NDArray[np.float64]) -> Frames:
        """The channels of all faces side by side: array[frame, len(self.names)]."""
        times = np.asarray(times, dtype=np.float64)
        found = [self.faces[face].sample(times)[:, columns] for face, columns in self.columns.items()]
        return np.concatenate(found, axis=1) if found else np.zeros((len(times), 0))

    def pose(self, time: float) -> dict[str, float]:
        """All channels at one moment by name."""
        row = self.sample(np.array([time]))[0]
        return dict(zip(self.names, row.tolist(), strict=True))


def _columns(names: tuple[str, ...]) -> slice | list[int]:
    """The columns of a pose: a slice where they are its first, which copies nothing."""
    found = [INDEX[name] for name in names]
    return slice(len(found)) if found == list(range(len(found))) else found


REST: Frames = np.array([channel.rest for channel in POSE])
"""The rest pose: array[channel]."""
