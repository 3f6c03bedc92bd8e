"""Colours of a screen to those of video: luma and two colour differences (BT.709, limited range) in one pixel.

The step is affine, and so are gradients and opacity: a picture drawn in video's colours is the picture drawn in the
screen's and changed over after, but for roundings.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from facescript.rig.picture import Paint

Pixels = NDArray[np.uint32]

LUMA = (47, 157, 16)
"""R, G, B in 1/256 for Y' of 16..235 (ITU-R BT.709, limited range)."""

BLUE = (-26, -86, 112)
RED = (112, -102, -10)
"""R, G, B in 1/256 for Cb and Cr of 16..240 around 128; each sums to 0, so greys have no colour."""

ALPHA = np.uint32(0xFF000000)

ROWS = 64
"""Rows changed over at once: what lies between stays small."""


def video_pixels(pixels: Pixels) -> Pixels:
    """Opaque pixels 0xFFRRGGBB, array[y, x], to 0xFF, Cr, Y', Cb: luma in the middle, where green is."""
    found = np.empty_like(pixels)
    for top in range(0, len(pixels), ROWS):
        band = pixels[top : top + ROWS]
        parts = [(band >> np.uint32(shift) & np.uint32(0xFF)).view(np.int32) for shift in (16, 8, 0)]
        luma, blue, red = _mixed(parts, LUMA, 16), _mixed(parts, BLUE, 128), _mixed(parts, RED, 128)
        found[top : top + ROWS] = ALPHA | red << np.uint32(16) | luma << np.uint32(8) | blue
    return found


def video_paint(paint: Paint) -> Paint:
    """A fill whose colours are video's, written as `#` Cr, Y', Cb."""
    if isinstance(paint, str):
        return _video_colour(paint)
    return replace(paint, stops=tuple(replace(stop, colour=_video_colour(stop.colour)) for stop in paint.stops))


def _video_colour(text: str) -> str:
    pixel = video_pixels(np.array([[int(text[1:7], 16)]], dtype=np.uint32) | ALPHA)
    return f"#{int(pixel[0, 0] & ~ALPHA):06x}"


def _mixed(parts: list[NDArray[np.int32]], weights: tuple[int, int, int], middle: int) -> Pixels:
    """The weighted sum of red, green and blue around `middle`, rounded."""
    mixed = np.full_like(parts[0], middle * 256 + 128)
    for part, weight in zip(parts, weights, strict=True):
        mixed += part * np.int32(weight)
    mixed >>= 8
    return mixed.view(np.uint32)
