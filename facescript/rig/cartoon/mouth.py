"""Where the lips are -> the outlines of lips, cavity, teeth, tongue, and of the folds of the cheeks."""

from __future__ import annotations

import numpy as np

from facescript.rig.cartoon.lips import SIDES, Lips, MouthState, MouthStyle, lips
from facescript.rig.cartoon.muzzle import draw_inside, draw_line, draw_muzzle, muzzle_lips, set_depths
from facescript.rig.cartoon.pen import Number, Pen, Spot, lerp, step


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
    _lips(pen, style, shape, past=0.8 * style.upper * shape.round)
    draw_line(pen, style, shape)
    draw_muzzle(pen, style, state, shape)
    set_depths(pen, style, tuple(pen.loops))
    _folds(pen, style, state, shape)
    return shape


def _inside(pen: Pen, style: MouthStyle, state: MouthState, shape: Lips) -> None:
    """Cavity, tongue and both rows of teeth; the cavity bounds them all."""
    top, bottom = shape.inner_upper, shape.inner_lower
    pen.loop("mouth-cavity", [*top, *bottom[3:0:-1]])
    (left, _), (right, _) = shape.corner
    high, low = top[2][1], bottom[2][1]
    teeth = 10.0 * np.clip(state.teeth, 0.0, 1.0) + 2.0 * shape.apart * state.mean("raise_")
    tip_up = np.clip(state.tongue, 0.0, 1.0)
    resting = low - 10.0 * step(8.0, 30.0, shape.gap) * (1 - 0.7 * shape.round)
    tongue = lerp(resting, high + np.minimum(teeth, 8.0) * 0.7 + 2.0, tip_up)
    wide = lerp(1.0, 0.72, tip_up)
    pen.loop(
        "mouth-tongue",
        [
            (left * 0.58, low + 12),
            (left * 0.44 * wide, tongue + 3),
            (left * 0.08, tongue),
            (right * 0.08, tongue),
            (right * 0.44 * wide, tongue + 3),
            (right * 0.58, low + 12),
            (0.0, low + 18),
        ],
    )
    _teeth(pen, shape, teeth)


def _teeth(pen: Pen, shape: Lips, teeth: Number) -> None:
    top, bottom = shape.inner_upper, shape.inner_lower
    (left, left_y), (right, right_y) = shape.corner
    high, low = top[2][1], bottom[2][1]
    arch = lerp(0.84, 0.60, shape.round)
    part = (arch - 0.56) / 0.44
    edge = [
        row[1] + (y - row[1]) * np.maximum(part, 0.0) ** 1.6 - 0.6 for row, y in ((top[1], left_y), (top[3], right_y))
    ]
    sag = [lerp(top[k][1] + teeth * 0.8, high + teeth * 0.92, shape.round) for k in (1, 3)]
    pen.loop(
        "mouth-teeth-upper",
        [
            (left, left_y - 9, True),
            (left * 0.5, top[1][1] - 9),
            (0.0, high - 9),
            (right * 0.5, top[3][1] - 9),
            (right, right_y - 9, True),
            (right * arch, edge[1], True),
            (right * 0.46, sag[1]),
            (0.0, high + teeth),
            (left * 0.46, sag[0]),
            (left * arch, edge[0], True),
        ],
    )
    shown = 0.72 * teeth * (1 - step(7.0, 17.0, shape.gap))
    hidden = 11.0 * (1 - step(0.0, 4.0, shown))
    lower: list[Spot] = [
        (left * 0.8, left_y + 12, True),
        (0.0, low + 14),
        (right * 0.8, right_y + 12, True),
        (right * 0.74, lerp(right_y, bottom[3][1], 0.7) - shown * 0.3),
        (right * 0.4, bottom[3][1] - shown * 0.8),
        (0.0, low - shown),
        (left * 0.4, bottom[1][1] - shown * 0.8),
        (left * 0.74, lerp(left_y, bottom[1][1], 0.7) - shown * 0.3),
    ]
    pen.loop("mouth-teeth-lower", [(spot[0], spot[1] + hidden, len(spot) > 2) for spot in lower])
    for along, share in GAPS:
        k = int(along > 0)
        x, y = abs(along) * (left, right)[k], lerp(high + teeth, sag[k], share)
        pen.ribbon("mouth-teeth-gaps", [(x, y - teeth - 8, 0.01), (x, y - 0.4 * teeth - 2, 1.2), (x, y - 0.4, 0.01)])


GAPS = ((-0.42, 0.92), (-0.22, 0.3), (0.0, 0.0), (0.22, 0.3), (0.42, 0.92))
"""Where the upper teeth part: along the half mouth, and how far their edge is there between middle's and side's."""


def _lips(pen: Pen, style: MouthStyle, shape: Lips, past: Number = 0.0) -> None:
    """Both lips overlap the cavity by half a pixel, so that a closed mouth shows no slit; they reach `past` (px) the
    corners of an opening that they ring."""
    (left, left_y), (right, right_y) = shape.corner
    top, bottom = shape.inner_upper, shape.inner_lower
    pen.loop(
        "mouth-lip-lower",
        [
            (right + 1.1 + past, right_y - 0.3, True),
            *shape.outer_lower[::-1],
            (left - 1.1 - past, left_y - 0.3, True),
            *((spot[0], spot[1] - 0.5) for spot in bottom[1:4]),
        ],
    )
    pen.loop(
        "mouth-lip-upper",
        [
            (left - 1.6 - past, left_y + 0.2, True),
            *shape.outer_upper,
            (right + 1.6 + past, right_y + 0.2, True),
            *((spot[0], spot[1] + 0.6) for spot in top[3:0:-1]),
        ],
    )
    outer = (shape.outer_lower[1][1] + shape.outer_lower[2][1]) / 2
    light = lerp(bottom[2][1], outer, 0.40)
    tall = (outer - bottom[2][1]) * 0.24
    pen.loop(
        "mouth-lip-light",
        [(left * 0.34, light - 0.8, True), (0.0, light - 1.4), (right * 0.22, light - 1.0, True), (0.0, light + tall)],
    )
    under = outer + 3.0
    pen.loop(
        "mouth-under",
        [
            (left * 0.40, under - 1, True),
            (0.0, under + 0.8),
            (right * 0.40, under - 1, True),
            (0.0, under + style.under * np.minimum(right / style.half_width, 1.0)),
        ],
    )


def _line(pen: Pen, style: MouthStyle, shape: Lips) -> None:
    """The line between the lips, with a tick at each corner; both fade as the mouth opens."""
    (left, left_y), (right, right_y) = shape.corner
    top = shape.inner_upper
    width = style.line * (1 - 0.35 * shape.apart)
    tick = lerp(4.5, 2.0, shape.apart) * (1 - 0.6 * shape.round)
    rise = style.tick * (1 - 0.8 * shape.apart)
    pen.ribbon(
        "mouth-line",
        [
            (left - tick, left_y + rise, 0.01),
            (left, left_y + 0.2, width * 1.3, True),
            (left * 0.56, top[1][1] + 0.3, width * 0.85),
            (0.0, top[2][1] + 0.3, width * 1.15),
            (right * 0.56, top[3][1] + 0.3, width * 0.85),
            (right, right_y + 0.2, width * 1.3, True),
            (right + tick, right_y + rise, 0.01),
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
    pen.opacity["mouth-under"] = 0.42 + 0.1 * shape.apart
