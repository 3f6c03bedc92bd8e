"""Lids, gaze and the muscles round an eye -> its outlines: ball, iris, lids, lashes, crease."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facescript.rig.cartoon.depth import BALL
from facescript.rig.cartoon.pen import Floats, Number, Pen, Spot, lerp, step

ALONG = (-1.0, -0.58, 0.06, 0.62, 1.0)
"""Where the lids' five points stand across the eye, from the inner to the outer corner."""

CREASE_ALONG = (-0.90, -0.52, 0.08, 0.66, 1.12)


@dataclass(frozen=True, slots=True)
class EyeStyle:
    """One face's eye, px: half width, height above and below, corners, iris, crease, line and lashes.

    `top` and `bottom` are how much of the height the lids keep a third from the inner corner and a third from the
    outer; `knit` how many times as far as a human's lowered brows press the upper lid down; `sink` how far the corners
    of a shut eye go down; `hollow` how deep the shade round the eye reaches; `rim`
    how far a dark ring stands out around the lids; `pupil` its part of the iris; `curve` how far the lids fall back
    towards the corners and `slant` how much farther the outer corner lies back than the inner.
    """

    half_width: float
    up: float
    down: float
    inner: float
    outer: float
    iris: float
    iris_y: float
    crease: tuple[float, float, float, float, float]
    crease_width: float
    shade: float
    line: tuple[float, float, float, float, float]
    wing: tuple[float, float]
    lash: tuple[tuple[float, float, float], ...] = ()
    """Each lash: where along the eye it grows, its length, its angle above the horizontal outwards (deg)."""
    top: tuple[float, float] = (0.70, 0.80)
    bottom: tuple[float, float] = (0.62, 0.70)
    knit: float = 1.0
    sink: float = 0.0
    hollow: float = 19.0
    rim: float = 0.0
    pupil: float = 0.43
    curve: float = 0.0
    slant: float = 0.0


@dataclass(frozen=True, slots=True)
class EyeState:
    """One eye over frames: `opening` 0 shut, 1 rest; gaze in radians; muscles 0..1; size and shift of the whole."""

    opening: Floats
    yaw: Floats
    pitch: Floats
    roll: Floats
    pupil: Floats
    cheek: Floats
    nose: Floats
    frown: Floats
    raised: Floats


@dataclass(frozen=True, slots=True)
class _Lids:
    """The lids' points over frames: x of the five, y of the upper and lower edge, how far shut (0..1)."""

    x: list[Number]
    upper: list[Number]
    lower: list[Number]
    crease: list[Spot]
    shut: Floats
    open: Floats


def draw_eye(pen: Pen, style: EyeStyle, d: float, side: int, name: str, state: EyeState) -> None:
    """Draw the eye on the image's right (`side` 1, the face's left) or left (-1) into `pen`; ids end in `name`."""
    lids = _lids(style, d, side, state)
    _socket(pen, style, d, side, name, lids)
    _ball(pen, style, d, side, name, state)
    _under_lid(pen, style, name, lids)
    _lower_lid(pen, style, d, side, name, lids, state)
    _upper_line(pen, style, d, side, name, lids)
    for lash in style.lash:
        _lash(pen, style, d, side, name, lids, lash)
    if style.rim:
        _rim(pen, style, d, side, name, lids)
    if style.curve:
        _set_depths(pen, style, d, side, name)


def _x(style: EyeStyle, d: float, side: int, along: float) -> float:
    return side * (d / 2 + along * style.half_width)


def _lids(style: EyeStyle, d: float, side: int, state: EyeState) -> _Lids:
    narrow = 1 - 0.13 * state.cheek - 0.14 * state.nose - 0.12 * state.frown
    opening = np.maximum(state.opening, 0.0) * narrow
    shut = 1 - np.minimum(opening, 1.0)
    wide = np.minimum(opening, 1.0) + 0.8 * np.maximum(opening - 1, 0.0)
    below = np.sin(-state.pitch)
    sinks = 9.0 * (below + np.sqrt(below * below + 0.01) - 0.1)
    lift = 6.0 * state.cheek + 3.2 * state.nose + 1.2 * shut - sinks
    corner = style.outer + (5.5 + style.sink) * shut - 1.2 * state.cheek
    near, far = style.bottom
    nook = style.inner + style.sink * shut
    down: tuple[Number, ...] = (nook, style.down * near, style.down, style.down * far, corner)
    lower: list[Number] = [y - lift * k for y, k in zip(down, (0, 0.7, 1.0, 0.8, 0), strict=True)]
    rest = (style.inner, -style.up * style.top[0], -style.up, -style.up * style.top[1], style.outer)
    press = tuple(style.knit * px for px in (0.0, 3.0, 1.6, 0.2, 0.0))
    upper: list[Number] = []
    for i in range(5):
        closed = lower[i] + (0, 0.4, 1.0, 0.6, 0)[i]
        top = rest[i] + press[i] * state.frown
        upper.append(lower[i] if i in (0, 4) else closed + (top - closed) * wide)
    follows = 0.30 + 0.25 * step(0.8, 1.2, wide)
    crease = [
        (
            _x(style, d, side, u),
            style.crease[i] + (upper[i] - rest[i]) * follows - 2.0 * state.raised + 2.2 * state.frown,
        )
        for i, u in enumerate(CREASE_ALONG)
    ]
    return _Lids([_x(style, d, side, u) for u in ALONG], upper, lower, list(crease), shut, np.minimum(wide, 1.0))


def _socket(pen: Pen, style: EyeStyle, d: float, side: int, name: str, lids: _Lids) -> None:
    """The soft hollow under the brow, the lid's skin between crease and edge, and the white."""
    cy = [spot[1] for spot in lids.crease]
    at = [_x(style, d, side, u) for u in (-1.12, -0.98, 0.1, 1.1, 1.35, 1.12, 0.0, -1.0)]
    deep = style.hollow
    ys = (-7.0, cy[1] - 12, cy[2] - 11, cy[3] - 11, -8.0, deep * 15 / 19, deep, deep * 15 / 19)
    pen.loop(f"eye-socket-{name}", list(zip(at, ys, strict=True)))
    first, *inner, last = lids.crease
    edge = list(zip(lids.x, lids.upper, strict=True))
    corner = (_x(style, d, side, 1.02), lids.upper[4], True)
    pen.loop(
        f"eye-lid-{name}",
        [(*first[:2], True), *inner, (*last[:2], True), corner, *edge[3:0:-1], (edge[0][0], edge[0][1], True)],
    )
    low = list(zip(lids.x, lids.lower, strict=True))
    pen.loop(
        f"eye-white-{name}",
        [(edge[0][0], edge[0][1], True), *edge[1:4], (edge[4][0], edge[4][1], True), *low[3:0:-1]],
    )
    pen.ribbon(
        f"eye-crease-{name}",
        [
            (spot[0], spot[1], width)
            for spot, width in zip(
                lids.crease, [0.01, *(style.crease_width * k for k in (0.8, 1.0, 1.1)), 0.01], strict=True
            )
        ],
    )


@dataclass(frozen=True, slots=True)
class _Plane:
    """A plane that touches the eyeball's front: its origin and its two directions, x, y, z over frames, px."""

    origin: list[Number]
    right: Sequence[Number]
    down: Sequence[Number]

    def put(
        self,
        pen: Pen,
        part: str,
        spots: Sequence[tuple[Number, Number]],
        sharp: bool = False,
        corners: tuple[int, ...] = (),
    ) -> None:
        """An outline given on the plane, px to the right and down; sharp all round, or at `corners` only."""
        x, y, z = ([self.origin[k] + u * self.right[k] + v * self.down[k] for u, v in spots] for k in range(3))
        pen.loop(part, [(a, b, sharp or i in corners) for i, (a, b) in enumerate(zip(x, y, strict=True))], z)


def _planes(style: EyeStyle, d: float, side: int, state: EyeState) -> tuple[_Plane, _Plane]:
    """The iris' plane, turned with the eye's yaw, pitch and roll; and the same without the roll."""
    sin_y, cos_y, sin_p, cos_p = np.sin(state.yaw), np.cos(state.yaw), np.sin(state.pitch), np.cos(state.pitch)
    sin_r, cos_r = np.sin(state.roll), np.cos(state.roll)
    ahead = (sin_y * cos_p, -sin_p, cos_y * cos_p)
    across: list[Number] = [cos_y, 0.0 * sin_y, -sin_y]
    down: list[Number] = [sin_y * sin_p, cos_p, cos_y * sin_p]
    middle = (side * d / 2, style.iris_y, 0.0)
    origin: list[Number] = [middle[k] + BALL * d * ahead[k] for k in range(3)]
    rolled = [across[k] * cos_r + down[k] * sin_r for k in range(3)]
    below = [down[k] * cos_r - across[k] * sin_r for k in range(3)]
    return _Plane(origin, rolled, below), _Plane(origin, across, down)


def _ball(pen: Pen, style: EyeStyle, d: float, side: int, name: str, state: EyeState) -> None:
    """Iris, its rays, pupil and lights as circles on a sphere: exact under rotation, foreshortened towards the rim."""
    iris, upright = _planes(style, d, side, state)
    circle = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
    r = style.iris
    iris.put(pen, f"eye-iris-{name}", [(r * u, r * v) for u, v in circle])
    for angle, spread in RAYS:
        wedge = ((angle - spread, 0.84), (angle + spread, 0.84), (angle, 0.46))
        iris.put(pen, f"eye-rays-{name}", [(r * k * math.cos(a), r * k * math.sin(a)) for a, k in wedge], sharp=True)
    pupil = style.pupil * r * np.clip(state.pupil, 0.3, 1.9)
    iris.put(pen, f"eye-pupil-{name}", [(pupil * u, pupil * v) for u, v in circle])
    upright.put(pen, f"eye-glow-{name}", [(r * u, r * v) for u, v in GLOW], corners=(0, 2))
    for x, y, size in LIGHTS:
        upright.put(pen, f"eye-light-{name}", [(r * (x + size * u), r * (y + size * v)) for u, v in circle])


LIGHTS = ((-0.36, -0.40, 0.25), (0.40, 0.42, 0.11))
"""Two reflections: place and size as parts of the iris' radius."""

GLOW = ((-0.62, 0.22), (0.0, 0.76), (0.62, 0.22), (0.0, 0.46))
"""The light that comes through the iris from above: a crescent below the pupil, in parts of the iris' radius."""

RAYS = tuple(
    (math.radians(a), math.radians(w))
    for a, w in ((12, 9), (52, 11), (88, 10), (130, 12), (166, 8), (204, 9), (335, 9))
)
"""Lighter fibres of the iris: angle and half width; uneven, so that a rolling eye is seen to roll."""


def _under_lid(pen: Pen, style: EyeStyle, name: str, lids: _Lids) -> None:
    """The shadow that the upper lid casts on the ball."""
    top: list[Spot] = [(lids.x[i], lids.upper[i] - 4) for i in (1, 2, 3)]
    low: list[Spot] = [(lids.x[i], lids.upper[i] + style.shade * lids.open) for i in (3, 2, 1)]
    ends = [(lids.x[i], lids.upper[i] - 3, True) for i in (0, 4)]
    pen.loop(f"eye-shade-{name}", [ends[0], *top, ends[1], *low])


def _lower_lid(pen: Pen, style: EyeStyle, d: float, side: int, name: str, lids: _Lids, state: EyeState) -> None:
    """The soft line under the eye, and the lines that a smile of the eyes draws beside it."""
    x = [_x(style, d, side, u) for u in (-0.55, 0.06, 0.62, 1.0)]
    low = [y + 1.4 * style.rim for y in lids.lower]
    pen.ribbon(
        f"eye-lowerlid-{name}",
        [(x[0], low[1] + 1.2, 0.01), (x[1], low[2] + 1.4, 1.2), (x[2], low[3] + 1.4, 1.8), (x[3], low[4] + 0.6, 1.2)],
    )
    pouch = 1.5 * state.cheek
    u = [_x(style, d, side, k) for k in (-0.62, -0.1, 0.46, 0.9)]
    pen.ribbon(
        f"eye-pouch-{name}",
        [
            (u[0], low[1] + 8 - pouch, 0.01),
            (u[1], low[2] + 7.5 - pouch, 2.0),
            (u[2], low[3] + 8 - pouch, 1.8),
            (u[3], low[4] + 11 - pouch, 0.01),
        ],
    )
    corner_x, corner_y = _x(style, d, side, 1.0), low[4]
    for reach, rise, start in ((15.0, -5.0, -1.5), (16.0, 2.5, 2.5), (13.0, 9.0, 6.0)):
        from_x = corner_x + side * 9.0
        pen.ribbon(
            f"eye-crows-{name}",
            [
                (from_x, corner_y + start, 0.01),
                (from_x + side * reach * 0.5, corner_y + lerp(start, rise, 0.45) + 0.6, 1.7),
                (from_x + side * reach, corner_y + rise, 0.01),
            ],
        )


def _upper_line(pen: Pen, style: EyeStyle, d: float, side: int, name: str, lids: _Lids) -> None:
    """The dark edge of the upper lid, thickest two thirds outwards, with its wing."""
    shut, thick = lids.shut, style.line
    top: list[Spot] = [(_x(style, d, side, -1.03), lids.upper[0] + 0.2, True)]
    top += [(lids.x[i], lids.upper[i] - thick[i] * (1 - 0.25 * shut)) for i in (1, 2, 3)]
    if not style.rim:
        top.append((_x(style, d, side, 0.98), lids.upper[4] - thick[4] * (1 - 0.75 * shut)))
    tip: Spot = (_x(style, d, side, 1.0) + side * style.wing[0], lids.upper[4] + lerp(style.wing[1], 1.6, shut), True)
    low: list[Spot] = [(_x(style, d, side, 1.0), lids.upper[4] + 0.8, True)]
    low += [(lids.x[i], lids.upper[i] + 0.7) for i in (3, 2, 1)]
    pen.loop(f"eye-line-{name}", [*top, tip, *low])


def _lash(
    pen: Pen, style: EyeStyle, d: float, side: int, name: str, lids: _Lids, lash: tuple[float, float, float]
) -> None:
    """A lash rooted in the lid's line; it bows up, and swings below the horizontal as the eye shuts."""
    along, length, angle = lash
    i, t = (3, (along - ALONG[3]) / (ALONG[4] - ALONG[3])) if along > ALONG[3] else (2, (along - 0.06) / 0.56)
    thick = lerp(style.line[i], style.line[i + 1], t) * (1 - 0.5 * lids.shut)
    root = lerp(lids.upper[i], lids.upper[i + 1], t) - thick * lerp(0.55, -0.05, lids.shut)
    swing = np.radians(lerp(angle, 2 - 0.9 * angle, lids.shut * lids.shut * (3 - 2 * lids.shut)))
    cosine, sine = np.cos(swing), np.sin(swing)
    x, width = _x(style, d, side, along), 2.1
    bow = 0.16 * length
    mid_x = x + side * (0.5 * length * cosine + bow * sine * (1 - lids.shut) + 0.4 * bow * lids.shut)
    mid_y = root - 0.5 * length * sine + bow * cosine * lerp(1.0, -0.3, lids.shut)
    base = lerp(0.8, -0.8, lids.shut)
    thin = side * width * 0.34
    pen.loop(
        f"eye-lashes-{name}",
        [
            (x - side * width * 0.8, root + base, True),
            (mid_x - thin, mid_y - 0.2),
            (x + side * length * cosine, root - length * sine, True),
            (mid_x + thin, mid_y + 0.2),
            (x + side * width * 0.8, root + base, True),
        ],
    )


def _rim(pen: Pen, style: EyeStyle, d: float, side: int, name: str, lids: _Lids) -> None:
    """The dark skin that rings an animal's eye: the lids' edges, moved outwards."""
    rim, far = style.rim, 1 + style.rim / style.half_width
    x = [_x(style, d, side, u * far) for u in ALONG]
    high = [(x[i], lids.upper[i] - 0.9 * rim) for i in (1, 2, 3)]
    low = [(x[i], lids.lower[i] + 0.8 * rim) for i in (3, 2, 1)]
    rises = 4.0 * lids.shut
    ends: list[Spot] = [(x[0], lids.upper[0] + 1.5 - rises, True), (x[4], lids.upper[4] - rises, True)]
    pen.loop(f"eye-rim-{name}", [ends[0], *high, ends[1], *low])


def _set_depths(pen: Pen, style: EyeStyle, d: float, side: int, name: str) -> None:
    """How far (px) each point of the lids falls back from the eye's middle: lids lie round the ball."""
    for part in LYING:
        spots = [spot for loop in pen.loops.get(f"{part}-{name}", ()) for spot in loop]
        along = [(spot[0] * side - d / 2) / style.half_width for spot in spots]
        pen.depth[f"{part}-{name}"] = [-style.curve * u * u - style.slant * u for u in along]


LYING = tuple(f"eye-{part}" for part in "socket lid rim white shade pouch crows lowerlid line lashes crease".split())
"""The parts of an eye that are not on the ball."""
