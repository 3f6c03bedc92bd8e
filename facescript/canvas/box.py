"""Rectangles of whole pixels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Kind = TypeVar("Kind", bound=np.generic)


BAND = 64
"""Rows; even, as boxes begin at even rows where chroma is at half the resolution."""


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle of whole pixels, half open; false where it is empty."""

    left: int
    top: int
    right: int
    bottom: int

    def __bool__(self) -> bool:
        return self.left < self.right and self.top < self.bottom

    def __and__(self, other: Box) -> Box:
        """What lies in both."""
        left, top = max(self.left, other.left), max(self.top, other.top)
        right, bottom = min(self.right, other.right), min(self.bottom, other.bottom)
        return Box(left, top, max(left, right), max(top, bottom))

    def of(self, pixels: NDArray[Kind]) -> NDArray[Kind]:
        """The part of an image array[y, x] inside the box."""
        return pixels[self.top : self.bottom, self.left : self.right]

    def even(self) -> Box:
        """The smallest box around it with even sides, for chroma at half the resolution."""
        return Box(self.left & ~1, self.top & ~1, self.right + 1 & ~1, self.bottom + 1 & ~1)


def bands(low: NDArray[np.float32], high: NDArray[np.float32], whole: Box) -> tuple[Box, ...]:
    """Boxes of whole pixels, BAND rows high, one under the other, that hold all pixels of `whole` which outlines with
    these corners, array[outline, 2], can touch."""
    left, top = np.floor(low).astype(np.int64).T - 1
    right, bottom = np.ceil(high).astype(np.int64).T + 1
    first, last = max(whole.top, int(top.min(initial=whole.bottom))), min(whole.bottom, int(bottom.max(initial=0)))
    starts = np.arange(first, last, BAND)
    ends = np.minimum(starts + BAND, last)
    inside = (top < ends[:, None]) & (bottom > starts[:, None])
    lefts = np.where(inside, left, whole.right).min(axis=1, initial=whole.right)
    rights = np.where(inside, right, whole.left).max(axis=1, initial=whole.left)
    across = zip(lefts.tolist(), starts.tolist(), rights.tolist(), ends.tolist(), strict=True)
    found = (Box(*sides) & whole for sides in across)
    return tuple(box for box in found if box)
