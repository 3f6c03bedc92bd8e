"""Grounds to pixels: each layer is painted once, and the mix of layers is kept while it stays the same."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from facescript.canvas.thorvg import Canvas, Outline
from facescript.pictures import PictureFailure
from facescript.rig.picture import Paint
from facescript.stage.ground import Backdrop, Clear, Ground, Layer, Photo
from facescript.stage.photo import photo
from facescript.world import WorldFailure

Pixels = NDArray[np.uint32]

CLEAR, WHITE = 0x00000000, 0xFFFFFFFF
"""What shows where nothing is behind the faces: nothing, or for outputs that cannot be transparent white."""

KEPT = 4
"""Painted layers kept: those of a change, and as many that may come back."""


class Backcloth:
    """Paints grounds of one size. The same ground gives the same array, which must not be changed.

    `under` is the pixel of a ground that is nothing; each layer is painted in the screen's colours and then `finished`.
    """

    def __init__(
        self,
        width: int,
        height: int,
        pictures: Callable[[str], bytes],
        under: int = CLEAR,
        finished: Callable[[Pixels], Pixels] = lambda pixels: pixels,
    ) -> None:
        self._width, self._height = width, height
        self._under = under
        self._finished = finished
        self._pictures = pictures
        self._layer = lru_cache(KEPT)(lambda layer: self._finished(self._painted(layer)))
        self._last: tuple[Ground, Pixels] | None = None

    def paint(self, ground: Ground) -> Pixels:
        """array[y, x] of 0xAARRGGBB, premultiplied. Raises `PictureFailure` where a picture cannot be used."""
        if self._last is None or self._last[0] != ground:
            self._last = ground, self._mixed(ground)
        return self._last[1]

    def _mixed(self, ground: Ground) -> Pixels:
        mixed = self._layer(ground[0][0])
        for layer, share in ground[1:]:
            mixed = _blend(mixed, self._layer(layer), share)
        return mixed

    def _painted(self, layer: Layer) -> Pixels:
        if isinstance(layer, Photo):
            return self._photo(layer.path)
        if isinstance(layer, Clear):
            return np.full((self._height, self._width), self._under, dtype=np.uint32)
        return self._filled(layer.paint if isinstance(layer, Backdrop) else layer)

    def _photo(self, path: str) -> Pixels:
        try:
            return photo(self._pictures(path), self._width, self._height)
        except (WorldFailure, PictureFailure) as fault:
            raise PictureFailure(f"the picture `{path}` cannot be used: {fault.args[0]}") from None

    def _filled(self, paint: Paint) -> Pixels:
        pixels = np.full((self._height, self._width), 0xFFFFFFFF, dtype=np.uint32)
        right, bottom = float(self._width), float(self._height)
        corners = np.array([(0, 0), (right, 0), (right, bottom), (0, bottom)], dtype=np.float32)
        around = np.ascontiguousarray(np.repeat(np.concatenate([corners, corners[:1]]), 3, axis=0)[1:-1])
        outline = Outline([len(around)], paint)
        outline.shape(around.ctypes.data)
        Canvas(pixels, [outline]).draw()
        return pixels


def _blend(below: Pixels, above: Pixels, share: float) -> Pixels:
    """Each channel `share` (0..1) of the way from below to above, in steps of 1/256."""
    weight = np.uint32(round(256 * share))
    mask = np.uint32(0x00FF00FF)
    mixed = np.zeros_like(below)
    for shift in (np.uint32(0), np.uint32(8)):
        low, high = below >> shift & mask, above >> shift & mask
        mixed |= (low * (np.uint32(256) - weight) + high * weight >> np.uint32(8) & mask) << shift
    return mixed
