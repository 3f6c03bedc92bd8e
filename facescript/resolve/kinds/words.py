"""What stands in a kind: its rows, layers, laws of depth, measures and live shapes, by name."""

from __future__ import annotations

from collections.abc import Mapping

ROWS: Mapping[str, str] = {
    "voice": "voice LANGUAGE",
    "has": "has CHANNEL, CHANNEL",
    "colours": "colours NAME #rrggbb, NAME #rrggbb",
    "outline": "outline (0 -180) (60 -168) (0 176)",
    "shell": "shell WIDTH HEIGHT",
    "nose": "nose base 72, width 20",
    "jaw": "jaw from 62, drop 24",
    "eye": "eye half-width 31, up 17, down 11",
    "mouth": "mouth y 111, half-width 41",
    "point": "point NAME (0 -128)",
    "locks": "locks (0 -200) (60 -190)",
    "tints": "tints FAMILY NAME #rrggbb, NAME #rrggbb with SKIN",
    "look": "look NAME CHOICE, CHOICE",
    "amount": "amount NAME 30%",
    "shape": "shape NAME, in LAYER, law LAW, fill COLOUR, outline POINTS",
    "muscle": "muscle MUSCLE, moves SHAPE, by (0 -17)",
    "shade": "shade SHAPE, MUSCLE 50%, at most 60%",
}
"""The rows of a kind by their first word, each as it is written."""

LOOKS = ("hair", "clothes", "beard", "eyebrows", "glasses", "earrings")
"""What a kind may have choices of."""

AMOUNTS = ("age", "width", "make-up", "freckles")
"""What a kind may have an amount of."""

TINTED = ("skin", "hair", "eyes", "lips", "clothes", "glasses", "beard", "eyebrows", "scarf")
"""Families of colours that a face may have in another colour."""

LAYERS = (
    "background", "back", "hair-back", "neck", "clothes", "ears", "hair-middle", "head", "face", "cheeks", "muzzle",
    "nose", "mouth", "lips", "eye", "glasses", "brow", "beard", "hair-front", "front",
)  # fmt: skip
"""Groups of shapes, which pictures name; `eye` and `brow` are a layer for each side."""

LAWS = (
    "plain", "shell", "body", "neck", "neck_shadow", "contour", "skin", "under_jaw", "nose", "eye", "ball", "brow",
    "mouth", "rigid", "ear", "hair", "hair_side", "hair_back",
)  # fmt: skip
"""How an anchor lies in the head: the laws of `rig/cartoon/depth.py`."""

EYE_SHAPES = (
    "eye-socket", "eye-lid", "eye-white", "eye-iris", "eye-rays", "eye-pupil", "eye-shade", "eye-light", "eye-pouch",
    "eye-crows", "eye-rim", "eye-glow", "eye-lowerlid", "eye-line", "eye-lashes", "eye-crease",
)  # fmt: skip
MOUTH_SHAPES = (
    "mouth-under", "mouth-cavity", "mouth-tongue", "mouth-teeth-upper", "mouth-teeth-lower", "mouth-teeth-gaps",
    "mouth-lip-lower", "mouth-lip-light", "mouth-muzzle", "mouth-philtrum", "mouth-tongue-line", "mouth-lip-upper",
    "mouth-line",
)  # fmt: skip
LIVE: Mapping[str, str] = {
    **dict.fromkeys(EYE_SHAPES, "eye"),
    **dict.fromkeys(MOUTH_SHAPES, "mouth"),
    "cheek-fold": "cheeks",
}
"""Shapes that eye and mouth draw themselves, and the layer of each."""

NEEDED = ("eye-white", "mouth-cavity", "mouth-lip-lower", "mouth-lip-upper")
"""Live shapes that every face has."""

POINTS = 0
"""So many numbers a measure has that is a list of points, as long as the author wants."""

EYE: Mapping[str, tuple[int, bool]] = {
    "half-width": (1, True),
    "up": (1, True),
    "down": (1, True),
    "inner": (1, True),
    "outer": (1, True),
    "iris": (1, True),
    "iris-y": (1, True),
    "crease": (5, True),
    "crease-width": (1, True),
    "shade": (1, True),
    "line": (5, True),
    "wing": (2, True),
    "lash": (3, False),
    "top": (2, False),
    "bottom": (2, False),
    "sink": (1, False),
    "knit": (1, False),
    "hollow": (1, False),
    "rim": (1, False),
    "pupil": (1, False),
    "curve": (1, False),
    "slant": (1, False),
}
"""Measures of an eye: how many numbers each has, and whether it must be there; a lash may be written again."""

MOUTH: Mapping[str, tuple[int, bool]] = {
    "y": (1, True),
    "half-width": (1, True),
    "corner": (1, True),
    "upper": (1, True),
    "lower": (1, True),
    "tubercle": (1, True),
    "bow": (1, True),
    "dip": (1, True),
    "under": (1, True),
    "line": (1, True),
    "tick": (1, True),
    "nose-base": (1, True),
    "wing": (2, True),
    "muzzle": (POINTS, False),
    "lift": (1, False),
    "smile": (1, False),
    "frown": (1, False),
    "purse": (1, False),
    "fall": (1, False),
    "philtrum": (1, False),
    "teeth-upper": (POINTS, False),
    "teeth-lower": (POINTS, False),
}
"""Measures of the mouth, in the same way."""

ASKING: Mapping[str, str] = {
    "eye-rim": "rim",
    "mouth-muzzle": "muzzle",
    "mouth-philtrum": "muzzle",
    "mouth-tongue-line": "muzzle",
}
"""Live shapes that are there only with a measure of the eyes or the mouth."""

TOOTHED: Mapping[str, str] = {
    "mouth-teeth-upper": "teeth-upper",
    "mouth-teeth-gaps": "teeth-upper",
    "mouth-teeth-lower": "teeth-lower",
}
"""Live shapes for which a mouth with a muzzle needs a measure."""

OTHER_SIGNALS = ("jaw", "mouth.open", "mouth.wide", "mouth.round", "lid", "ear", "muzzle", "near", "far")
"""What moves shapes besides the muscles; an ear up and down apart is `ear up`, `ear down`; `near` and `far` are how far
a side of the face is turned to the viewer, and away."""

FEATURES = ("hairline", "temple", "ear-top", "ear-low")
"""The `point` rows of a face with the thesis's feature points."""

FEATURE_SHAPES = ("brow-body", "eye-iris", "face-skin")
"""Shapes that such a face has besides, for others of its points."""

LOCKS, OUTLINE = 23, 11
"""How many points its `locks` and its `outline` have."""

FARTHEST = 4000.0
"""Points that anything may lie from the middle between the eyes."""

MOST_SHAPES, MOST_POINTS = 400, 8000
"""Shapes of a kind, and points of all its outlines."""
