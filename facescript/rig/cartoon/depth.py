"""Where an anchor lies at rest -> how deep it lies in the head, and so how a turn of the head moves it.

Depths are multiples of the eye distance d in front of the neck's axis, after the third seed's Table 2.1, drawn with
84 % of its relief. x to the viewer's right, y down, both in d from the eyes' middle.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

RELIEF = 0.84
AXIS = 0.2
"""Relief is taken about this depth: z = 0.2 + 0.84 (table - 0.2)."""

LOWEST = 0.8
"""Hair that hangs beside the jaw keeps the outline's depth at this height (d)."""

BALL = 0.3
"""The eyeball's radius in d (third seed, 2.4.3.2)."""

TABLE_YAW = math.radians(25)
"""NEAR and FAR are drawn for this yaw; in between and beyond, the outline's depth goes with the sine."""

FAR = (
    (-1.6, 0.30),
    (-1.0, 0.72),
    (-0.45, 0.80),
    (0, 0.62),
    (0.36, 0.79),
    (0.79, 0.69),
    (1.15, 0.84),
    (1.42, 1.16),
    (1.55, 1.30),
)
NEAR = (
    (-1.6, 0.30),
    (-1.0, 0.36),
    (-0.45, 0.12),
    (0, 0.04),
    (0.39, 0),
    (0.79, 0.06),
    (1.15, 0.44),
    (1.42, 1.0),
    (1.55, 1.30),
)
"""Depth of the face's outline by height, on the side turned away (temple, dent at the eye, cheekbone, chin) and on the
side turned to the viewer (ear to chin): the contour handover of Algorithm 2.3, without its jump."""

UNDER = ((0.36, 0.0), (0.79, 0.06), (1.15, 0.26), (1.42, 0.44), (1.55, 0.48))
"""How far (d, by height) the outline slides back under the jaw as the head tips back, with the sine of pitch: so a chin
seen from below is a bow and not the edge of a board."""


@dataclass(frozen=True, slots=True)
class Depth:
    """How one anchor turns: depth at yaw 0 (d), how much it slides with the sine of yaw and back under the jaw with
    that of pitch, how far the relief flattens at large yaw, how much it belongs to the skull's silhouette and to a
    neck as wide from all sides (0..1), how much it follows the head (0..1), and how much it follows the trunk's own
    small turn (d)."""

    z: float
    slide: float = 0.0
    under: float = 0.0
    flatten: float = 0.0
    silhouette: float = 0.0
    barrel: float = 0.0
    follow: float = 1.0
    trunk: float = 0.0


@dataclass(frozen=True, slots=True)
class Head:
    """What depth needs of a face: half width of its outline by height, the hair shell's half width and height (d)."""

    outline: Sequence[tuple[float, float]]
    shell: tuple[float, float]


def smooth(low: float, high: float, value: float) -> float:
    """0 at `low`, 1 at `high` and beyond, a smooth step between."""
    t = min(1.0, max(0.0, (value - low) / (high - low)))
    return t * t * (3 - 2 * t)


def mix(a: float, b: float, t: float) -> float:
    return a + (b - a) * t


def relief(table: float) -> float:
    return AXIS + RELIEF * (table - AXIS)


def lookup(table: Sequence[tuple[float, float]], at: float) -> float:
    """Linear between the rows of `table`, constant beyond."""
    if at <= table[0][0]:
        return table[0][1]
    for (a, u), (b, v) in pairwise(table):
        if at <= b:
            return mix(u, v, (at - a) / (b - a))
    return table[-1][1]


def front(x: float) -> float:
    """The face's surface at a distance x from the middle, in the table's relief."""
    return 1.46 - 0.73 * math.pow(min(abs(x), 1.12), 3.6)


def _sliding(near: float, far: float, x: float) -> tuple[float, float]:
    """Depth at yaw 0 and slide of an outline anchor that is `far` deep when its side turns away, `near` otherwise."""
    right, left = (mix(near, far, smooth(-0.35, 0.35, side)) for side in (x, -x))
    return (right + left) / 2, (right - left) / 2 / math.sin(TABLE_YAW)


def plain(x: float, y: float, head: Head) -> Depth:
    """As deep as is written, and no more."""
    return Depth(0.0)


def shell(x: float, y: float, head: Head) -> Depth:
    """As deep as is written, on an outline that is a ball's: turned, it does not narrow like a card."""
    return Depth(0.0, silhouette=BALL_LIKE)


BALL_LIKE = 0.7
"""How much a shell is a ball: its half width shrinks by 0.3 (1 - cos) in a turn."""


def contour(x: float, y: float, head: Head) -> Depth:
    z, slide = _sliding(relief(lookup(NEAR, y)), relief(lookup(FAR, y)), x)
    return Depth(z, slide, lookup(UNDER, y))


def skin(x: float, y: float, head: Head) -> Depth:
    """On the face's surface: a feature in the middle, the outline's depth at the sides; the forehead recedes."""
    edge = contour(x, y, head)
    t = smooth(0.70, 1.02, abs(x))
    brow = front(x) - 0.32 * smooth(0.75, 1.3, -y)
    return Depth(mix(relief(brow), edge.z, t), edge.slide * t, edge.under * t, 0.16 * (1 - t))


def nose(x: float, y: float, head: Head) -> Depth:
    """The ridge rises from the eyes to the tip; the nostrils' base lies back, so that it shows from below."""
    ridge = 0.42 * math.exp(-((x / 0.17) ** 2)) * smooth(-0.25, 0.52, y) * (1 - smooth(0.54, 0.80, y))
    return Depth(relief(front(x) + ridge), flatten=0.16)


def eye(x: float, y: float, head: Head) -> Depth:
    u = min(1.6, max(-1.4, (abs(x) - 0.5) / 0.25))
    return Depth(relief(1.34 - 0.12 * u * u - 0.07 * u), flatten=0.16)


def ball(x: float, y: float, head: Head) -> Depth:
    """The eyeball's middle; what is drawn on it stands out by itself."""
    return Depth(relief(1.34) - BALL, flatten=0.16)


def brow(x: float, y: float, head: Head) -> Depth:
    """A little before the skin; its tail falls back less than the temple, or it would fold as its side turns away."""
    return Depth(relief(front(min(abs(x), 0.86)) + 0.05), flatten=0.16)


def mouth(x: float, y: float, head: Head) -> Depth:
    return Depth(relief(1.40 + 0.19 * max(0.0, 1 - (x / 0.42) ** 2)), flatten=0.16)


def rigid(x: float, y: float, head: Head) -> Depth:
    """What lies in the mouth or on the lips and keeps its form: a card at the mouth's depth."""
    return Depth(relief(1.55), flatten=0.16)


def under_jaw(x: float, y: float, head: Head) -> Depth:
    """Behind the jaw's edge: what shows below it when the head tips back."""
    edge = contour(x, y, head)
    return Depth(mix(0.28, edge.z, 0.42), edge.slide * 0.42)


def ear(x: float, y: float, head: Head) -> Depth:
    return Depth(-0.12 - 0.20 * smooth(1.02, 1.25, abs(x)))


def hair(x: float, y: float, head: Head) -> Depth:
    """A curved shell: just above the skin, on the crown a ball, beside the face bound to its outline (so that the far
    locks stay behind the far cheek), and hanging below the jaw."""
    wide, high = head.shell
    round_ = min(1.0, math.hypot(x / wide, min(y, 0) / high))
    crest = mix(1.62, 0.65, smooth(-1.2, -0.2, y))
    rim = smooth(0.72, 1.0, round_)
    ball = 0.115 + (crest - 0.115) * math.sqrt(1 - round_ * round_) * (1 - rim)
    level = min(y, LOWEST)
    skull, edge = skin(x, y, head), contour(x, level, head)
    half = lookup(head.outline, level) + 0.08
    aside, outside = smooth(0.90, 1.02, abs(x) / half), smooth(1.0, 1.24, abs(x) / half)
    z, slide = mix(skull.z + 0.08, edge.z + 0.03, aside), mix(skull.slide, edge.slide, aside)
    t = max(outside, smooth(1.1, 1.5, -y))
    over = Depth(mix(z, ball, t), slide * (1 - t), flatten=skull.flatten * (1 - aside) * (1 - t))
    return replace(over, silhouette=t * rim, follow=_hanging(y))


def hair_side(x: float, y: float, head: Head) -> Depth:
    """Short hair at the temples: just above the skin, and at the outline one with it, so that no skin shows beside."""
    under = skin(x, y, head)
    return replace(under, z=under.z + 0.05 * (1 - smooth(0.70, 1.02, abs(x))))


def hair_back(x: float, y: float, head: Head) -> Depth:
    return Depth(0.115, silhouette=1.0, follow=_hanging(y))


def _hanging(y: float) -> float:
    return 1 - 0.65 * smooth(0.5, 2.4, y)


def neck(x: float, y: float, head: Head) -> Depth:
    return Depth(0.20, barrel=1.0, follow=1 - smooth(0.7, 1.94, y), trunk=0.15)


def neck_shadow(x: float, y: float, head: Head) -> Depth:
    return Depth(0.62, follow=1 - smooth(1.0, 2.85, y), trunk=0.15)


def body(x: float, y: float, head: Head) -> Depth:
    """Shoulders and chest: the middle of the chest lies in front of the trunk's axis."""
    return Depth(0.0, follow=0.0, trunk=0.75 * (1 - smooth(0.3, 2.2, abs(x))))


LAWS: dict[str, Callable[[float, float, Head], Depth]] = {
    law.__name__: law
    for law in (
        plain,
        shell,
        contour,
        skin,
        nose,
        eye,
        ball,
        brow,
        mouth,
        rigid,
        under_jaw,
        ear,
        hair,
        hair_side,
        hair_back,
        neck,
        neck_shadow,
        body,
    )
}
"""Depth laws by the name that a part carries."""
