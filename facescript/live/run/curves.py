"""The motions of one face, each from an event on, to its poses at any later time."""

from __future__ import annotations

from math import inf, nextafter

import numpy as np

from facescript.live.run.seams import Seam, asked_of, flat, seam
from facescript.motion.compose import compose
from facescript.motion.drivers import Floats
from facescript.motion.perform import FaceMotion
from facescript.performance.performance import Frames


class FaceCurves:
    """One face of a run: its motion as of now, and the seams to those before it. Scenes are gone over into, too: a face
    that somebody stands before does not jump where a film is cut."""

    def __init__(self, motion: FaceMotion) -> None:
        self.motion = motion
        self._seams: list[Seam] = []
        self._joined = 0.0
        self._left: tuple[float, Floats] | None = None

    def turn(self, time: float, motion: FaceMotion) -> None:
        """Move by another motion from `time` (s) on; nothing before it is asked for any more."""
        before = nextafter(time, -inf)
        self._go_over(np.empty(0))
        self._seams = [one for one in self._seams if one.time < time < one.end]
        self._join_scenes(before)
        self._left = time, self._values(np.array([before]))[:, 0]
        self.motion, self._joined = motion, before

    def sample(self, times: Floats) -> Frames:
        """Poses at `times` (s, sorted, not before the last turn): array[n, channel]."""
        values = self._go_over(times)
        self._join_scenes(float(times[-1]))
        for one in self._seams:
            one.onto(values, times)
        return compose(asked_of(values))

    def _go_over(self, times: Floats) -> Floats:
        """What the motion asks at `times`, array[value, time], and by the way how far it is from the one before it."""
        if self._left is None:
            return self._values(times) if len(times) else np.empty((0, 0))
        (time, left), self._left = self._left, None
        values = self._values(np.concatenate([[nextafter(time, -inf)], times]))
        self._join(time, left, values[:, 0])
        return np.ascontiguousarray(values[:, 1:])

    def _values(self, times: Floats) -> Floats:
        return flat(self.motion.asked(times))

    def _join_scenes(self, until: float) -> None:
        """Go over into the scenes that begin up to a time."""
        for start in self.motion.gaze.starts.tolist():
            if self._joined < start <= until:
                before, after = self._values(np.array([nextafter(start, -inf), start])).T
                self._join(start, before, after)
        self._joined = max(self._joined, until)

    def _join(self, time: float, before: Floats, after: Floats) -> None:
        found = seam(time, before, after)
        if found is not None:
            self._seams.append(found)
