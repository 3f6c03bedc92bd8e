"""Muscles and the jaw -> how the parts that stand still otherwise are pushed about: one row a pull."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.performance.channels import SIDES
from facescript.rig.cartoon.depth import smooth
from facescript.rig.cartoon.style import FaceStyle

Floats = NDArray[np.float64]
Push = Callable[[float, float], tuple[float, float]]
"""Where an anchor stands at rest (px) to how far full contraction moves it (px)."""

LIMP = frozenset({"contour", "skin", "under_jaw", "mouth"})
"""Depth laws of the skin that follows the jaw."""


@dataclass(frozen=True, slots=True)
class Pull:
    """One effect of one signal: the parts it takes hold of (ids start with `parts`, or all whose law is in `laws`)."""

    signal: str
    parts: tuple[str, ...]
    push: Push
    laws: frozenset[str] = frozenset()

    def holds(self, part: str, law: str) -> bool:
        return part.startswith(self.parts) if self.parts else law in self.laws


@dataclass(frozen=True, slots=True)
class Effect:
    """A pull worked out: which anchors it moves, and how far (array[anchor, 1], px) when the signal is 1."""

    signal: str
    rows: NDArray[np.intp]
    dx: Floats
    dy: Floats


def pulls(style: FaceStyle) -> tuple[Pull, ...]:
    """All pulls of a face."""
    both = [pull for side, sign in zip(SIDES, (1, -1), strict=True) for pull in _of_side(style, side, sign)]
    chin_y = style.outline[-1][1]

    def drop(x: float, y: float) -> tuple[float, float]:
        return 0.0, smooth(62, chin_y - 8, y)

    def boss(x: float, y: float) -> tuple[float, float]:
        return 0.0, -4.0 * smooth(chin_y - 45, chin_y - 15, y) * math.exp(-((x / 45) ** 2))

    return (
        *both,
        Pull("jaw-drop", (), drop, LIMP),
        Pull("jaw-drop", ("neck-shadow",), lambda x, y: (0.0, 0.6 * smooth(100, 200, y))),
        Pull("chin", (), boss, LIMP),
    )


def _of_side(style: FaceStyle, side: str, sign: int) -> Iterator[Pull]:
    yield from _brow(style, side, sign)
    nose_y, mine = style.nose_base, _half(sign)
    cheek = (f"cheek-blush-{side}",)
    face = ("face-skin", "face-side")

    def wing(lift: float, widen: float) -> Push:
        def push(x: float, y: float) -> tuple[float, float]:
            low = smooth(nose_y - 40, nose_y - 4, y) * mine(x)
            return widen * x * mine(x), -lift * low

        return push

    def pad(x: float, y: float) -> tuple[float, float]:
        return (sign * 2.0 * math.exp(-(((y - 70) / 40) ** 2)) if x * sign > 60 else 0.0), 0.0

    yield Pull(f"cheek.upper.{side}", cheek, lambda x, y: (sign * 2.0, -5.0))
    yield Pull(f"cheek.lower.{side}", cheek, lambda x, y: (sign * 2.0, -4.0))
    yield Pull(f"cheek.lower.{side}", face, pad)
    yield Pull(f"cheek.lower.{side}", ("nose-",), wing(0.8, 0.06))
    yield Pull(f"nose.upper.{side}", ("nose-",), wing(4.6, 0.06))
    yield Pull(f"lip.upper.{side}", ("nose-",), wing(1.8, 0.02))


def _half(sign: int) -> Callable[[float], float]:
    """1 on one side of the face, 0 on the other, blended across the middle."""
    return lambda x: smooth(-8, 8, x * sign)


def _brow(style: FaceStyle, side: str, sign: int) -> Iterator[Pull]:
    parts = (f"brow-body-{side}", f"brow-hairs-{side}")
    inner, outer = style.brow.inner, style.brow.outer

    def along(x: float) -> float:
        return min(1.0, max(0.0, (x * sign - inner) / (outer - inner)))

    def bow(t: float) -> float:
        return math.sin(math.pi * t)

    def raise_inner(x: float, y: float) -> tuple[float, float]:
        t = along(x)
        return 0.0, -17.5 * (1 - t) ** 1.25 - 1.5 * bow(t)

    def raise_outer(x: float, y: float) -> tuple[float, float]:
        t = along(x)
        return 0.0, -13.5 * t - 3.0 * bow(t)

    def knit(x: float, y: float) -> tuple[float, float]:
        t = along(x)
        return -sign * 8.0 * (1 - t), 13.5 * (1 - t) + 5.5 * t - 1.0 * bow(t)

    def squeeze(x: float, y: float) -> tuple[float, float]:
        t = along(x)
        return -sign * 2.0 * (1 - t), 3.5 * (1 - t)

    yield Pull(f"brow.inner.{side}", parts, raise_inner)
    yield Pull(f"brow.outer.{side}", parts, raise_outer)
    yield Pull(f"forehead.{side}", parts, lambda x, y: (0.0, -11.0 - 2.0 * bow(along(x))))
    yield Pull(f"brow.lower.{side}", parts, knit)
    yield Pull(f"nose.upper.{side}", parts, squeeze)
    mine = _half(sign)
    furrow = ("brow-furrow",)
    yield Pull(f"brow.lower.{side}", furrow, lambda x, y: (-sign * 1.5 * mine(x), 3.0 * mine(x)))
    lines = ("forehead-lines",)
    yield Pull(f"brow.inner.{side}", lines, lambda x, y: (0.0, -4.0 * mine(x)))
    yield Pull(f"forehead.{side}", lines, lambda x, y: (0.0, -4.0 * mine(x)))


def effects(table: Sequence[Pull], anchors: Sequence[tuple[str, str, float, float]]) -> tuple[Effect, ...]:
    """The pulls worked out for the anchors of a face, each given as part, depth law, x, y."""
    out = []
    for pull in table:
        moved = [
            (row, dx, dy)
            for row, (part, law, x, y) in enumerate(anchors)
            if pull.holds(part, law)
            for dx, dy in (pull.push(x, y),)
            if abs(dx) + abs(dy) > 1e-9
        ]
        rows, dx, dy = zip(*moved, strict=True)
        column = [np.array(values, dtype=np.float64)[:, None] for values in (dx, dy)]
        out.append(Effect(pull.signal, np.array(rows, dtype=np.intp), column[0], column[1]))
    return tuple(out)
