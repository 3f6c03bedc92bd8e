"""Mouth channels and the muscles round the mouth -> where the lips are.

The inner edges of the lips are the master: five points above, five below, right and left of their own. All else
follows from them (`mouth.py`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facescript.rig.cartoon.pen import Floats, Number, Spot, lerp, step

SIDES = (-1, 1)
"""The image's left (the face's right) and the image's right."""

NARROW = 20.0
"""Below this half width (px) a mouth resists being narrowed further."""

TUCKED, BARED, BITTEN = 0.2, 0.6, 0.34
"""By how much (MNS0) a lower lip is drawn in that lies wholly under the teeth, how far those show then, and the part of
its height that they hide: so much of them is seen (shape f: half of the lip is gone, its edge is under theirs)."""


@dataclass(frozen=True, slots=True)
class MouthStyle:
    """One face's mouth, px: height of the line, half width, lips, bow, and where the nose's base and wings are.

    With a `muzzle` (right half of its outline, x and y in turn, from the upper middle to beside the mouth's corner) the
    mouth is an animal's (`muzzle.py`): `lift`, `smile`, `frown` are how far muscles move lip and corners, `purse` is
    the part of its width that pursed lips lose, `fall` how far the corners lie behind the middle, `philtrum` where the
    line below the nose begins; teeth are x and y of gap, side, side, gap ... from the outermost to the middle.
    """

    y: float
    half_width: float
    corner: float
    upper: float
    lower: float
    tubercle: float
    bow: float
    dip: float
    under: float
    line: float
    tick: float
    nose_base: float
    wing: tuple[float, float]
    muzzle: tuple[float, ...] = ()
    lift: float = 0.0
    smile: float = 0.0
    frown: float = 0.0
    purse: float = 0.0
    fall: float = 0.0
    philtrum: float = 0.0
    teeth_upper: tuple[float, ...] = ()
    teeth_lower: tuple[float, ...] = ()

    @property
    def mns0(self) -> float:
        """Mouth (2.2) to nose (9.15), px."""
        return self.y + self.tubercle - self.nose_base

    @property
    def mw0(self) -> float:
        """Mouth width, px."""
        return 2 * self.half_width


@dataclass(frozen=True, slots=True)
class Side:
    """The muscles of one side over frames, 0..1."""

    smile: Floats
    frown: Floats
    raise_: Floats
    lower: Floats
    stretch: Floats
    press: Floats
    pucker: Floats
    nose: Floats
    cheek: Floats


@dataclass(frozen=True, slots=True)
class MouthState:
    """The mouth over frames: its eight channels, the chin's muscle, and both sides (image left, image right)."""

    open: Floats
    wide: Floats
    round: Floats
    upper: Floats
    lower: Floats
    jaw: Floats
    teeth: Floats
    tongue: Floats
    chin: Floats
    sides: tuple[Side, Side]

    def mean(self, muscle: str) -> Floats:
        values: Floats = (getattr(self.sides[0], muscle) + getattr(self.sides[1], muscle)) / 2
        return values


@dataclass(frozen=True, slots=True)
class Lips:
    """The lips over frames: corners, inner and outer edges; lists run from the image's left to its right."""

    gap: Floats
    apart: Floats
    round: Floats
    corner: list[tuple[Number, Number]]
    inner_upper: list[Spot]
    inner_lower: list[Spot]
    outer_upper: list[Spot]
    outer_lower: list[Spot]
    drop: Floats


def lips(style: MouthStyle, state: MouthState) -> Lips:
    """Where the lips are. The inner gap at the middle is `open` MNS0 (and what lip muscles add to an open mouth)."""
    unit = style.mns0
    apart = step(0.0, 0.16, state.open)
    puckered = np.clip(state.round + 0.9 * state.mean("pucker"), 0.0, 1.0)
    up, low = unit * state.upper, unit * state.lower
    said = unit * np.maximum(state.open, 0.0)
    slack = said - up - low
    rise = 13.0 * np.tanh((up + 0.2 * slack + apart * 4.0 * state.mean("raise_")) / 13.0)
    bitten = style.lower * BITTEN * tucked(state, apart)
    gap = said + bitten + apart * (4.0 * state.mean("raise_") + 5.0 * state.mean("lower"))
    middle = (
        style.y
        + style.tubercle
        + 3.0 * state.jaw
        - 4.0 * state.chin
        - 1.6 * state.mean("raise_")
        - 3.4 * state.mean("nose")
    )
    middle = middle + 1.5 * state.mean("smile") - rise - 0.4 * bitten
    corner = [_corner(style, state, k, gap, puckered) for k in (0, 1)]
    inner_upper, inner_lower = _inner(style, state, middle, gap, apart, puckered, corner)
    upper, lower = _thickness(style, state, slack, apart, puckered)
    thick = upper, lower - 0.6 * bitten
    outer_upper, outer_lower = _outer(style, state, apart, inner_upper, inner_lower, thick, puckered, corner)
    drop = inner_lower[2][1] - style.y - style.tubercle
    dropped: Floats = np.asarray(drop, dtype=np.float64)
    return Lips(gap, apart, puckered, corner, inner_upper, inner_lower, outer_upper, outer_lower, dropped)


def tucked(state: MouthState, apart: Floats) -> Floats:
    """How far (0..1) the lower lip of a closed mouth lies under the upper teeth: drawn in further than the upper lip
    comes down, with teeth that show."""
    drawn_in = np.clip(-(state.upper + state.lower) / TUCKED, 0.0, 1.0)
    under: Floats = drawn_in * (1 - apart) * np.clip(state.teeth / BARED, 0.0, 1.0)
    return under


def _corner(style: MouthStyle, state: MouthState, k: int, gap: Floats, puckered: Floats) -> tuple[Number, Number]:
    side = state.sides[k]
    half = style.half_width * (1 - 0.34 * np.clip(side.pucker, 0, 1) * (1 - 0.4 * state.round) - 0.10 * state.round)
    half = (
        half
        + style.mw0 * state.wide
        + 7.0 * side.smile
        + 6.0 * side.stretch
        + 2.0 * side.frown
        - 2.5 * side.press
        + 1.0 * side.cheek
    )
    half = half + np.where(half < NARROW, NARROW - half - 10.0 * np.tanh((NARROW - half) / 10.0), 0.0)
    y = (
        style.y
        + style.corner
        - 9.5 * side.smile
        + 11.5 * side.frown
        - 1.0 * side.raise_
        + 1.5 * side.stretch
        - 2.6 * side.cheek
    )
    y = y + 2.0 * state.jaw + gap * lerp(0.10, 0.42, puckered) - _whole_rise(style, state) * 0.3 - 1.5 * state.chin
    return SIDES[k] * half, y


def _whole_rise(style: MouthStyle, state: MouthState) -> Floats:
    """How far (px) a mouth that shifts as a whole goes up."""
    shift: Floats = style.mns0 * (state.upper - state.lower) / 2
    return np.clip(shift, -6.0, 6.0)


def _inner(
    style: MouthStyle,
    state: MouthState,
    middle: Number,
    gap: Floats,
    apart: Floats,
    puckered: Floats,
    corner: list[tuple[Number, Number]],
) -> tuple[list[Spot], list[Spot]]:
    """The lips' inner edges: closed lips are one line, whatever the muscles say."""
    upper: list[Spot] = [(*corner[0], True)]
    lower: list[Spot] = [(*corner[0], True)]
    along_x = lerp(0.56, lerp(0.60, 0.68, puckered), apart)
    middles = (middle - style.tubercle * 0.4 * apart, middle + gap + 0.3 - style.tubercle * 0.4 * apart)
    for k in (0, 1):
        side, (x, y) = state.sides[k], corner[k]
        level = middle - style.tubercle * (1 - apart)
        along = lerp(0.86, lerp(0.74, 0.72, puckered), apart)
        top = lerp(y, level, along) - apart * (4.0 * side.raise_ + 1.5 * side.nose) - 1.0 * side.raise_
        bottom = top + 0.3 + gap * lerp(0.80, 0.76, puckered) + apart * (3.0 * side.lower + 2.0 * side.raise_)
        if k == 1:
            upper.append((0.0, middles[0]))
            lower.append((0.0, middles[1]))
        upper.append((x * along_x, top))
        lower.append((x * along_x, bottom))
    upper.append((*corner[1], True))
    lower.append((*corner[1], True))
    return upper, lower


def _thickness(
    style: MouthStyle, state: MouthState, slack: Floats, apart: Floats, puckered: Floats
) -> tuple[Number, Number]:
    """How thick upper and lower lip are at the middle: what the edges ask for, thinner where lips are drawn out."""
    drawn = 1 - 0.14 * state.mean("smile") - 0.16 * state.mean("stretch") - 0.50 * state.mean("press")
    drawn = drawn * (1 - 0.10 * apart * (1 - puckered)) + 0.14 * puckered * state.mean("pucker")
    share = (1 - 0.2 * slack / style.upper, 1 - 0.8 * slack / style.lower)
    soft = [1 + 0.38 * np.tanh((s - 1) / 0.38) for s in share]
    upper = style.upper * drawn * soft[0] + 1.0 * state.mean("raise_")
    lower = style.lower * drawn * soft[1] + 2.2 * state.chin + 1.2 * state.mean("frown")
    return upper, lower


def _outer(
    style: MouthStyle,
    state: MouthState,
    apart: Floats,
    inner_upper: list[Spot],
    inner_lower: list[Spot],
    thick: tuple[Number, Number],
    puckered: Floats,
    corner: list[tuple[Number, Number]],
) -> tuple[list[Spot], list[Spot]]:
    """The lips' outer edges: bow and sides above, the full lip below."""
    upper, lower = thick
    top, bottom = inner_upper[2][1], inner_lower[2][1]
    lifts = [3.4 * side.raise_ + 3.6 * side.nose for side in state.sides]
    dip = style.dip * (1 - 0.35 * puckered) - 0.45 * (lifts[0] + lifts[1])
    above: list[list[Spot]] = []
    below: list[list[Spot]] = []
    for k, row in ((0, 1), (1, 3)):
        x, y = corner[k]
        bow = style.bow * lerp(1.0, np.abs(x) / style.half_width, 0.55)
        bow = SIDES[k] * lerp(bow, np.maximum(bow, np.abs(x) * 0.36), puckered)
        plain = inner_upper[row][1] - upper * 0.62
        arched = y + 0.86 * (top - upper - y)
        high = (x * lerp(0.60, 0.72, puckered), lerp(plain, arched, puckered) - lifts[k] * 0.8)
        above.append([high, (bow, top - upper - style.tubercle * 0.5 - lifts[k] * 0.9)])
        plain = inner_lower[row][1] + lower * 0.64
        arched = y + 0.72 * (bottom + lower - y)
        sink = 3.0 * state.sides[k].lower
        flat = (x * lerp(lerp(0.66, 0.72, apart), 0.78, puckered), lerp(plain, arched, puckered) + sink)
        below.append([flat, (x * lerp(0.30, 0.40, apart), bottom + lower - 0.5 + sink)])
    middle: Spot = (0.0, top - upper + dip)
    return [*above[0], middle, *above[1][::-1]], [*below[0], *below[1][::-1]]
