"""Pixels to the three planes that video encoders take: luma, and chroma at half the resolution (yuv420p, BT.709)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.canvas.box import Box

TILE = 65536
"""Pixels converted at once: the steps between stay in the processor's own cache."""

LUMA = (47, 157, 16)
"""R, G, B in 1/256 for Y' of 16..235 (ITU-R BT.709, limited range)."""

BLUE = (-26, -86, 112)
RED = (112, -102, -10)
"""R, G, B in 1/256 for Cb and Cr of 16..240 around 128; each sums to 0, so greys have no colour."""

EVEN = np.uint32(0x00FF00FF)


class Planes:
    """The planes of one size (both sides even), kept from frame to frame: only what changed is converted."""

    def __init__(self, width: int, height: int) -> None:
        luma, chroma = width * height, width * height // 4
        self.data = np.zeros(luma + 2 * chroma, dtype=np.uint8)
        self._luma = self.data[:luma].reshape(height, width)
        half = height // 2, width // 2
        self._blue = self.data[luma : luma + chroma].reshape(half)
        self._red = self.data[luma + chroma :].reshape(half)

    def take(self, pixels: NDArray[np.uint32], box: Box) -> None:
        """Bring the planes up to date with `pixels`, array[y, x] of 0xAARRGGBB, where they changed."""
        box = box.even()
        width = box.right - box.left
        rows = max(2, TILE // max(width, 1) // 2 * 2)
        for top in range(box.top, box.bottom, rows):
            self._convert(pixels, Box(box.left, top, box.right, min(top + rows, box.bottom)))

    def _convert(self, pixels: NDArray[np.uint32], box: Box) -> None:
        tile = box.of(pixels)
        red_blue, green = tile & EVEN, tile >> np.uint32(8) & np.uint32(0xFF)
        half = slice(box.top // 2, box.bottom // 2), slice(box.left // 2, box.right // 2)
        self._blue[half], self._red[half] = _chroma(_summed(red_blue), _summed(green))
        box.of(self._luma)[...] = _luma(red_blue, green)


def _luma(red_blue: NDArray[np.uint32], green: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Y' of pixels; overwrites what it is given. Red and blue stand 16 bits apart in one number: multiplied by
    LUMA's blue << 16 | red, the upper half of the product is their weighted sum, the lower has no carry."""
    red_blue *= np.uint32(LUMA[2] << 16 | LUMA[0])
    red_blue >>= np.uint32(16)
    green *= np.uint32(LUMA[1])
    red_blue += green
    red_blue += np.uint32(16 * 256 + 128)
    red_blue >>= np.uint32(8)
    return red_blue


def _chroma(red_blue: NDArray[np.uint32], green: NDArray[np.uint32]) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    """Cb and Cr of sums over four pixels."""
    red = (red_blue >> np.uint32(16)).view(np.int32)
    blue = (red_blue & np.uint32(0xFFFF)).view(np.int32)
    middle = np.int32(128 * 1024 + 512)
    parts = red, green.view(np.int32), blue
    both = []
    for weights in (BLUE, RED):
        mixed = parts[0] * np.int32(weights[0])
        for part, weight in zip(parts[1:], weights[1:], strict=True):
            mixed += part * np.int32(weight)
        mixed += middle
        mixed >>= 10
        both.append(mixed)
    return both[0], both[1]


def _summed(values: NDArray[np.uint32]) -> NDArray[np.uint32]:
    """Sums over squares of two by two. Neighbours are added as the halves of one number of 64 bits."""
    pairs = (values[0::2] + values[1::2]).view(np.uint64)
    pairs += pairs >> np.uint64(32)
    return pairs.astype(np.uint32)
