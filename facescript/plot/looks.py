"""The colours of a plot, and looks for as many curves as one panel may have."""

from __future__ import annotations

INK, GREY, LIGHT, PAPER = "#1d1d1d", "#6b6b6b", "#dcdcdc", "#ffffff"
"""Text; axes and what is said beside them; the grid; the ground."""

BLACK, VERMILION, BLUE, GREEN = "#000000", "#d55e00", "#0072b2", "#009e73"
ORANGE, PURPLE, SKY = "#e69f00", "#cc79a7", "#56b4e9"
"""Colours that colour-blind people can tell apart (Okabe and Ito 2008), but for the yellow, which paper swallows."""

COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
DASHES: tuple[tuple[float, ...], ...] = ((), (6.0, 3.0), (2.0, 2.0), (9.0, 3.0, 2.0, 3.0))
"""Lengths drawn and left out by turns, px."""


def look(number: int) -> tuple[str, tuple[float, ...]]:
    """The colour and dash of the curve of that number: all colours drawn through, then all dashed, and so on."""
    return COLOURS[number % len(COLOURS)], DASHES[number // len(COLOURS) % len(DASHES)]


def tint(colour: str, white: float) -> str:
    """A colour with so much white in it, 0..1."""
    parts = (int(colour[at : at + 2], 16) for at in (1, 3, 5))
    return "#" + "".join(f"{round(part + (255 - part) * white):02x}" for part in parts)
