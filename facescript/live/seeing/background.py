"""Pictures to whether somebody is there, face or not: what differs from a background that is learnt on the way.

After the patent family's images (US 09/020,035 and 09/019,549): a picture is compared with a background, and the
background slowly becomes what is seen, where something moves more slowly.
"""

from __future__ import annotations

from math import exp

import numpy as np
from numpy.typing import NDArray

from facescript.live.seeing.faces import Picture

GRAIN = 80
"""Points of the picture's width that are compared."""

DIFFERS = 22.0
"""Grey levels of 255 by which a point differs that is not background."""

SHARE = 0.015
"""Somebody is there where so much of the picture differs: a face at 2 m takes up 1 %, a body several times that."""

QUIET, BUSY = 8.0, 60.0
"""In so many seconds a point that is background, and one that is not, becomes what is seen there."""


class Background:
    """Learns the background from pictures in the order of their times."""

    def __init__(self) -> None:
        self._known: NDArray[np.float32] | None = None
        self._time = 0.0

    def differs(self, picture: Picture, time: float) -> float:
        """The share of the picture, 0 to 1, that is not background; the first picture is all background."""
        seen = _coarse(picture)
        if self._known is None or self._known.shape != seen.shape:
            self._known, self._time = seen, time
            return 0.0
        change = seen - self._known
        change -= np.median(change)  # a camera that adapts to the light changes the whole picture at once
        strange = np.abs(change) > DIFFERS
        span = max(0.0, time - self._time)
        rate = np.where(strange, 1.0 - exp(-span / BUSY), 1.0 - exp(-span / QUIET)).astype(np.float32)
        self._known += rate * (seen - self._known)
        self._time = time
        return float(strange.mean())


def _coarse(picture: Picture) -> NDArray[np.float32]:
    """The picture about `GRAIN` points wide, array[y, x]: of its green, which has most of the light, the means of four
    places each."""
    step = max(1, picture.shape[1] // GRAIN // 2)
    green = picture[::step, ::step, 1].astype(np.float32)
    green = green[: green.shape[0] // 2 * 2, : green.shape[1] // 2 * 2]
    sums = green[::2, ::2] + green[1::2, ::2] + green[::2, 1::2] + green[1::2, 1::2]
    return sums * np.float32(0.25)
