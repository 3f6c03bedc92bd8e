"""Small pictures laid over the frames of a film, without a trace in the pixels that the next frame is drawn on."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from facescript.canvas.box import Box

Pixels = NDArray[np.uint32]

MASK, HALF, EIGHT, FULL = np.uint32(0x00FF00FF), np.uint32(0x00800080), np.uint32(8), np.uint32(255)

KEPT = 16
"""Pictures kept in the colours in which they are laid over."""


@dataclass(frozen=True, slots=True, eq=False)
class Sticker:
    """A picture and its place: `colours` array[y, x] of 0xFFRRGGBB as wide and high as `box`, `alpha` 0..255."""

    box: Box
    colours: Pixels
    alpha: Pixels


Stickers = Callable[[float], Sequence[Sticker]]
"""What is laid over a film at a moment: the same objects while it stays the same."""


class Overlay:
    """Lays stickers over a painter's pixels and takes them off again. `finished` changes opaque pixels to the colours
    of the painter (`canvas.video`); with `whole` every sticker is seen in every frame, else only where it changed."""

    def __init__(
        self, stickers: Stickers, whole: bool, finished: Callable[[Pixels], Pixels] = lambda pixels: pixels
    ) -> None:
        self._stickers = stickers
        self._whole = whole
        self._ready = lru_cache(KEPT)(lambda sticker: _ready(sticker, finished))
        self._before: tuple[Sticker, ...] = ()

    @contextmanager
    def over(self, pixels: Pixels, time: float, boxes: Sequence[Box]) -> Iterator[tuple[Box, ...]]:
        """The pixels with the stickers of a moment on them inside the block, and the boxes where the frame differs
        from the one before: `boxes`, and where stickers came or went."""
        stickers = tuple(self._stickers(time))
        changed = [sticker.box for sticker in {*stickers} ^ {*self._before}]
        self._before = stickers
        whole = Box(0, 0, pixels.shape[1], pixels.shape[0])
        seen = (*boxes, *(box & whole for box in changed))
        laid = []
        for sticker in stickers:
            for box in (sticker.box & whole,) if self._whole else _parts(sticker.box & whole, seen):
                laid.append((box, box.of(pixels).copy()))
                self._lay(sticker, box, pixels)
        try:
            yield seen
        finally:
            for box, before in reversed(laid):
                box.of(pixels)[...] = before

    def _lay(self, sticker: Sticker, box: Box, pixels: Pixels) -> None:
        """Blend a part of a sticker into the pixels: premultiplied, two channels of eight bits at a time."""
        colours, rest = self._ready(sticker)
        part = slice(box.top - sticker.box.top, box.bottom - sticker.box.top)
        across = slice(box.left - sticker.box.left, box.right - sticker.box.left)
        below, shown = box.of(pixels), rest[part, across]
        low = _scaled(below & MASK, shown)
        high = _scaled(below >> EIGHT & MASK, shown)
        below[...] = colours[part, across] + (low | high << EIGHT)


def _parts(box: Box, seen: Sequence[Box]) -> list[Box]:
    """The parts of a box, apart from each other, that cover what of it lies in others and has to be seen anew, with
    the pixels beside that share its chroma: bands of the box, as wide as it is."""
    rows = sorted((cut.top & ~1, cut.bottom + 1 & ~1) for cut in (other.even() & box for other in seen) if cut)
    joined: list[tuple[int, int]] = []
    for top, bottom in rows:
        if joined and top <= joined[-1][1]:
            joined[-1] = joined[-1][0], max(joined[-1][1], bottom)
        else:
            joined.append((top, bottom))
    return [Box(box.left, top, box.right, bottom) & box for top, bottom in joined]


def _ready(sticker: Sticker, finished: Callable[[Pixels], Pixels]) -> tuple[Pixels, Pixels]:
    """A sticker's premultiplied pixels, and how much of what is below stays, 0..255."""
    opaque = finished(sticker.colours)
    alpha = sticker.alpha.astype(np.uint32)
    low, high = _scaled(opaque & MASK, alpha), _scaled(opaque >> EIGHT & MASK, alpha)
    return low | high << EIGHT, FULL - alpha


def _scaled(pair: Pixels, share: Pixels) -> Pixels:
    """Two channels in the bytes 0 and 2 times `share` of 255, rounded."""
    product = pair * share + HALF
    return product + (product >> EIGHT & MASK) >> EIGHT & MASK
