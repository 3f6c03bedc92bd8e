"""Shapes of the mouth one after another to such as have room to move between them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from facescript.speech.mouth.shape import MouthShape

GAP = 0.03
"""The shortest way from one shape to the next, in seconds."""

TOUCH = 0.01
"""The shortest way from shut lips to a lip on the teeth and back where speech is so fast that there is no `GAP` between
them, in seconds: they hardly move."""

RANK = {"m": 3, "f": 2, "u": 2, "o": 2, "th": 1, "z": 1, "r": 1, "h'": 0, "h": 0}
"""Which of two shapes without room for both stays; vowels and the others have 1."""


def arranged(shapes: Sequence[MouthShape]) -> tuple[MouthShape, ...]:
    """The shapes with at least `GAP` between them: closed lips stay, others give way, the weaker fall away."""
    kept: list[MouthShape] = []
    for shape in shapes:
        _append(kept, shape)
    return tuple(kept)


def _append(kept: list[MouthShape], shape: MouthShape) -> None:
    """Put a shape behind the others, making room."""
    while kept:
        last = kept[-1]
        if _one(last, shape):
            shape = _merged(kept.pop(), shape)
            continue
        made = _made_room(last, shape, kept[-2].off if len(kept) > 1 else float("-inf"))
        if made:
            kept[-1], shape = made
            break
        if (last.closed, _rank(last)) >= (shape.closed, _rank(shape)):
            return
        kept.pop()
    kept.append(shape)


def _one(last: MouthShape, shape: MouthShape) -> bool:
    """Whether the second only goes on with the first: between two closures the mouth opens where there is time."""
    near = 2 * GAP if last.closed else GAP
    return last.name == shape.name and last.own == shape.own and shape.on - last.off < near


def _merged(last: MouthShape, shape: MouthShape) -> MouthShape:
    stronger = max(last, shape, key=lambda one: one.degree)
    return replace(
        stronger,
        on=min(last.on, shape.on),
        off=max(last.off, shape.off),
        slack=last.slack,
        yields=last.yields,
        trim=shape.trim,
        vowel=last.vowel or shape.vowel,
    )


def _made_room(last: MouthShape, shape: MouthShape, earlier: float) -> tuple[MouthShape, MouthShape] | None:
    """The two shapes far enough apart, or None; `earlier` is when the one before them ends."""
    if last.closed and shape.closed:
        return _touching(last, shape)
    least = max(last.off - max(last.trim, 0.0), last.on) if last.closed else last.on
    latest = shape.on + max(shape.slack, 0.0) if shape.closed else shape.off + GAP
    for off, on in ((last.off, shape.on), (least, shape.on), (last.off, latest), (least, latest)):
        if off + GAP <= on:
            on = max(shape.on, off + GAP)
            return last.ended(max(last.on, min(last.off, on - GAP))), shape.begun(on)
    moved = latest - GAP
    if not last.closed and earlier + GAP <= moved:
        return replace(last, on=moved, off=moved), shape.begun(latest)
    return None


def _touching(last: MouthShape, shape: MouthShape) -> tuple[MouthShape, MouthShape] | None:
    """Two closures: each stands where it must, and as long as the other lets it."""
    least = max(last.off - max(last.trim, 0.0), last.on)
    latest = min(shape.on + max(shape.yields, 0.0), shape.off)
    if latest - least < TOUCH:
        return None
    way = min(latest - least, GAP)
    on = min(max(shape.on, least + way), latest)
    return last.ended(min(last.off, on - way)), shape.begun(on)


def _rank(shape: MouthShape) -> int:
    return RANK.get(shape.name, 1)
