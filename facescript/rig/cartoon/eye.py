"""Lids, gaze and the muscles round an eye -> its outlines: ball, iris, lids, lashes, crease."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from facescript.rig.cartoon.depth import BALL
from facescript.rig.cartoon.pen import Floats, Number, Pen, Spot, lerp, step

ALONG = (-1.0, -0.58, 0.06, 0.62, 1.0)
"""Where the lids' five points stand across the eye, from the inner to the outer corner."""

CREASE_ALONG = (-0.90, -0.52, 0.08, 0.66, 1.12)


@dataclass(frozen=True, slots=True)
class EyeStyle:
    """One face's eye, px: half width, height above and below, corners, iris, crease, line and lashes."""

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
    lashes: tuple[tuple[float, float, float], ...] = ()
    """Each lash: where along the eye it grows, its length, its angle above the horizontal outwards (deg)."""


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
    for k, lash in enumerate(style.lashes):
        _lash(pen, style, d, side, name, lids, lash, last=k == len(style.lashes) - 1)


def _x(style: EyeStyle, d: float, side: int, along: float) -> float:
    return side * (d / 2 + along * style.half_width)


def _lids(style: EyeStyle, d: float, side: int, state: EyeState) -> _Lids:
    narrow = 1 - 0.10 * state.cheek - 0.14 * state.nose - 0.12 * state.frown
    opening = np.maximum(state.opening, 0.0) * np.where(state.opening > 0, narrow, 1.0)
    shut = 1 - np.minimum(opening, 1.0)
    wide = np.minimum(opening, 1.0) + 0.8 * np.maximum(opening - 1, 0.0)
    below = np.sin(-state.pitch)
    sinks = 4.0 * (below + np.sqrt(below * below + 0.01) - 0.1)
    lift = 4.8 * state.cheek + 3.2 * state.nose + 1.2 * shut - sinks
    corner = style.outer + 5.5 * shut - 1.2 * state.cheek
    down = (style.inner, style.down * 0.62, style.down, style.down * 0.70, corner)
    lower = [y - lift * k for y, k in zip(down, (0, 0.7, 1.0, 0.8, 0), strict=True)]
    rest = (style.inner, -style.up * 0.70, -style.up, -style.up * 0.80, style.outer)
    press = (0.0, 3.0, 1.6, 0.2, 0.0)
    upper: list[Number] = []
    for i in range(5):
        closed = lower[i] + (0, 0.4, 1.0, 0.6, 0)[i]
        top = rest[i] + press[i] * state.frown
        upper.append(lower[i] if i in (0, 4) else closed + (top - closed) * wide)
    follows = np.where(wide < 1, 0.30, 0.55)
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
    at = [_x(style, d, side, u) for u in (-1.12, -0.75, 0.1, 0.85, 1.35, 0.9, 0.0, -0.8)]
    ys = (-6.0, cy[1] - 9, cy[2] - 11, cy[3] - 8, -8.0, 12.0, 19.0, 12.0)
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


def _ball(pen: Pen, style: EyeStyle, d: float, side: int, name: str, state: EyeState) -> None:
    """Iris, its rays, pupil and lights as circles on a sphere: exact under rotation, foreshortened towards the rim."""
    radius = BALL * d
    sin_y, cos_y, sin_p, cos_p = np.sin(state.yaw), np.cos(state.yaw), np.sin(state.pitch), np.cos(state.pitch)
    ahead = (sin_y * cos_p, -sin_p, cos_y * cos_p)
    across = (cos_y, 0.0 * sin_y, -sin_y)
    down = (sin_y * sin_p, cos_p, cos_y * sin_p)
    sin_r, cos_r = np.sin(state.roll), np.cos(state.roll)
    right = [a * cos_r + b * sin_r for a, b in zip(across, down, strict=True)]
    below = [b * cos_r - a * sin_r for a, b in zip(across, down, strict=True)]
    middle = (side * d / 2, style.iris_y, 0.0)

    def put(
        part: str, spots: list[tuple[float, Number, Number]], basis: tuple[list[Number], list[Number]], sharp: bool
    ) -> None:
        """Spots are kind (1 on the sphere's front), right and down in px on the iris' plane."""
        xyz = [
            [middle[k] + radius * ahead[k] + u * basis[0][k] + v * basis[1][k] for k in range(3)] for _, u, v in spots
        ]
        pen.loop(part, [(p[0], p[1], sharp) for p in xyz], [p[2] for p in xyz])

    rolled = (list(right), list(below))
    upright: tuple[list[Number], list[Number]] = (list(across), list(down))
    circle = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
    r = style.iris
    put(f"eye-iris-{name}", [(1, r * u, r * v) for u, v in circle], rolled, sharp=False)
    for angle, spread in RAYS:
        wedge = [(angle - spread, 0.84), (angle + spread, 0.84), (angle, 0.46)]
        put(f"eye-rays-{name}", [(1, r * k * math.cos(a), r * k * math.sin(a)) for a, k in wedge], rolled, sharp=True)
    pupil = r * 0.43 * np.clip(state.pupil, 0.3, 1.9)
    put(f"eye-pupil-{name}", [(1, pupil * u, pupil * v) for u, v in circle], rolled, sharp=False)
    for x, y, rx, ry in ((-0.36, -0.40, 0.24, 0.26), (0.40, 0.42, 0.11, 0.11)):
        light = [(1, r * (x + rx * u), r * (y + ry * v)) for u, v in circle]
        put(f"eye-light-{name}", light, upright, sharp=False)


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
    low = lids.lower
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
    top.append((_x(style, d, side, 0.98), lids.upper[4] - thick[4] * (1 - 0.75 * shut)))
    tip: Spot = (_x(style, d, side, 1.0) + side * style.wing[0], lids.upper[4] + lerp(style.wing[1], 1.6, shut), True)
    low: list[Spot] = [(_x(style, d, side, 1.0), lids.upper[4] + 0.8, True)]
    low += [(lids.x[i], lids.upper[i] + 0.7) for i in (3, 2, 1)]
    pen.loop(f"eye-line-{name}", [*top, tip, *low])


def _lash(
    pen: Pen, style: EyeStyle, d: float, side: int, name: str, lids: _Lids, lash: tuple[float, float, float], last: bool
) -> None:
    """A lash rooted in the lid's line; it swings below the horizontal as the eye shuts."""
    along, length, angle = lash
    outer = along > ALONG[3]
    i, t = (3, (along - 0.62) / 0.38) if outer else (2, (along - 0.06) / 0.56)
    root = lerp(lids.upper[i] - style.line[i] * 0.5, lids.upper[i + 1] - style.line[i + 1] * 0.4, t)
    root = root + 1.4 * lids.shut
    swing = np.radians(lerp(angle, 4 - angle, lids.shut * lids.shut))
    cosine, sine = np.cos(swing), np.sin(swing)
    x = _x(style, d, side, along)
    bow = 1.5 * step(-0.5, 0.5, sine) - 0.75
    width = 1.7
    tip_x, tip_y = x + side * length * cosine, root - length * sine
    mid_x, mid_y = (
        x + side * length * (0.45 * cosine + bow * 0.12 * sine),
        root - length * (0.45 * sine - bow * 0.12 * cosine),
    )
    off_x, off_y = side * width * 0.5 * sine, width * 0.5 * cosine
    pen.loop(
        f"eye-lashes-{name}",
        [
            (x - side * width * 1.1, root + 0.9, True),
            (mid_x - off_x, mid_y - off_y),
            (tip_x, tip_y, True),
            (mid_x + off_x, mid_y + off_y),
            (x + side * width * 1.1, root + 0.9, True),
        ],
    )
