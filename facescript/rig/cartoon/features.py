"""The third seed's feature points: 72 of a face, 17 helpers, what each is in the drawing, and the units they span.

MPEG-4's names; even numbers and R, A, J, L, N are the face's right (the image's left). Depths are Table 2.1's, in d.
A point is either where parts have an anchor (so that it moves exactly as drawn), or a spot of its own on the head.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from facescript.rig.cartoon.outline import Part, loop
from facescript.rig.cartoon.style import FaceStyle

GROUP = "features"
"""Group of the parts that hold spots of their own; they are never drawn."""

HAIR_DEPTH = -0.58

DEPTHS: dict[str, float] = {
    **dict.fromkeys(("3.1", "3.2", "3.3", "3.4", "EyeballLeft", "EyeballRight"), 1.33),
    **dict.fromkeys(("3.7", "3.12"), 1.19),
    **dict.fromkeys(("3.8", "3.11"), 1.25),
    **dict.fromkeys(("4.5", "4.6"), 1.17),
    **dict.fromkeys(("4.3a", "4.4a", "F", "I"), 1.30),
    **dict.fromkeys(("4.3", "4.4", "G", "H"), 1.44),
    **dict.fromkeys(("4.1", "4.2"), 1.49),
    **dict.fromkeys(("2.2", "2.3"), 1.55),
    **dict.fromkeys(("8.3", "8.4", "R", "S"), 1.40),
    **dict.fromkeys(("8.1", "8.9", "8.10"), 1.60),
    "8.2": 1.56,
    **dict.fromkeys(("2.13", "2.14"), 0.36),
    "2.1": 1.33,
    **dict.fromkeys(("J", "K"), 1.18),
    "11.1": 1.37,
    **dict.fromkeys(("11.2a", "11.3a"), 0.90),
    **dict.fromkeys(("11.2", "11.3"), 0.42),
    **dict.fromkeys(("N", "Q"), 0.85),
    **dict.fromkeys(("10.1", "10.2"), -0.37),
    **dict.fromkeys(("10.7", "10.8"), 0.0),
    **dict.fromkeys(("A", "B"), 0.04),
    **dict.fromkeys(("9.1", "9.2", "9.6", "9.7"), 1.39),
    **dict.fromkeys(("9.13", "9.14"), 1.40),
    **dict.fromkeys(("9.4", "9.5"), 1.44),
    "9.15": 1.65,
    "C": 1.51,
    **dict.fromkeys(("D", "E"), 1.53),
    **dict.fromkeys(("10.9", "10.10"), 0.27),
    **dict.fromkeys(("L", "M"), 1.11),
    **{f"hair{k}": HAIR_DEPTH for k in range(1, 24)},
}
"""Table 2.1: the 72 feature points and 17 helpers by name, with their depth in d."""

HELPERS = tuple("ABCDEFGHIJKLMNQRS")
NAMES = tuple(name for name in DEPTHS if name not in HELPERS) + HELPERS
"""The order of `features`: the 72 points, then the 17 helpers."""


@dataclass(frozen=True, slots=True)
class Source:
    """A feature point as the mean of anchors of one part, by their numbers."""

    part: str
    anchors: tuple[int, ...]


DRAWN: dict[str, Source] = {
    "3.7": Source("eye-white-left", (4,)),
    "3.1": Source("eye-white-left", (2,)),
    "3.11": Source("eye-white-left", (0,)),
    "3.3": Source("eye-white-left", (6,)),
    "EyeballLeft": Source("eye-iris-left", (0, 2)),
    "3.12": Source("eye-white-right", (4,)),
    "3.2": Source("eye-white-right", (2,)),
    "3.8": Source("eye-white-right", (0,)),
    "3.4": Source("eye-white-right", (6,)),
    "EyeballRight": Source("eye-iris-right", (0, 2)),
    "4.1": Source("brow-body-left", (0, 1)),
    "4.3": Source("brow-body-left", (2,)),
    "4.3a": Source("brow-body-left", (3,)),
    "4.5": Source("brow-body-left", (4,)),
    "I": Source("brow-body-left", (5,)),
    "H": Source("brow-body-left", (6,)),
    "4.2": Source("brow-body-right", (7, 6)),
    "4.4": Source("brow-body-right", (5,)),
    "4.4a": Source("brow-body-right", (4,)),
    "4.6": Source("brow-body-right", (3,)),
    "F": Source("brow-body-right", (2,)),
    "G": Source("brow-body-right", (1,)),
    "8.1": Source("mouth-lip-upper", (3,)),
    "8.9": Source("mouth-lip-upper", (2,)),
    "8.10": Source("mouth-lip-upper", (4,)),
    "8.2": Source("mouth-lip-lower", (2, 3)),
    "8.4": Source("mouth-cavity", (0,)),
    "8.3": Source("mouth-cavity", (4,)),
    "R": Source("mouth-cavity", (0,)),
    "S": Source("mouth-cavity", (4,)),
    "2.2": Source("mouth-lip-upper", (8,)),
    "2.3": Source("mouth-lip-lower", (7,)),
    "2.1": Source("face-skin", (10,)),
    "2.13": Source("face-skin", (6,)),
    "2.14": Source("face-skin", (14,)),
    "10.9": Source("face-skin", (5,)),
    "10.10": Source("face-skin", (15,)),
    "11.3": Source("face-skin", (3,)),
    "11.2": Source("face-skin", (17,)),
}
"""Points that the drawing has; the brows' lower edge is where Algorithm 2.1 puts F, G, H and I."""


def spots(style: FaceStyle) -> dict[str, dict[str, tuple[float, float]]]:
    """Points of their own at rest, px, by the part that holds them; helpers after Algorithm 2.1, step 4."""
    y, width, k = style.nose_base, style.nose_width, style.nose_width / 20
    top, low = style.points["ear-top"], style.points["ear-low"]
    chin, jaw, cheek, temple = (style.outline[i] for i in (10, 6, 5, 3))
    outer = style.d / 2 + style.eyes[0].style.half_width
    nose = _pairs(
        {
            ("9.7", "9.6"): (9 * k, -14),
            ("9.13", "9.14"): (12 * k, y - 34),
            ("9.1", "9.2"): (width + 1, y - 9),
            ("9.5", "9.4"): (0.7 * width, y - 1),
            ("E", "D"): (0.7 * width * 4 / 6, y - 1 - 33 / 3),
        }
    )
    skin = _pairs(
        {
            ("11.3a", "11.2a"): style.points["temple"],
            ("K", "J"): ((5 * jaw[0] + chin[0]) / 6, jaw[1]),
            ("M", "L"): ((outer + cheek[0]) / 2, cheek[1]),
            ("Q", "N"): temple,
        }
    )
    ear = _pairs({("10.1", "10.2"): top, ("10.7", "10.8"): low, ("B", "A"): (low[0] - 4, (4 * top[1] + low[1]) / 5)})
    return {
        "nose-features": nose | {"9.15": (0.0, style.mouth.nose_base), "C": (0.0, (y - 34) / 2)},
        "face-features": skin | {"11.1": style.points["hairline"]},
        "ear-features": ear,
        "hair-features": {f"hair{i}": spot for i, spot in enumerate(style.hair, 1)},
    }


def feature_parts(style: FaceStyle) -> tuple[Part, ...]:
    """Parts that hold the points of their own, to be deformed and turned with the rest."""
    if not style.points:
        return ()
    laws = {"nose-features": "nose", "face-features": "skin", "ear-features": "ear", "hair-features": "hair"}
    return tuple(
        Part(name, GROUP, laws[name], "#000000", (loop(*held.values()),)) for name, held in spots(style).items()
    )


def rows_of(style: FaceStyle, rows: Mapping[str, slice]) -> tuple[tuple[int, ...], ...]:
    """For each of `NAMES`, the anchors whose mean it is."""
    if not style.points:
        return ()
    own = {name: (part, i) for part, held in spots(style).items() for i, name in enumerate(held)}
    out = []
    for name in NAMES:
        part, anchors = (DRAWN[name].part, DRAWN[name].anchors) if name in DRAWN else (own[name][0], (own[name][1],))
        out.append(tuple(rows[part].start + i for i in anchors))
    return tuple(out)


def _pairs(half: Mapping[tuple[str, str], tuple[float, float]]) -> dict[str, tuple[float, float]]:
    """Both points of each pair from that on the image's right (the face's left)."""
    out = {}
    for (left, right), (x, y) in half.items():
        out[left], out[right] = (x, y), (-x, y)
    return out


@dataclass(frozen=True, slots=True)
class Units:
    """The facial animation parameter units of MPEG-4, px: eye separation, eye to nose, mouth to nose, mouth width,
    iris diameter."""

    es0: float
    ens0: float
    mns0: float
    mw0: float
    irisd0: float


def units(at: Mapping[str, tuple[float, float]], iris: float) -> Units:
    """The units of a face from its feature points at rest (px) and its iris' radius."""
    left, right = at["EyeballLeft"], at["EyeballRight"]
    eyes = (left[1] + right[1]) / 2
    nose = at["9.15"][1]
    return Units(left[0] - right[0], nose - eyes, at["2.2"][1] - nose, at["8.3"][0] - at["8.4"][0], 2 * iris)
