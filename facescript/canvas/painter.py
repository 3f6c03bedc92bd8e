"""Points and opacities of a frame to its pixels, drawing anew only what changed since the frame before."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.canvas.box import Box
from facescript.canvas.outlines import Outlines
from facescript.canvas.thorvg import Canvas
from facescript.rig.picture import Shape

Floats = NDArray[np.float64]
Pixels = NDArray[np.uint32]
"""array[y, x] of 0xAARRGGBB, premultiplied; as bytes on a little-endian machine B, G, R, A."""


class Painter:
    """Draws frames of one list of shapes. A frame's pixels depend on its arguments alone, whatever was drawn before.

    The leading shapes that no channel moves are drawn once onto a copy of the ground; the others are drawn over it.
    """

    def __init__(self, width: int, height: int, shapes: Sequence[Shape]) -> None:
        self.pixels: Pixels = np.zeros((height, width), dtype=np.uint32)
        self._base = np.zeros_like(self.pixels)
        self._ground: Pixels | None = None
        self._whole = Box(0, 0, width, height)
        self._drawn: tuple[Box, ...] = ()
        self._outlines = Outlines(shapes)
        self._still = next((place for place, shape in enumerate(shapes) if shape.moving), len(shapes))
        paints = self._outlines.paints()
        self._under = Canvas(self._base, [paint for members, paint in paints if members.start < self._still])
        self._over = Canvas(self.pixels, [paint for members, paint in paints if members.start >= self._still])

    def draw(self, points: Floats, opacity: Floats, ground: Pixels, turns: Floats | float = 0.0) -> tuple[Box, ...]:
        """Draw a frame into `pixels`: points array[point, 2] in px, opacity array[shape], over `ground` (same size).

        Gradients lie in the boxes of outlines in frames that are turned clockwise by `turns` array[shape], radians.
        Gives the boxes outside which `pixels` are as they were before. A ground must not be changed once given.
        """
        touched = self._outlines.take(points, opacity, np.broadcast_to(turns, opacity.shape))
        if ground is not self._ground or touched[: self._still].any():
            return self._draw_all(ground)
        if not touched.any():
            return ()
        boxes = self._outlines.touched_boxes(touched, self._whole)
        self._draw_over(self._drawn)
        return boxes

    def _draw_all(self, ground: Pixels) -> tuple[Box, ...]:
        self._ground = ground
        self._base[...] = ground
        self._under.draw()
        self._draw_over((self._whole,))
        return (self._whole,)

    def _draw_over(self, spoilt: tuple[Box, ...]) -> None:
        """Draw the upper shapes where only the base shows, once it is back in the spoilt boxes."""
        for box in spoilt:
            box.of(self.pixels)[...] = box.of(self._base)
        self._over.draw()
        self._drawn = self._outlines.seen_boxes(self._still, self._whole)
