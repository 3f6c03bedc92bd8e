"""Rectangles of whole pixels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Kind = TypeVar("Kind", bound=np.generic)


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


NOWHERE = Box(0, 0, 0, 0)
