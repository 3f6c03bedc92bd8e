"""Premultiplied pixels to straight ones, for files whose colours are not multiplied by their opacity.

All pixels are array[y, x] of 0xAARRGGBB.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from facescript.canvas.box import Box
from facescript.canvas.planes import Planes
from facescript.canvas.video import video_pixels

Pixels = NDArray[np.uint32]

ALPHA = np.uint32(0xFF000000)

HALF = 128
"""From this opacity on a pixel stays where a file has no opacities between."""

FAINT = 16
"""Below this opacity eight bits of a premultiplied colour say little of its hue."""

COARSER = 4
"""How many pixels in a row become one where colours are carried into what is clear."""


def straight(pixels: Pixels) -> Pixels:
    """The same with every colour whole, as it is before its opacity dims it; clear pixels stay 0."""
    found = pixels.copy()
    partly = (pixels < ALPHA) & (pixels > np.uint32(0x00FFFFFF))
    edge = pixels[partly]
    alpha = edge >> np.uint32(24)
    whole = edge & ALPHA
    for shift in (np.uint32(0), np.uint32(8), np.uint32(16)):
        channel = (edge >> shift & np.uint32(0xFF)) * np.uint32(255)
        whole |= np.minimum((channel + alpha // 2) // alpha, np.uint32(255)) << shift
    found[partly] = whole
    return found


def cut_out(pixels: Pixels) -> Pixels:
    """Straight pixels that are opaque or clear, by the nearer of both."""
    kept = pixels >> np.uint32(24) >= HALF
    return np.where(kept, straight(pixels) | ALPHA, np.uint32(0))


def bled(pixels: Pixels) -> Pixels:
    """Opaque pixels: each has its straight colour, and where it is clear or faint the colours around it, smoothly.

    Video encodes colours at half the resolution and with loss: an edge takes on some of what is beside it, which
    therefore must look like the edge.
    """
    height, width = pixels.shape
    image = Image.frombuffer("RGBa", (width, height), pixels.tobytes(), "raw", "RGBa", 0, 1)
    around = np.asarray(_spread(image).convert("RGBX")).view("<u4")[..., 0]
    faint = pixels >> np.uint32(24) < FAINT
    return np.where(faint, around, straight(pixels)) | ALPHA


def _spread(image: Image.Image) -> Image.Image:
    """Colours for every pixel, those of the picture made ever coarser until it has one there; of equal size, RGB."""
    if image.size == (1, 1):
        return _colours(image)
    small = image.reduce(COARSER)
    base = _spread(small)
    base.paste(_colours(small), mask=small.getchannel("a").point(_enough))
    return base.resize(image.size, Image.Resampling.BILINEAR)


def _colours(image: Image.Image) -> Image.Image:
    return image.convert("RGBA").convert("RGB")


def _enough(alpha: int) -> int:
    """Whether a colour of this opacity is told finely enough, as a mask."""
    return 255 if alpha >= FAINT else 0


class ClearPlanes:
    """The planes of one size (both sides even) with opacity: yuva420p, straight, in one array that stays the same."""

    def __init__(self, width: int, height: int) -> None:
        self._whole = Box(0, 0, width, height)
        self._colours = Planes(width, height)
        self.data = np.zeros(width * height * 5 // 2, dtype=np.uint8)

    def take(self, pixels: Pixels) -> None:
        """Bring the planes up to date with premultiplied pixels."""
        self._colours.take(video_pixels(bled(pixels)), self._whole)
        colours = len(self._colours.data)
        self.data[:colours] = self._colours.data
        self.data[colours:] = (pixels >> np.uint32(24)).ravel()
