"""What finds faces in a picture: the protocol of finders, and frames to those that are of different faces."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from facescript.live.seeing.geometry import Box

Picture = NDArray[np.uint8]
"""array[y, x, 3], blue first, as OpenCV has it."""

SAME = 0.35
"""Frames that overlap more are of one face."""


class Finder(Protocol):
    """Finds faces. `width` is how wide its frames are on a face, cm."""

    width: float

    def faces(self, picture: Picture, near: Sequence[Box] | None = None) -> list[Box]:
        """The frames of the faces in a picture, pixels; with `near` it may look only around these frames."""
        ...


def distinct(boxes: Iterable[Box]) -> list[Box]:
    """The frames, the largest first, without those that are of a face that a larger one has."""
    kept: list[Box] = []
    for box in sorted(boxes, key=lambda box: (-box.width * box.height, box.x, box.y)):
        if all(box.overlap(other) < SAME and not _within(box, other) for other in kept):
            kept.append(box)
    return kept


def _within(box: Box, other: Box) -> bool:
    x, y = box.middle
    inside = other.x < x < other.x + other.width and other.y < y < other.y + other.height
    return inside and box.width < other.width / 2
