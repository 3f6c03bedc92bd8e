"""Pixels of video's colours to the planes that encoders take: luma, and chroma at half the resolution (yuv420p)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.canvas.box import Box

TILE = 32768
"""Pixels taken at once: the steps between stay in the processor's own cache."""

CHROMA = np.uint32(0x00FF00FF)
"""Where a pixel has Cr and Cb."""

HALVES = np.uint64(0x00020002)
"""Half of four, for both."""


class Planes:
    """The planes of one size (both sides even), kept from frame to frame: only what changed is taken."""

    def __init__(self, width: int, height: int) -> None:
        luma, chroma = width * height, width * height // 4
        self.data = np.zeros(luma + 2 * chroma, dtype=np.uint8)
        self._luma = self.data[:luma].reshape(height, width)
        half = height // 2, width // 2
        self._blue = self.data[luma : luma + chroma].reshape(half)
        self._red = self.data[luma + chroma :].reshape(half)

    def take(self, pixels: NDArray[np.uint32], box: Box) -> None:
        """Bring the planes up to date with `pixels`, array[y, x] of `canvas.video`, where they changed."""
        box = box.even()
        width = box.right - box.left
        rows = max(2, TILE // max(width, 1) // 2 * 2)
        for top in range(box.top, box.bottom, rows):
            self._split(pixels, Box(box.left, top, box.right, min(top + rows, box.bottom)))

    def _split(self, pixels: NDArray[np.uint32], box: Box) -> None:
        tile = box.of(pixels)
        np.right_shift(tile, 8, out=box.of(self._luma), casting="unsafe")
        means = _means(tile).view(np.uint8)
        half = Box(box.left // 2, box.top // 2, box.right // 2, box.bottom // 2)
        half.of(self._blue)[...] = means[:, 0::8]
        half.of(self._red)[...] = means[:, 2::8]


def _means(tile: NDArray[np.uint32]) -> NDArray[np.uint64]:
    """The mean Cb and Cr of squares of two by two, in the bytes 0 and 2. Neighbours are added as the halves of one
    number of 64 bits; no sum of four reaches the next field."""
    sums = tile[0::2] & CHROMA
    sums += tile[1::2] & CHROMA
    pairs = sums.view(np.uint64)
    pairs = pairs + (pairs >> np.uint64(32))
    pairs += HALVES
    pairs >>= np.uint64(2)
    return pairs
