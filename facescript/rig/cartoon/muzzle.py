"""Mouth channels and muscles -> an animal's lips, which are the lower edge of a muzzle, its teeth, tongue and muzzle.

At rest the line is a W: the middle stands higher than the lobes beside it. Teeth stand on the skull and get bare.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facescript.rig.cartoon.lips import SIDES, Lips, MouthState, MouthStyle, tucked
from facescript.rig.cartoon.pen import Floats, Number, Pen, Spot, lerp, step

RISE = 8.0
"""How far (px) speech lifts the upper lip at most: it hangs from the nose by a short philtrum."""

BITTEN = 9.0
"""px of the upper teeth that are seen above a lower lip that lies under them."""

LOBE = 0.6
"""Where the lobes hang, as a part of the way from the middle to the corner."""

LEAST = 0.42
"""Below this part of its half width a mouth resists being narrowed further."""

OVERLAP = 2.0
"""How far (px) the muzzle reaches over the lips' line, so that no slit shows."""


@dataclass(frozen=True, slots=True)
class _Opening:
    """What both sides of a mouth share over frames: y of the upper lip's middle, the gap below it (px), how far the
    lips are apart and pursed (0..1), and how far speech lifts the upper one (px)."""

    middle: Floats
    gap: Floats
    apart: Floats
    pursed: Floats
    rise: Floats


def muzzle_lips(style: MouthStyle, state: MouthState) -> Lips:
    """Where the lips are. As with `lips`, the inner gap at the middle is `open` MNS0."""
    opening = _opening(style, state)
    corner = [_corner(style, state, k, opening) for k in (0, 1)]
    lobes = [_lobe(style, state, k, corner[k], opening) for k in (0, 1)]
    middle, gap = opening.middle, opening.gap
    ends: list[Spot] = [(*corner[0], True), (*corner[1], True)]
    upper: list[Spot] = [(x, top) for x, top, _ in lobes]
    lower: list[Spot] = [(x, bottom) for x, _, bottom in lobes]
    upper = [ends[0], upper[0], (0.0, middle), upper[1], ends[1]]
    lower = [ends[0], lower[0], (0.0, middle + gap + 0.3), lower[1], ends[1]]
    above, below = _outer(style, state, upper, lower, corner, opening.pursed)
    drop = middle + gap - style.y - style.tubercle
    return Lips(gap, opening.apart, opening.pursed, corner, upper, lower, above, below, drop)


def _opening(style: MouthStyle, state: MouthState) -> _Opening:
    unit = style.mns0
    apart = step(0.0, 0.16, state.open)
    pursed = np.clip(state.round + 0.9 * state.mean("pucker"), 0.0, 1.0)
    said, up = unit * np.maximum(state.open, 0.0), unit * state.upper
    raised = 0.9 * state.mean("raise_") + 0.35 * state.mean("nose")
    gap = said + apart * (0.4 * style.lift * raised + 12.0 * state.mean("lower"))
    gap = gap + BITTEN * tucked(state, apart)
    rise = RISE * np.tanh((up + 0.2 * (said - up - unit * state.lower)) / RISE)
    middle = style.y + style.tubercle - (0.4 + 0.35 * apart) * style.lift * raised - 3.0 * state.mean("smile")
    middle = middle - rise - 3.0 * state.chin - 4.0 * pursed + 2.0 * state.jaw
    return _Opening(middle, gap, apart, pursed, rise)


def _corner(style: MouthStyle, state: MouthState, k: int, opening: _Opening) -> tuple[Number, Number]:
    side, wide = state.sides[k], style.half_width
    pursed = style.purse * np.clip(side.pucker, 0.0, 1.0) * (1 - 0.6 * state.round) + 0.18 * state.round
    half = wide * (1 + 0.13 * side.smile + 0.13 * side.stretch + 0.03 * side.frown - 0.06 * side.press - pursed)
    half = half + style.mw0 * state.wide
    least = LEAST * wide
    short = np.maximum(least - half, 0.0)
    half = half + short - 0.5 * least * np.tanh(short / (0.5 * least))
    y = style.y + style.corner - style.smile * side.smile + style.frown * (side.frown + 0.5 * side.press)
    y = y - 4.0 * side.nose - 2.0 * side.cheek - 0.3 * opening.rise - 1.5 * state.chin + 2.0 * state.jaw
    return SIDES[k] * half, y + opening.gap * lerp(0.16, 0.5, opening.pursed) + 2.0 * opening.pursed


def _lobe(
    style: MouthStyle, state: MouthState, k: int, corner: tuple[Number, Number], opening: _Opening
) -> tuple[Number, Number, Number]:
    """x of one lobe, and y of the lips' inner edges there; a pursed mouth has one round opening instead."""
    side, (corner_x, corner_y), pursed = state.sides[k], corner, opening.pursed
    lift = style.lift * (0.9 * side.raise_ + 0.35 * side.nose)
    hangs: Number = style.y - lerp(0.5, 1.1, opening.apart) * lift - 8.0 * side.smile - 2.0 * side.press
    hangs = hangs - opening.rise - 3.0 * state.chin + 2.0 * state.jaw
    hangs = lerp(hangs, corner_y, 0.12 * side.smile + 0.28 * np.clip(side.frown, 0.0, 1.0) + 0.12 * side.stretch)
    top = lerp(hangs, corner_y + 0.80 * (opening.middle - corner_y), pursed)
    covered = np.minimum(0.6 * style.tubercle * step(0.0, 40.0, opening.gap), 0.0)
    parts = lerp(0.85 * opening.gap + covered, 0.80 * opening.gap, pursed)
    parts = parts + opening.apart * (6.0 * side.lower + 0.2 * lift)
    return corner_x * lerp(LOBE, 0.66, pursed), top, top + 0.3 + np.maximum(parts, 0.0)


def _outer(
    style: MouthStyle,
    state: MouthState,
    upper: list[Spot],
    lower: list[Spot],
    corner: list[tuple[Number, Number]],
    puckered: Floats,
) -> tuple[list[Spot], list[Spot]]:
    """The lips' outer edges: rims that run beside the inner ones."""
    high = style.upper * (1 + 0.9 * puckered - 0.4 * state.mean("press"))
    low = style.lower * lerp(0.45, 1.0, step(0.0, 0.2, state.open))
    low = low * (1 - 0.45 * state.mean("press")) + 0.35 * style.lower * puckered
    top, bottom = upper[2][1], lower[2][1]
    above: list[list[Spot]] = []
    below: list[list[Spot]] = []
    for k, row in ((0, 1), (1, 3)):
        x = corner[k][0]
        between = lerp(lerp(upper[row][1], top, 0.62), lerp(upper[row][1], top, 0.82), puckered)
        above.append([(x * lerp(0.64, 0.76, puckered), upper[row][1] - 0.92 * high), (x * 0.27, between - high)])
        below.append(
            [
                (x * lerp(0.62, 0.74, puckered), lower[row][1] + lerp(0.8, 0.95, puckered) * low),
                (x * lerp(0.12, 0.28, puckered), lerp(bottom, lower[row][1], 0.06) + low),
            ]
        )
    middle: Spot = (0.0, top - high * lerp(0.85, 1.0, puckered))
    return [*above[0], middle, *above[1][::-1]], [*below[0], *below[1][::-1]]


def draw_inside(pen: Pen, style: MouthStyle, state: MouthState, shape: Lips) -> None:
    """Cavity, tongue and teeth; the cavity bounds them all."""
    top, bottom = shape.inner_upper, shape.inner_lower
    pen.loop("mouth-cavity", [*top, *bottom[3:0:-1]])
    _tongue(pen, style, state, shape)
    bare = np.clip(1.6 * state.teeth, 0.0, 1.0)
    narrow = 1 - 0.3 * shape.round
    back = -8.0 * (1 - bare) - 22.0 * shape.round - 6.0 * state.mean("press")
    if style.teeth_upper:
        upper = _row(style.teeth_upper, narrow, back, -34.0)
        pen.loop("mouth-teeth-upper", upper)
        for x, y in ((spot[0], spot[1]) for spot in upper[3:-3:3]):
            pen.ribbon("mouth-teeth-gaps", [(x, y - 22, 0.01), (x, y - 8, 1.6), (x, y, 0.01)])
    ahead = shape.drop + 6.0 * (1 - bare) + 10.0 * shape.round + 18.0 * (1 - step(26.0, 54.0, shape.gap))
    if style.teeth_lower:
        pen.loop("mouth-teeth-lower", _row(style.teeth_lower, narrow, ahead, 30.0))


def _row(teeth: tuple[float, ...], narrow: Number, shift: Number, root: float) -> list[Spot]:
    """A row of teeth from x, y of gap, side, side, gap ... outside to the middle, and of the roots behind the lip."""
    half = [(teeth[i], teeth[i + 1], i % 6 == 0) for i in range(0, len(teeth), 2)]
    whole = half + [(-x, y, gap) for x, y, gap in reversed(half[:-1])]
    first, last = whole[0], whole[-1]
    ends = [(last[0], last[1] + root, True), (first[0], first[1] + root, True)]
    return [(x * narrow, y + shift, gap) for x, y, gap in (*whole, *ends)]


def _tongue(pen: Pen, style: MouthStyle, state: MouthState, shape: Lips) -> None:
    high, low = shape.inner_upper[2][1], shape.inner_lower[2][1]
    tip = np.clip(state.tongue, 0.0, 1.0)
    lies = low - shape.gap * lerp(0.36, 0.16, shape.round) + 3.0
    y = lerp(lies, np.minimum(high + 14.0, lies), tip)
    right = np.minimum(0.72 * np.minimum(shape.corner[1][0], -shape.corner[0][0]), 0.58 * style.half_width)
    wide, root = right * (1 - 0.25 * shape.round), low + 26.0
    edge = ((-1.0, root), (-0.96, y + 14), (-0.45, y), (0.0, y + 4), (0.45, y), (0.96, y + 14), (1.0, root))
    pen.loop("mouth-tongue", [*((wide * u, v) for u, v in edge), (0.0, root + 10)])
    pen.ribbon("mouth-tongue-line", [(0.0, y + 7, 0.01), (0.0, y + 20, 5.0), (0.0, y + 38, 0.01)])


def draw_line(pen: Pen, style: MouthStyle, shape: Lips) -> None:
    """The line between the lips, which runs out in a flick past each corner; a pursed mouth has none."""
    (left, left_y), (right, right_y) = shape.corner
    top = shape.inner_upper
    width = style.line * (1 - 0.2 * shape.apart)
    reach = 9.0 * (1 - 0.9 * shape.round)
    rise = style.tick * (1 - 0.9 * shape.round)
    pen.ribbon(
        "mouth-line",
        [
            (left - reach, left_y + rise, 0.01),
            (left, left_y, width * 0.7),
            (top[1][0], top[1][1] + 0.5, width * 0.95),
            (0.0, top[2][1] + 0.5, width),
            (top[3][0], top[3][1] + 0.5, width * 0.95),
            (right, right_y, width * 0.7),
            (right + reach, right_y + rise, 0.01),
        ],
    )


def draw_muzzle(pen: Pen, style: MouthStyle, state: MouthState, shape: Lips) -> None:
    """The muzzle above the lips, whose lower edge they are, and the line from the nose to them."""
    top = shape.inner_upper
    sides = [_flank(style, state, shape, k) for k in (0, 1)]
    lip: list[Spot] = [(spot[0], spot[1] + OVERLAP) for spot in top[1:4]]
    crown: Spot = (0.0, style.muzzle[1], True)
    pen.loop("mouth-muzzle", [crown, *sides[1], *lip[::-1], *sides[0][::-1]])
    start = style.philtrum - 3.0 * state.mean("nose")
    lip_y = top[2][1]
    pen.ribbon("mouth-philtrum", [(0.0, start, 3.0), (0.0, lerp(start, lip_y, 0.45), 5.0), (0.0, lip_y + 2, 4.0)])


def _flank(style: MouthStyle, state: MouthState, shape: Lips, k: int) -> list[Spot]:
    """One side of the muzzle from its top to beside the corner: the nearer to the corner, the more it follows it."""
    (corner_x, corner_y), side = shape.corner[k], state.sides[k]
    there = list(zip(style.muzzle[2::2], style.muzzle[3::2], strict=True))
    shift_x = corner_x * SIDES[k] - style.half_width
    shift_y = corner_y - style.y - style.corner
    out: list[Spot] = []
    for i, (x, y) in enumerate(there):
        after = len(there) - 1 - i
        share_x, share_y = ((1.0, 1.0), (0.3, 0.9), (0.15, 0.45), (0.0, 0.0))[min(after, 3)]
        lifted = (2.0 if after == 0 else 4.0) * (side.raise_ + side.nose) * (i > 0)
        soft = 1 - (0.25 if after == 0 else 0.0) * shape.round
        out.append((SIDES[k] * (x + share_x * soft * shift_x), y + share_y * shift_y - lifted * (after < 3)))
    return out


def set_depths(pen: Pen, style: MouthStyle, parts: tuple[str, ...]) -> None:
    """How far (px) the parts fall back from the lips' middle: to the sides, towards the nose's root and the chin."""
    for part in parts:
        pen.depth[part] = [_fall(style, spot[0], spot[1]) for loop in pen.loops[part] for spot in loop]


def _fall(style: MouthStyle, x: Number, y: Number) -> Number:
    lip = style.y + style.tubercle
    aside = np.minimum(np.abs(x) / style.half_width, 1.3)
    back: Floats = -style.fall * aside * aside - 0.3 * np.maximum(y - lip, 0.0) - 0.42 * np.maximum(lip - 40.0 - y, 0.0)
    return back
