"""A picture to the faces that OpenCV's cascade of Haar features finds in it, at half size (Viola and Jones 2001)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import cv2

from facescript.live.seeing.faces import Picture, distinct
from facescript.live.seeing.geometry import FACE, Box

MODEL = "haarcascade_frontalface_alt2.xml"
LEAST = 20
"""Pixels of the smallest face it knows, at half size."""

STEP, NEIGHBOURS = 1.15, 3
"""Each size that is tried is so many times the one before; so many windows beside each other must agree."""

AROUND, SMALLER, LARGER = 1.9, 0.75, 1.35
"""Where a face is expected, the window is so many times its frame, and its size between these parts of it."""


class Cascade:
    """A cascade of OpenCV 4, which comes with its data. Raises `OSError` where the data is not there."""

    width = FACE

    def __init__(self) -> None:
        folder = getattr(getattr(cv2, "data", None), "haarcascades", "")
        path = Path(folder) / MODEL
        if not folder or not path.is_file():
            raise OSError(f"this OpenCV ({cv2.__version__}) has no {MODEL}; version 4 has it")
        cv2.setNumThreads(1)  # the other cores are for the frames
        self._cascade: Any = cv2.CascadeClassifier(str(path))

    def faces(self, picture: Picture, near: Sequence[Box] | None = None) -> list[Box]:
        """The frames of the faces, pixels of the whole picture; with `near` only around these frames."""
        half = cv2.resize(picture, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
        grey = cv2.cvtColor(half, cv2.COLOR_BGR2GRAY)
        if near is None:
            return distinct(self._found(grey, 0, 0, LEAST, min(grey.shape)))
        return distinct(box for expected in near for box in self._around(grey, expected))

    def _around(self, grey: Any, expected: Box) -> list[Box]:
        high, wide = grey.shape
        (x, y), side = expected.middle, expected.width / 2
        reach = side * AROUND / 2
        left, right = max(0, int(x / 2 - reach)), min(wide, int(x / 2 + reach))
        top, bottom = max(0, int(y / 2 - reach)), min(high, int(y / 2 + reach))
        if right - left < LEAST or bottom - top < LEAST:
            return []
        return self._found(grey[top:bottom, left:right], left, top, int(side * SMALLER), int(side * LARGER))

    def _found(self, grey: Any, left: int, top: int, least: int, most: int) -> list[Box]:
        """The frames in a part of the half picture whose corner is there; faces of `least` to `most` pixels."""
        least = max(LEAST, least)
        found = self._cascade.detectMultiScale(
            grey, STEP, NEIGHBOURS, minSize=(least, least), maxSize=(max(most, least), max(most, least))
        )
        return [Box(2.0 * (left + int(x)), 2.0 * (top + int(y)), 2.0 * int(w), 2.0 * int(h)) for x, y, w, h in found]
