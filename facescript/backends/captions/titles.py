"""The captions of a film to pictures laid over its frames: white letters on a dark plate at the picture's foot."""

from __future__ import annotations

import unicodedata
from bisect import bisect_right
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, features

from facescript.backends.captions.cues import WIDEST, Cue, cues, named
from facescript.backends.captions.fonts import Face, font_for
from facescript.backends.captions.said import said
from facescript.canvas.box import Box
from facescript.canvas.overlay import Sticker
from facescript.schedule.score import Score

HEIGHT, LEAST = 0.05, 9
"""The size of letters, of the picture's height, and at least, px."""

NARROWEST, COLUMN = 26, 0.52
"""Columns that a line always has, and the width of a column, of the size of letters."""

SAFE, FOOT = 0.9, 0.06
"""The share of the picture's width that captions take at most, and of its height below them."""

LEADING, PADDING, ROUND = 1.25, 0.4, 0.3
"""From line to line, and the plate around the letters and its corners, of the size of letters."""

PLATE, OPACITY, INK = 0x10141A, 0.72, 0xFFFFFF
"""The colours of plate and letters, and how opaque the plate is."""

FINE = 4
"""The plate is drawn at so many times its size."""

LANGUAGES = {
    "cmn": "zh-hans",
    "zh": "zh-hans",
    "zh-cn": "zh-hans",
    "zh-tw": "zh-hant",
    "yue": "zh-hant",
    "ja": "ja",
    "ko": "ko",
}
"""espeak-ng's languages as OpenType knows them."""

KEPT = 32
"""Pictures of captions kept."""

Grey = NDArray[np.uint8]


class Titles:
    """The captions of a film between two moments, for pictures of one size; `font` is the bytes of a font, None to
    find one. Raises `JobFailure` where no font has their signs."""

    def __init__(self, score: Score, start: float, end: float, font: bytes | None) -> None:
        self._width, self._height = score.film.width, score.film.height
        by_width = SAFE * self._width / (NARROWEST * COLUMN)
        self._size = max(LEAST, round(min(HEIGHT * self._height, by_width)))
        columns = int(SAFE * self._width / (COLUMN * self._size))
        self._cues = named(cues(said(score, start, end), max(NARROWEST, min(WIDEST, columns))))
        self._starts = [cue.start for cue in self._cues]
        self._longest = max((cue.end - cue.start for cue in self._cues), default=0.0)
        self._face = font_for((text for cue in self._cues for text in _texts(cue)), font)
        self._drawn = lru_cache(KEPT)(self._drawn_at)

    def at(self, time: float) -> Sequence[Sticker]:
        """What is laid over the picture at a moment; of several captions the later stand above."""
        first = bisect_right(self._starts, time - self._longest - 1e-9)
        last = bisect_right(self._starts, time + 1e-9)
        found = []
        foot = round(self._height * (1 - FOOT))
        for number in range(max(first - 1, 0), last):
            if self._cues[number].end > time + 1e-9:
                found.append(self._drawn(number, foot))
                foot = found[-1].box.top - self._size // 4
        return found

    def _language(self, number: int) -> str | None:
        """What decides between the shapes that one character has in China, Taiwan, Japan and Korea; only Raqm can."""
        return LANGUAGES.get(self._cues[number].language.lower()) if features.check("raqm") else None

    def _drawn_at(self, number: int, foot: int) -> Sticker:
        """A caption whose plate ends at `foot`."""
        texts = _texts(self._cues[number])
        size = _fitting(self._face, texts, self._size, SAFE * self._width)
        ink, plate = _lettered(self._face, texts, size, self._language(number))
        height, width = ink.shape
        left = (self._width - width) // 2
        top = max(foot - height, 0)
        letters = ink.astype(np.float64) / 255
        ground = plate.astype(np.float64) / 255 * OPACITY
        alpha = letters + ground * (1 - letters)
        share = np.divide(letters, alpha, out=np.zeros_like(letters), where=alpha > 0)
        colours = np.full(ink.shape, 0xFF000000, dtype=np.uint32)
        for shift in (16, 8, 0):
            low, high = PLATE >> shift & 0xFF, INK >> shift & 0xFF
            colours |= np.rint(low + (high - low) * share).astype(np.uint32) << np.uint32(shift)
        opacity = np.rint(255 * alpha).astype(np.uint32)
        return Sticker(Box(left, top, left + width, top + height), colours, opacity)


def _texts(cue: Cue) -> tuple[str, ...]:
    """The lines of a caption as they are drawn, a face's name before them."""
    first, *rest = cue.texts
    return (f"{cue.face}: {first}" if cue.face else first, *rest)


def _fitting(face: Face, texts: Sequence[str], size: int, room: float) -> int:
    """The size of letters at which the widest line has room."""
    widest = max(_length(face, text, size) for text in texts)
    return size if widest <= room else max(LEAST, int(size * room / widest))


def _length(face: Face, text: str, size: int) -> float:
    return face.at(size).getlength(text, direction=_direction(text))


def _direction(text: str) -> str | None:
    """`rtl` where a line runs from right to left: its first letter says so."""
    for sign in text:
        side = unicodedata.bidirectional(sign)
        if side in ("L", "R", "AL"):
            return "rtl" if side != "L" else None
    return None


def _lettered(face: Face, texts: Sequence[str], size: int, language: str | None) -> tuple[Grey, Grey]:
    """Letters and plate as two masks of one size, 0..255."""
    font = face.at(size)
    ascent, descent = font.getmetrics()
    pad, step = round(PADDING * size), round(max(LEADING * size, (ascent + descent) * 0.98))
    widths = [_length(face, text, size) for text in texts]
    width = int(max(widths)) + 2 * pad + 1
    height = step * (len(texts) - 1) + ascent + descent + 2 * (pad // 2)
    ink = Image.new("L", (width + width % 2, height + height % 2))
    draw = ImageDraw.Draw(ink)
    for number, (text, length) in enumerate(zip(texts, widths, strict=True)):
        place = ((ink.width - length) / 2, pad // 2 + number * step)
        draw.text(place, text, fill=255, font=font, direction=_direction(text), language=language)
    return np.asarray(ink), np.asarray(_plate(ink.width, ink.height, round(ROUND * size)))


def _plate(width: int, height: int, corner: int) -> Image.Image:
    """A rectangle with round corners, drawn large and made small, so that they are smooth."""
    large = Image.new("L", (FINE * width, FINE * height))
    edge = (0, 0, FINE * width - 1, FINE * height - 1)
    ImageDraw.Draw(large).rounded_rectangle(edge, FINE * corner, fill=255)
    return large.reduce(FINE)
