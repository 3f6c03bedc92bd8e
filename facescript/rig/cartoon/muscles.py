"""Muscles, the jaw and other signals -> how the parts that stand still otherwise are pushed about."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from facescript.ir.kind import Pull, PullField
from facescript.performance.channels import SIDES
from facescript.rig.cartoon.depth import smooth
from facescript.rig.cartoon.outline import Part
from facescript.rig.cartoon.style import FaceStyle
from facescript.rig.cartoon.table import Table

Floats = NDArray[np.float64]
Offset = tuple[float, float]

LIMP = frozenset({"contour", "skin", "under_jaw", "mouth"})
"""Depth laws of the skin that follows the jaw."""

RIGID = "rigid"
"""The depth law of what follows it as a whole, as far as its first anchor would."""


MIDDLE = 8.0
"""Where a shape crosses the face's middle, one side's muscle hands over to the other's within so many px."""


@dataclass(frozen=True, slots=True)
class Effect:
    """What one signal moves: which anchors, and how far (array[anchor, 1], px) when the signal is 1."""

    signal: str
    rows: NDArray[np.intp]
    dx: Floats
    dy: Floats


def effects(style: FaceStyle, table: Table) -> tuple[Effect, ...]:
    """All that moves the anchors of a face."""
    parts = {part.id: part for part in style.parts}
    found = [_effect(*each) for pull in style.pulls for each in _pulled(pull, parts, table)]
    return (*found, *_flesh(style, table))


def _pulled(pull: Pull, parts: dict[str, Part], table: Table) -> Iterator[tuple[str, list[int], list[Offset]]]:
    """A pull's signal, rows and offsets; on the face's right everything is mirrored."""
    for name in pull.shapes:
        if not pull.sides and name in parts:
            yield pull.signal, *_moved(pull, parts[name], table, 1)
            continue
        for side, sign in zip(SIDES, (1, -1), strict=True):
            part = parts.get(f"{name}-{side}") or parts.get(name)
            if part is not None:
                yield (f"{pull.signal}.{side}" if pull.sides else pull.signal), *_moved(pull, part, table, sign)


def _moved(pull: Pull, part: Part, table: Table, sign: int) -> tuple[list[int], list[Offset]]:
    rows = table.rows[part.id]
    numbers = list(range(rows.start, rows.stop))
    offsets = pull.by * len(numbers) if len(pull.by) == 1 else pull.by
    if pull.fields:
        places = zip(table.x[rows].tolist(), table.y[rows].tolist(), strict=True)
        offsets = tuple(_in_fields(pull.fields, x, y, sign) for x, y in places)
    elif sign < 0:
        offsets = tuple((-dx, dy) for dx, dy in _turned(offsets, [len(loop) for loop in part.loops]))
    if pull.sides and part.id in pull.shapes:
        share = [smooth(-MIDDLE, MIDDLE, sign * x) for x in table.x[rows].tolist()]
        offsets = tuple((k * dx, k * dy) for k, (dx, dy) in zip(share, offsets, strict=True))
    return numbers, list(offsets)


def _turned(offsets: Sequence[Offset], lengths: Sequence[int]) -> Iterator[Offset]:
    """Offsets in the order of mirrored outlines, each of which runs the other way."""
    first = 0
    for length in lengths or [len(offsets)]:
        yield from reversed(offsets[first : first + length])
        first += length


def _in_fields(fields: Sequence[PullField], x: float, y: float, sign: int) -> Offset:
    """How far fields move what stands at a place; on the face's right they are mirrored."""
    dx = dy = 0.0
    for field in fields:
        far = math.hypot(sign * x - field.at[0], y - field.at[1]) / field.within
        share = (1.0 - far * far) ** 2 if far < 1.0 else 0.0
        dx, dy = dx + share * sign * field.by[0], dy + share * field.by[1]
    return dx, dy


def _flesh(style: FaceStyle, table: Table) -> Iterator[Effect]:
    """The skin of the lower face goes down with the jaw, by less the higher it is; the chin's muscle lifts its boss."""
    chin_y, start = style.outline[-1][1], style.jaw.start

    def boss(x: float, y: float) -> float:
        return -4.0 * smooth(chin_y - 45, chin_y - 15, y) * math.exp(-((x / 45) ** 2))

    yield _down("jaw-drop", table, LIMP | {RIGID}, lambda x, y: smooth(start, chin_y - 8, y))
    yield _down("jaw-drop", table, frozenset({"neck_shadow"}), lambda x, y: 0.6 * smooth(100, 200, y))
    yield _down("chin", table, LIMP | {RIGID}, boss)


def _down(signal: str, table: Table, laws: frozenset[str], push: Callable[[float, float], float]) -> Effect:
    """What moves up and down all that it takes hold of, by law, as a function of its place."""
    rows = [row for row, (_, law) in enumerate(table.owner) if law in laws]
    told = [table.rows[table.owner[row][0]].start if table.owner[row][1] == RIGID else row for row in rows]
    return _effect(signal, rows, [(0.0, push(float(table.x[row]), float(table.y[row]))) for row in told])


def _effect(signal: str, rows: Sequence[int], offsets: Sequence[Offset]) -> Effect:
    """The effect on those rows that are moved at all."""
    moved = [(row, dx, dy) for row, (dx, dy) in zip(rows, offsets, strict=True) if abs(dx) + abs(dy) > 1e-9]
    columns = np.array([(dx, dy) for _, dx, dy in moved], dtype=np.float64).reshape(-1, 2)
    return Effect(signal, np.array([row for row, _, _ in moved], dtype=np.intp), columns[:, :1], columns[:, 1:])
