"""Signals -> how strongly lines, folds and blush show."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from facescript.ir.kind import Shade
from facescript.performance.channels import SIDES
from facescript.rig.cartoon.pen import Floats
from facescript.rig.cartoon.style import FaceStyle

Signal = Callable[[str], Floats]


def tones(style: FaceStyle, signal: Signal) -> dict[str, Floats]:
    """Opacity 0..1 by part, of those that signals change: array[frame]."""
    rest = {part.id: part.opacity for part in style.parts}
    out: dict[str, Floats] = {}
    for shade in style.shades:
        for part, side in _shaded(shade, rest):
            out[part] = np.clip(rest[part] + _sum(shade, signal, side), 0.0, shade.most)
    return out


def _shaded(shade: Shade, there: dict[str, float]) -> Iterator[tuple[str, str]]:
    """The parts of a shade, each with the ending of its signals' names."""
    if not shade.sides and shade.shape in there:
        yield shade.shape, ""
        return
    for part in there:
        base, _, side = part.rpartition("-")
        if base == shade.shape:
            yield part, f".{side}" if shade.sides and side in SIDES else ""


def _sum(shade: Shade, signal: Signal, side: str) -> Floats:
    total: Floats = np.zeros(1)
    for term in shade.terms:
        value = term.share * signal(term.signal + side)
        total = total + (value * np.minimum(signal(term.other + side), 1.0) if term.other else value)
    return total
