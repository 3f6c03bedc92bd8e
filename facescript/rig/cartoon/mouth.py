"""Where the lips are -> the outlines of lips, cavity, teeth, tongue, and of the folds of the cheeks."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from facescript.rig.cartoon.lips import SIDES, Lips, MouthState, MouthStyle, lips
from facescript.rig.cartoon.muzzle import draw_inside, draw_line, draw_muzzle, muzzle_lips, set_depths
from facescript.rig.cartoon.pen import Number, Pen, lerp, step


def draw_mouth(pen: Pen, style: MouthStyle, state: MouthState) -> Lips:
    """Draw all parts of the mouth and the folds beside it into `pen`; returns where the lips are."""
    if style.muzzle:
        return _draw_animal(pen, style, state)
    shape = lips(style, state)
    _inside(pen, style, state, shape)
    _lips(pen, style, shape)
    _line(pen, style, shape)
    _folds(pen, style, state, shape)
    return shape


def _draw_animal(pen: Pen, style: MouthStyle, state: MouthState) -> Lips:
    """The same parts and the muzzle, round an animal's lips."""
    shape = muzzle_lips(style, state)
    draw_inside(pen, style, state, shape)
    _lips(pen, style, shape, past=0.8 * style.upper * shape.round, over=0.5)
    draw_line(pen, style, shape)
    draw_muzzle(pen, style, state, shape)
    set_depths(pen, style, tuple(pen.loops))
    _folds(pen, style, state, shape)
    return shape


def _inside(pen: Pen, style: MouthStyle, state: MouthState, shape: Lips) -> None:
    """Cavity, tongue and both rows of teeth; the cavity bounds them all."""
    top, bottom = shape.inner_upper, shape.inner_lower
    _cavity(pen, shape)
    high, low = top[2][1], bottom[2][1]
    teeth = 10.0 * np.clip(state.teeth, 0.0, 1.0) + 2.0 * shape.apart * state.mean("raise_")
    _tongue(pen, style, state, shape, high + np.minimum(teeth, 8.0))
    shown = 0.72 * teeth * (1 - step(7.0, 17.0, shape.gap))
    hidden = 11.0 * (1 - step(0.0, 4.0, shown))
    _set(pen, "mouth-teeth-lower", style, low - shown + hidden, LOWER_TEETH)
    _set(pen, "mouth-teeth-upper", style, high + teeth, UPPER_TEETH)
    for x, rise in GAPS:
        edge = high + teeth + rise
        x = x * style.half_width
        pen.ribbon("mouth-teeth-gaps", [(x, edge - 0.4, 0.01), (x, edge - 7, 1.2), (x, edge - 20, 0.01)])


def _tongue(pen: Pen, style: MouthStyle, state: MouthState, shape: Lips, edge: Number) -> None:
    """The tongue at rest behind the lower lip; with its tip at the `edge` (y, px) of the upper teeth; or out between
    the teeth, broad and flat."""
    up, out = step(0.0, BEHIND, state.tongue), step(BEHIND, 1.0, state.tongue)
    resting = shape.inner_lower[2][1] - 10.0 * step(8.0, 30.0, shape.gap) * (1 - 0.7 * shape.round)
    tip = lerp(resting, np.minimum(edge - 0.5, resting), up)
    wide, flat = 1 + 0.25 * up + 0.25 * out, 1 - 0.3 * out
    _set(pen, "mouth-tongue", style, tip, [(x * wide, y * flat if y < 20.0 else y, sharp) for x, y, sharp in TONGUE])


BEHIND = 0.8
"""The value of the channel `tongue` at which its tip is at the upper teeth; from there on it comes out below them."""


def _cavity(pen: Pen, shape: Lips) -> None:
    """The dark of the mouth reaches under both lips, so that no slit shows and its edge is never seen."""
    top, bottom = shape.inner_upper, shape.inner_lower
    above = UNDER_LIPS * (top[2][1] - shape.outer_upper[2][1])
    below = UNDER_LIPS * (shape.outer_lower[1][1] - bottom[2][1])
    raised = [(top[k][0], top[k][1] - share * above) for k, share in SHARES]
    lowered = [(bottom[k][0], bottom[k][1] + share * below) for k, share in SHARES]
    pen.loop("mouth-cavity", [top[0], *raised, top[4], *lowered[::-1]])


UNDER_LIPS = 0.35
"""How far under a lip the dark reaches, of the lip's thickness."""

SHARES = ((1, 0.7), (2, 1.0), (3, 0.7))
"""How much of that at the three places between the corners."""


def _set(pen: Pen, part: str, style: MouthStyle, height: Number, half: Sequence[tuple[Number, Number, bool]]) -> None:
    """Draw what is rigid, teeth and tongue: the cavity shows as much of it as is open. `half` are x (of the mouth's
    half width), y below `height` (px) and sharpness, from the middle of the edge that is seen round to the root."""
    spots = [(x * style.half_width, height + y, sharp) for x, y, sharp in half]
    pen.loop(part, [*spots, *((-x, y, sharp) for x, y, sharp in spots[-2:0:-1])])


TONGUE = (
    *((0.0, 0.0, False), (0.19, 0.5, False), (0.36, 4.5, False), (0.50, 15.0, False)),
    *((0.55, 46.0, True), (0.0, 46.0, False)),
)
"""The tongue's half as `_set` takes it: its root lies lower than any mouth opens."""

UPPER_TEETH = (
    *((0.0, 0.0, False), (0.46, -0.9, False), (0.80, -3.4, False), (0.92, -9.0, False)),
    *((0.95, -28.0, True), (0.0, -28.0, False)),
)
LOWER_TEETH = ((0.0, 0.0, False), (0.40, -1.2, False), (0.74, -4.0, False), (0.8, 22.0, True), (0.0, 26.0, False))
"""Half of each row of teeth, flat and rounded at its end; the roots lie behind the lips."""

GAPS = ((-0.42, -0.8), (-0.22, -0.2), (0.0, 0.0), (0.22, -0.2), (0.42, -0.8))
"""Where the upper teeth part: x of the mouth's half width, and how much higher their edge is there than the middle."""


def _lips(pen: Pen, style: MouthStyle, shape: Lips, past: Number = 0.0, over: float = 0.0) -> None:
    """Both lips; they reach `past` (px) the corners of an opening that they ring, and `over` it where nothing dark
    lies under them, so that a closed mouth shows no slit."""
    (left, left_y), (right, right_y) = shape.corner
    top, bottom = shape.inner_upper, shape.inner_lower
    pen.loop(
        "mouth-lip-lower",
        [
            (right + 1.1 + past, right_y - 0.3, True),
            *shape.outer_lower[::-1],
            (left - 1.1 - past, left_y - 0.3, True),
            *((spot[0], spot[1] - over) for spot in bottom[1:4]),
        ],
    )
    pen.loop(
        "mouth-lip-upper",
        [
            (left - 1.6 - past, left_y + 0.2, True),
            *shape.outer_upper,
            (right + 1.6 + past, right_y + 0.2, True),
            *((spot[0], spot[1] + over) for spot in top[3:0:-1]),
        ],
    )
    outer = (shape.outer_lower[1][1] + shape.outer_lower[2][1]) / 2
    light, half = lerp(bottom[2][1], outer, 0.40), style.half_width
    pen.loop(
        "mouth-lip-light",
        [
            (-0.32 * half, light - 0.8, True),
            (0.0, light - 1.4),
            (0.20 * half, light - 1.0, True),
            (0.0, light + 0.22 * style.lower),
        ],
    )
    under = outer + 3.0
    pen.loop(
        "mouth-under",
        [
            (-0.35 * half, under - 1, True),
            (0.0, under + 0.8),
            (0.35 * half, under - 1, True),
            (0.0, under + style.under),
        ],
    )


def _line(pen: Pen, style: MouthStyle, shape: Lips) -> None:
    """The dark below the upper lip, under which it lies, with a tick at each corner; both fade as the mouth opens."""
    (left, left_y), (right, right_y) = shape.corner
    top = shape.inner_upper
    width = style.line * (1 - 0.35 * shape.apart)
    tick = lerp(4.5, 2.0, shape.apart) * (1 - 0.6 * shape.round)
    rise = style.tick * (1 - 0.8 * shape.apart)
    pen.loop(
        "mouth-line",
        [
            (left - tick, left_y + rise, True),
            (0.0, lerp(top[2][1], shape.outer_upper[2][1], 0.45)),
            (right + tick, right_y + rise, True),
            (right, right_y + 0.2 + 0.6 * width, True),
            (right * 0.56, top[3][1] + 0.3 + 0.45 * width),
            (0.0, top[2][1] + 0.3 + 0.6 * width),
            (left * 0.56, top[1][1] + 0.3 + 0.45 * width),
            (left, left_y + 0.2 + 0.6 * width, True),
        ],
    )


def _folds(pen: Pen, style: MouthStyle, state: MouthState, shape: Lips) -> None:
    """The fold from each wing of the nose round the corner of the mouth."""
    for k, name in enumerate(("right", "left")):
        side, (corner_x, corner_y) = state.sides[k], shape.corner[k]
        away = SIDES[k]
        start_x, start_y = style.wing[0], style.wing[1] - 4.0 * side.nose - 2.0 * side.raise_
        reach = corner_x * away
        bulge = lerp(start_x, reach + 11, 0.62) + 2.0 * side.smile
        pen.ribbon(
            f"cheek-fold-{name}",
            [
                (away * start_x, start_y, 0.01),
                (away * bulge, lerp(start_y, corner_y, 0.42) - 1, 2.6),
                (away * (reach + 10), corner_y - 5, 1.6),
                (away * (reach + 12), corner_y + 2, 0.01),
            ],
        )
        strength = 0.22 * side.smile + 0.30 * side.nose + 0.20 * side.raise_ + 0.08 * side.stretch
        pen.opacity[f"cheek-fold-{name}"] = np.minimum(strength, 0.42)
