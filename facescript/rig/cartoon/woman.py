"""The woman: measures, colours and parts, for `style.FaceStyle`."""

from __future__ import annotations

from facescript.rig.cartoon.common import (
    ACROSS,
    backdrop_parts,
    brow_parts,
    cheek_parts,
    expression_lines,
    eye_parts,
    face_outline,
    glow,
    mouth_parts,
    near_ear,
    nose_edges,
    nose_light,
    ramp,
)
from facescript.rig.cartoon.eye import EyeStyle
from facescript.rig.cartoon.lips import MouthStyle
from facescript.rig.cartoon.outline import Part, both, loop, mirror, ribbon, spot
from facescript.rig.cartoon.palette import Palette, mix
from facescript.rig.cartoon.style import BrowStyle, FaceStyle
from facescript.rig.picture import Radial, Stop

FACE = ("face-skin",)
HAIR = ("hair-front-right", "hair-front-left")

PALETTE: Palette = {
    "skin.base": "#f3c6a5",
    "skin.light": "#fbdcc3",
    "skin.gleam": "#fff3e4",
    "skin.shade": "#dc9c7c",
    "skin.deep": "#c47a60",
    "skin.line": "#a65c47",
    "skin.blush": "#e8796a",
    "skin.wing": "#b26a52",
    "skin.nostril": "#7e3b32",
    "skin.low-lid": "#a4604e",
    "skin.crease": "#9c5746",
    "hair.base": "#6d3226",
    "hair.top": "#8a4632",
    "hair.low": "#5a271f",
    "hair.back": "#4a211c",
    "hair.back-low": "#351513",
    "hair.strand": "#421b18",
    "hair.under": "#3f1a17",
    "hair.light": "#b9693f",
    "hair.back-strand": "#7a3a2b",
    "brows.light": "#7a4636",
    "brows.base": "#6b3a2c",
    "brows.tail": "#52291f",
    "brows.hair": "#3d1d17",
    "eyes.base": "#5b9a86",
    "eyes.light": "#7fb39a",
    "eyes.rays": "#a8d0b4",
    "eyes.shade": "#3a7a68",
    "eyes.ring": "#1d4238",
    "eyes.rim": "#14302a",
    "lips.base": "#d96a68",
    "lips.upper": "#c85a58",
    "lips.upper-edge": "#a93f46",
    "lips.lower-top": "#c9525a",
    "lips.lower-edge": "#cf5d5e",
    "lips.line": "#7a2730",
    "lips.light": "#f4a9a0",
    "clothes.base": "#2a7d82",
    "clothes.shade": "#1a5a64",
    "clothes.fold": "#0f424b",
    "clothes.lapel": "#2f8b8f",
    "clothes.lapel-shade": "#237077",
    "clothes.light": "#5fb3ae",
    "fixed.gold": "#e9b949",
    "fixed.gold-light": "#fff3c9",
    "fixed.pupil": "#0d1a17",
    "fixed.lash": "#2b1414",
    "fixed.white": "#fffdfb",
    "fixed.white-shade": "#efe6e2",
    "fixed.ball-shade": "#7d6a78",
    "fixed.cavity": "#3a1018",
    "fixed.cavity-low": "#6b1f28",
    "fixed.tongue": "#c9615f",
    "fixed.tongue-low": "#7e2a36",
    "fixed.teeth": "#fffaf4",
    "fixed.teeth-shade": "#e9dfd8",
    "fixed.teeth-low": "#efe7df",
    "fixed.ground": "#fbf3e8",
    "fixed.ground-low": "#f4e3d0",
    "fixed.disc": "#f3c98f",
    "fixed.disc-low": "#efb77c",
}

OUTLINE = (
    (0, -182), (64, -168), (106, -118), (120, -52), (121, 0), (117, 45), (105, 92), (82, 134), (48, 164), (18, 175),
    (0, 176),
)  # fmt: skip

BROW = ((24.5, -42), (26.5, -48.8), (50, -56.4), (73, -59), (100, -43.5, 1), (74, -52.4), (50, -48.4), (31, -42.6))
BROW_HAIRS = (
    ribbon((26, -42, 0.01), (29, -46, 1.2), (34, -50, 0.01)),
    ribbon((33, -43.5, 0.01), (39, -48.5, 1.2), (47, -53, 0.01)),
    ribbon((45, -47.5, 0.01), (53, -52.5, 1.1), (62, -55.5, 0.01)),
    ribbon((60, -51, 0.01), (68, -54.5, 1), (78, -55.5, 0.01)),
)

LOCK_RIGHT = (
    (-26, -205, 1), (-88, -193), (-136, -142), (-156, -66), (-154, 2), (-140, 44, 1), (-129, 14), (-122, -18),
    (-116, -52),
    (-102, -86), (-72, -118), (-34, -142, 1), (-12, -160, 1), (-6, -204, 1),
)  # fmt: skip
LOCK_LEFT = (
    (-26, -205, 1), (36, -213), (108, -184), (156, -108), (170, -18), (160, 62), (168, 134), (186, 196), (160, 272, 1),
    (152, 226), (128, 168), (114, 104), (126, 30), (118, -30), (86, -80), (26, -122), (-34, -142, 1), (-35, -172),
)  # fmt: skip
"""The two masses of hair in front, from the parting: on the image's left (the face's right) and on its right."""


def _back(p: Palette) -> tuple[Part, ...]:
    mass = loop(
        (0, -203), (92, -178), (150, -110), (164, -10), (156, 80), (172, 160), (184, 226), (150, 284, 1),
        (120, 276), (60, 270),
        (0, 262), (-60, 270), (-120, 280), (-146, 292, 1), (-188, 226), (-172, 150), (-152, 80), (-160, -10),
        (-148, -110),
        (-92, -176),
    )  # fmt: skip
    strands = [
        outline
        for k in (-1, 1)
        for outline in (
            ribbon((k * 128, 60, 0.01), (k * 134, 130, 5), (k * 148, 200, 5), (k * 132, 266, 0.01)),
            ribbon((k * 112, 150, 0.01), (k * 122, 200, 4), (k * 108, 268, 0.01)),
        )
    ]
    return (
        Part("hair-back-mass", "hair-back", "hair_back", ramp((0, p["hair.back"]), (1, p["hair.back-low"])), (mass,)),
        Part("hair-back-strands", "hair-back", "hair_back", p["hair.back-strand"], tuple(strands), 0.6),
    )


def _neck(p: Palette) -> tuple[Part, ...]:
    skin = loop(
        (-50, 60, 1), (-51, 140), (-54, 186), (-84, 222), (-150, 252, 1), (-150, 402, 1), (150, 402, 1),
        (150, 252, 1), (84, 222),
        (54, 186), (51, 140), (50, 60, 1),
    )  # fmt: skip
    under = [(x * 0.985, y - 2.0) for x, y in OUTLINE[4:]]
    jaw = face_outline(((0, 0), *under))
    shadow = loop((-70, 100, 1), (-56, 168), (-26, 200), (14, 214), (48, 226), (84, 240, 1), (110, 180), (90, 100, 1))
    bones = (
        ribbon((-118, 262, 0.01), (-70, 258, 3), (-26, 272, 0.01)),
        ribbon((118, 262, 0.01), (70, 258, 3), (26, 272, 0.01)),
        ribbon((-12, 280, 0.01), (0, 288, 3), (12, 280, 0.01)),
    )
    light = loop((-53, 184, 1), (-60, 203), (-88, 225), (-122, 241, 1), (-84, 234), (-56, 212))
    tone = ramp((0, mix(p["skin.base"], p["skin.shade"], 0.55)), (1, p["skin.base"]))
    return (
        Part("neck-skin", "neck", "neck", tone, (skin,)),
        Part("neck-shadow", "neck", "neck_shadow", p["skin.deep"], (shadow,), 0.55, ("neck-skin",)),
        Part("neck-collarbones", "neck", "body", p["skin.shade"], bones, 0.8),
        Part("neck-light", "neck", "neck", p["skin.light"], (light,), 0.55),
        Part("neck-under-jaw", "neck", "under_jaw", mix(p["skin.shade"], p["skin.deep"], 0.45), (jaw,)),
    )


def _clothes(p: Palette) -> tuple[Part, ...]:
    top = loop(
        (-104, 236, 1), (-150, 250), (-206, 276), (-246, 330), (-262, 402, 1), (-268, 900, 1), (268, 900, 1),
        (262, 402, 1),
        (246, 330), (206, 276), (150, 250), (104, 236, 1), (70, 290), (0, 350, 1), (-70, 290),
    )  # fmt: skip
    lapels = (
        loop((-104, 236, 1), (-70, 290), (0, 350, 1), (34, 402, 1), (330, 900, 1), (270, 900, 1), (-10, 402, 1),
            (-88, 312), (-124, 243, 1)),
        loop((104, 236, 1), (70, 290), (0, 350, 1), (-14, 372, 1), (30, 352), (92, 300), (124, 243, 1)),
    )  # fmt: skip
    folds = (
        loop((170, 402, 1), (186, 350), (214, 310, 1), (204, 350), (206, 402), (198, 620, 1)),
        loop((-168, 402, 1), (-186, 356), (-216, 316, 1), (-202, 356), (-202, 402), (-194, 620, 1)),
        loop((60, 402, 1), (90, 360), (140, 326, 1), (104, 366), (92, 402), (84, 560, 1)),
    )
    light = loop((-146, 250, 1), (-206, 278), (-245, 332, 1), (-203, 291))
    cloth = ramp((0, p["clothes.base"]), (0.25, p["clothes.shade"]), (1, p["clothes.shade"]))
    dark = ramp((0, p["clothes.fold"], 0.75), (0.3, p["clothes.fold"], 0.25), (1, p["clothes.fold"], 0.1))
    return (
        Part("clothes-top", "clothes", "body", cloth, (top,)),
        Part("clothes-lapel-right", "clothes", "body", p["clothes.lapel"], lapels[:1], clip=("clothes-top",)),
        Part("clothes-lapel-left", "clothes", "body", p["clothes.lapel-shade"], lapels[1:]),
        Part("clothes-folds", "clothes", "body", dark, folds),
        Part("clothes-light", "clothes", "body", p["clothes.light"], (light,), 0.55),
    )


EAR = loop((112, -20), (127, -26), (137, -10), (134, 18), (127, 42), (116, 54), (108, 44))
EAR_INNER = loop((119, -12), (129, -12), (130, 8), (124, 26), (117, 30), (121, 12))


def _ears(p: Palette) -> tuple[Part, ...]:
    tone = mix(p["skin.base"], p["skin.shade"], 0.25)
    return (
        *both(Part("ear", "ears", "ear", tone, (EAR,))),
        *both(Part("ear-inner", "ears", "ear", p["skin.deep"], (EAR_INNER,), 0.55)),
        Part("earrings", "ears", "ear", p["fixed.gold"], (spot(-124, 55, 6, 6), spot(124, 55, 6, 6))),
        Part(
            "earrings-light", "ears", "ear", p["fixed.gold-light"], (spot(-126, 53, 2.1, 2.1), spot(122, 53, 2.1, 2.1))
        ),
    )


def _face(p: Palette) -> tuple[Part, ...]:
    base, shade = p["skin.base"], p["skin.shade"]
    skin = Radial((Stop(0, p["skin.light"]), Stop(0.55, base), Stop(1, mix(base, shade, 0.45))), (0.38, 0.42), 0.72)
    side = loop(
        (130, -120, 1), (104, -60), (101, 0), (104, 40), (92, 92), (66, 134), (30, 164), (0, 180), (60, 200),
        (140, 120),
    )  # fmt: skip
    cast = loop(
        (-50, -150, 1), (6, -112), (66, -74), (101, -26), (110, 26), (117, 84, 1), (150, 60), (150, -150, 1),
    )  # fmt: skip
    brow = loop((-84, -64), (-42, -112), (22, -98), (46, -58), (0, -38), (-52, -42))
    plane = ramp((0, shade, 0), (1, shade, 0.85), line=ACROSS)
    return (
        Part("face-skin", "face", "contour", skin, (face_outline(OUTLINE),)),
        Part("face-side", "face", "skin", plane, (side,), clip=FACE),
        Part("face-hair-shadow", "face", "skin", p["skin.deep"], (cast,), 0.40, FACE),
        Part("face-forehead-light", "face", "skin", glow(p["skin.gleam"], 0.95, 0.5), (brow,), 0.5),
        Part("face-chin-light", "face", "mouth", glow(p["skin.gleam"], 0.95, 0.5), (spot(-4, 155, 24, 13),), 0.42),
        *near_ear(p, mix(base, shade, 0.25), EAR, EAR_INNER),
    )


def _nose(p: Palette) -> tuple[Part, ...]:
    shade = p["skin.shade"]
    bridge = ramp((0, shade, 0), (0.45, shade, 0.55), (1, shade, 0.8))
    side = loop((9, -22, 1), (8, 8), (11, 38), (21, 58), (23, 68, 1), (15, 52), (18, 20), (20, -12))
    under = loop((-17, 70, 1), (-9, 70), (0, 74), (9, 70), (18, 69, 1), (12, 77), (0, 81), (-11, 77))
    wings = (
        ribbon((-18, 56, 0.01), (-22, 64, 1.9), (-17.5, 71, 0.01)),
        ribbon((18, 56, 0.01), (22, 64, 2.2), (17.5, 71, 0.01)),
    )
    nostril = loop((14, 70, 1), (9.5, 67.6), (4.5, 71.5, 1), (9, 72))
    ridge = loop((-3, -8, 1), (-5, 22), (-4, 46, 1), (-1.5, 22))
    tip = loop((-11, 58), (-2, 49), (8, 58), (-1, 67))
    return (
        Part("nose-side", "nose", "nose", bridge, (side,), 0.75),
        Part("nose-under", "nose", "nose", p["skin.deep"], (under,), 0.6),
        Part("nose-wings", "nose", "nose", p["skin.wing"], wings, 0.85),
        Part("nose-nostrils", "nose", "nose", p["skin.nostril"], (mirror(nostril), nostril), 0.9),
        *nose_edges(p, ribbon((10.5, -8, 0.01), (9.5, 10, 1.8), (11, 36, 2.2), (14, 52, 2), (10, 64, 0.01))),
        *nose_light(p, ridge, tip, (0.5, 0.6)),
    )


def _front(p: Palette) -> tuple[Part, ...]:
    under = (
        loop((-34, -142, 1), (26, -122), (86, -80), (118, -30), (126, 30), (114, 104), (128, 168, 1), (128, 104),
            (136, 28), (127, -38), (93, -92), (30, -134)),
        loop((-34, -142, 1), (-72, -118), (-102, -86), (-116, -52), (-122, -18), (-129, 14), (-140, 44, 1),
            (-136, 4), (-128, -24), (-123, -58), (-107, -94), (-74, -126)),
    )  # fmt: skip
    dark = (
        ribbon((-27, -206, 0.01), (-30, -174, 3.4), (-34, -141, 0.01)),
        ribbon((-30, -168, 0.01), (40, -160, 4), (108, -98, 4), (140, -10, 3), (140, 70, 0.01)),
        ribbon((-28, -186, 0.01), (60, -180, 3.5), (128, -110, 4), (151, -20, 4), (146, 70, 3.5), (156, 150, 0.01)),
        ribbon((140, 60, 0.01), (142, 120, 4), (158, 190, 4), (148, 250, 0.01)),
        ribbon((-34, -160, 0.01), (-82, -146, 4), (-122, -86, 3.5), (-138, -10, 0.01)),
        ribbon((-30, -184, 0.01), (-90, -166, 3), (-134, -100, 3), (-144, -30, 0.01)),
    )
    light = (
        ribbon((12, -186, 0.01), (70, -170, 7), (122, -112, 7), (148, -36, 0.01)),
        ribbon((30, -158, 0.01), (78, -134, 5), (116, -82, 5), (134, -24, 0.01)),
        ribbon((150, 20, 0.01), (150, 80, 5), (160, 140, 5), (166, 190, 0.01)),
        ribbon((-52, -176, 0.01), (-98, -150, 7), (-132, -90, 6), (-142, -40, 0.01)),
        ribbon((-60, -150, 0.01), (-96, -122, 4), (-122, -76, 0.01)),
    )
    loose = (
        ribbon((155, 46, 0.01), (162, 112, 8), (178, 174, 9), (187, 222, 0.01)),
        ribbon((-150, 50, 0.01), (-156, 108, 8), (-175, 170, 8), (-187, 226, 0.01)),
        ribbon((176, 214, 0.01), (182, 240, 7), (168, 286, 0.01)),
    )
    right = ramp((0, p["hair.top"]), (0.6, p["hair.base"]), (1, p["hair.low"]))
    left = ramp((0, p["hair.top"]), (0.45, p["hair.base"]), (1, p["hair.low"]))
    return (
        Part("hair-front-right", "hair-front", "hair", right, (loop(*LOCK_RIGHT),)),
        Part("hair-front-left", "hair-front", "hair", left, (loop(*LOCK_LEFT),)),
        Part("hair-front-under", "hair-front", "hair", p["hair.under"], under, 0.75, HAIR),
        Part("hair-front-strands", "hair-front", "hair", p["hair.strand"], dark, 0.6, HAIR),
        Part("hair-front-lights", "hair-front", "hair", p["hair.light"], light, 0.7, HAIR),
        Part("hair-front-loose", "hair-front", "hair_back", p["hair.low"], loose),
    )


def parts(p: Palette) -> tuple[Part, ...]:
    """All parts, back to front."""
    lines = expression_lines(p, -52, 72, 176)
    return (
        *_back(p),
        *_neck(p),
        *_clothes(p),
        *_ears(p),
        *_face(p),
        *(line for line in lines if line.group == "face"),
        *cheek_parts(p, 77, 64, (0.75, 0.38), 0.52),
        *_nose(p),
        *(line for line in lines if line.group == "nose"),
        *mouth_parts(p, 0.6),
        *eye_parts(p, 0.55, 0.62, lashes=True),
        *brow_parts(p, loop(*BROW), BROW_HAIRS),
        *_front(p),
    )


WOMAN = FaceStyle(
    name="woman",
    d=116.0,
    outline=OUTLINE,
    shell=(1.44, 1.85),
    nose_base=72.0,
    nose_width=20.0,
    eye=EyeStyle(
        half_width=31,
        up=17,
        down=11.5,
        inner=4,
        outer=-4,
        iris=14.6,
        iris_y=-1.5,
        crease=(-7, -20, -25.5, -22, -10),
        crease_width=1.9,
        shade=5.5,
        line=(0, 2.4, 3.7, 4.2, 3.4),
        wing=(9.5, -8),
        lashes=((0.12, 7, 78), (0.32, 9.5, 67), (0.5, 11.5, 57), (0.66, 12.5, 47), (0.8, 13, 37), (0.92, 12, 27)),
    ),
    brow=BrowStyle(24, 94),
    mouth=MouthStyle(
        y=111,
        half_width=41,
        corner=-3,
        upper=11,
        lower=15.5,
        tubercle=2,
        bow=10,
        dip=2.6,
        under=6,
        line=1.4,
        tick=-2.6,
        nose_base=77,
        wing=(26, 64),
    ),
    palette=PALETTE,
    parts=parts,
    backdrop=backdrop_parts,
    points={"hairline": (0, -128), "temple": (74, -92), "ear-top": (127, -26), "ear-low": (127, 44)},
    hair=(
        (-34, -205), (36, -213), (108, -184), (156, -108), (170, -18), (160, 62), (168, 134), (186, 196),
        (160, 272), (128, 168),
        (114, 104), (126, 30), (118, -30), (26, -122), (-34, -142), (-72, -118), (-116, -52), (-129, 14),
        (-152, 80), (-188, 226),
        (-160, -10), (-136, -142), (-88, -193),
    ),
)  # fmt: skip
