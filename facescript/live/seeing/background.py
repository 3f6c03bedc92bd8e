"""Pictures to whether somebody is there, face or not: what differs from a background that is learnt on the way.

After the patent family's images (US 09/020,035 and 09/019,549): a picture is compared with a background, and the
background slowly becomes what is seen, where something moves more slowly.
"""

from __future__ import annotations

from math import exp

import numpy as np
from numpy.typing import NDArray

from facescript.live.seeing.faces import Picture
from facescript.live.seeing.geometry import Box

GRAIN = 80
"""Points of the picture's width that are compared."""

DIFFERS = 22.0
"""Grey levels of 255 by which a point differs that is not background."""

SHARE = 0.01
"""Somebody is there where so much of the picture differs: a drawn head and chest at 1.8 m are 1.4 %."""

BODY = (-0.25, 1.25, 0.0, 2.5)
"""Where somebody's head and chest are, from the frame of her face: left, right, top, bottom, as parts of its size."""

STANDS = 0.2
"""Somebody stands there where so much of that differs: of drawn persons 0.35 to 0.6 does."""

QUIET, BUSY = 8.0, 60.0
"""In so many seconds a point that is background, and one that is not, becomes what is seen there."""


class Background:
    """Learns the background from pictures in the order of their times."""

    def __init__(self) -> None:
        self._known: NDArray[np.float32] | None = None
        self._time = 0.0
        self._strange: NDArray[np.bool_] = np.zeros((0, 0), dtype=np.bool_)
        self._grain = 1.0

    def differs(self, picture: Picture, time: float) -> float:
        """The share of the picture, 0 to 1, that is not background; the first picture is all background."""
        seen = _coarse(picture)
        if self._known is None or self._known.shape != seen.shape:
            self._known, self._time, self._strange = seen, time, np.zeros(seen.shape, dtype=np.bool_)
            self._grain = picture.shape[1] / seen.shape[1]
            return 0.0
        change = seen - self._known
        change -= np.median(change)  # a camera that adapts to the light changes the whole picture at once
        strange = np.abs(change) > DIFFERS
        span = max(0.0, time - self._time)
        rate = np.where(strange, 1.0 - exp(-span / BUSY), 1.0 - exp(-span / QUIET)).astype(np.float32)
        self._known += rate * (seen - self._known)
        self._time, self._strange = time, strange
        return float(strange.mean())

    def stands(self, face: Box) -> bool:
        """Whether in the last picture somebody was where a face with this frame had been."""
        left, right, top, bottom = BODY
        columns = slice(self._place(face.x + left * face.width), self._place(face.x + right * face.width))
        rows = slice(self._place(face.y + top * face.height), self._place(face.y + bottom * face.height))
        part = self._strange[rows, columns]
        return bool(part.size) and float(part.mean()) > STANDS

    def _place(self, pixels: float) -> int:
        return max(0, round(pixels / self._grain))


def _coarse(picture: Picture) -> NDArray[np.float32]:
    """The picture about `GRAIN` points wide, array[y, x]: of its green, which has most of the light, the means of four
    places each."""
    step = max(1, picture.shape[1] // GRAIN // 2)
    green = picture[::step, ::step, 1].astype(np.float32)
    green = green[: green.shape[0] // 2 * 2, : green.shape[1] // 2 * 2]
    sums = green[::2, ::2] + green[1::2, ::2] + green[::2, 1::2] + green[1::2, 1::2]
    return sums * np.float32(0.25)
