"""Texts to how wide they are and what of them fits, in the one font that is always there: Pillow's own."""

from __future__ import annotations

import unicodedata
from functools import cache, lru_cache

from PIL import ImageFont

FINE = 4
"""Text is measured and drawn at so many times its size, where letters stand where they should, not on whole pixels."""

BIG = 40
"""The size at which a letter is told from the box that stands for one that is lacking, px."""

CUT = "…"
"""Stands for what does not fit."""

WIDE, OTHER = 1.0, 0.65
"""Widths of letters that the font lacks, of the text's size: of a Chinese character, and of any other letter."""


@cache
def font(size: int) -> ImageFont.FreeTypeFont:
    """Pillow's own font (Aileron, which has the letters and signs of English)."""
    found = ImageFont.load_default(size)
    assert isinstance(found, ImageFont.FreeTypeFont), "Pillow comes with FreeType"
    return found


@lru_cache(maxsize=8192)
def width(text: str, size: int) -> float:
    """The width of a line of text, px."""
    known = "".join(letter for letter in text if has(letter))
    return font(size * FINE).getlength(known) / FINE + sum(_guess(letter) * size for letter in text if not has(letter))


def fit(text: str, size: int, room: float) -> str:
    """As much of a text as `room` px hold, with a sign where it is cut; nothing where not two letters fit."""
    if width(text, size) <= room:
        return text
    low, high = 0, min(len(text), int(room))
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if width(text[:middle].rstrip() + CUT, size) <= room else (low, middle - 1)
    return text[:low].rstrip() + CUT if low > 1 else ""


def drawable(text: str) -> str:
    """The text in letters that the font has, as far as that goes: `é` as `e`; others stay, and show as boxes."""
    return "".join(letter if has(letter) else _plain(letter) for letter in text)


@lru_cache(maxsize=8192)
def has(letter: str) -> bool:
    """Whether the font has a letter: it draws a box for those that it has not."""
    return letter == " " or (letter.isprintable() and bytes(font(BIG).getmask(letter)) != _box())


@cache
def _box() -> bytes:
    return bytes(font(BIG).getmask("\uffff"))


def _plain(letter: str) -> str:
    base = unicodedata.normalize("NFKD", letter)[0]
    return base if has(base) else letter


def _guess(letter: str) -> float:
    if unicodedata.combining(letter):
        return 0.0
    return WIDE if unicodedata.east_asian_width(letter) in "WF" else OTHER
