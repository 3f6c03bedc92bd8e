"""The man: measures, colours and parts, for `style.FaceStyle`."""

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
HAIR = ("hair-top",)

PALETTE: Palette = {
    "skin.base": "#d7a078",
    "skin.light": "#e9bb93",
    "skin.gleam": "#f9d8b2",
    "skin.shade": "#b57a57",
    "skin.deep": "#925a42",
    "skin.line": "#71402f",
    "skin.blush": "#c2603f",
    "skin.wing": "#8a533c",
    "skin.nostril": "#572a20",
    "skin.low-lid": "#8a5440",
    "skin.crease": "#7a4836",
    "hair.base": "#34231f",
    "hair.top": "#4d352d",
    "hair.low": "#261917",
    "hair.back": "#2b1d1a",
    "hair.back-low": "#1c1211",
    "hair.strand": "#1d1312",
    "hair.under": "#1f1413",
    "hair.light": "#7a5647",
    "hair.side": "#33231e",
    "hair.side-low": "#3a2822",
    "skin.stubble": "#4a2f26",
    "brows.light": "#3a2720",
    "brows.base": "#33211b",
    "brows.tail": "#241613",
    "brows.hair": "#190f0d",
    "eyes.base": "#85522b",
    "eyes.light": "#a9713f",
    "eyes.rays": "#c99256",
    "eyes.shade": "#5a361d",
    "eyes.ring": "#2e190e",
    "eyes.rim": "#231209",
    "lips.base": "#b9705c",
    "lips.upper": "#a5614c",
    "lips.upper-edge": "#8e4b3f",
    "lips.lower-top": "#a85f4f",
    "lips.lower-edge": "#ad6652",
    "lips.line": "#5a2822",
    "lips.light": "#dc9a84",
    "clothes.base": "#324766",
    "clothes.shade": "#22324b",
    "clothes.fold": "#141f33",
    "clothes.lapel": "#3d5578",
    "clothes.light": "#6f8bb3",
    "fixed.shirt": "#fbf8f2",
    "fixed.shirt-low": "#e4dfd6",
    "fixed.shirt-shade": "#c9c3ba",
    "fixed.collar": "#fdfbf7",
    "fixed.collar-shade": "#cfc9c0",
    "fixed.pupil": "#120a07",
    "fixed.lash": "#22130f",
    "fixed.white": "#fdfaf6",
    "fixed.white-shade": "#e8dfda",
    "fixed.ball-shade": "#6b5a60",
    "fixed.cavity": "#2e0f12",
    "fixed.cavity-low": "#5c1e22",
    "fixed.tongue": "#b95a54",
    "fixed.tongue-low": "#6e2429",
    "fixed.teeth": "#fdf8f0",
    "fixed.teeth-shade": "#e5dcd3",
    "fixed.teeth-low": "#ebe3d9",
    "fixed.ground": "#eef3f2",
    "fixed.ground-low": "#dbe6e6",
    "fixed.disc": "#a9cbc6",
    "fixed.disc-low": "#8fb9b6",
}

OUTLINE = (
    (0, -182), (68, -168), (110, -118), (123, -54), (124, 0), (121, 50), (114, 100), (98, 142), (64, 173),
    (29, 186), (0, 187),
)  # fmt: skip

BROW = ((22, -33), (23.5, -41), (48, -48.5), (75, -51), (102, -35, 1), (76, -43), (48, -39), (29, -33.6))
BROW_HAIRS = (
    ribbon((23, -32, 0.01), (27, -38, 1.5), (33, -43.5, 0.01)),
    ribbon((31, -34, 0.01), (38, -41, 1.5), (47, -46, 0.01)),
    ribbon((46, -39.5, 0.01), (53, -44, 1.4), (62, -47.5, 0.01)),
    ribbon((60, -40, 0.01), (68, -45.5, 1.3), (79, -47.5, 0.01)),
)

TOP = (
    (-98, -98, 1), (-112, -102), (-124, -120), (-128, -152), (-104, -192), (-48, -222), (20, -228), (84, -210),
    (122, -168),
    (129, -126), (122, -100), (104, -88, 1), (92, -103), (60, -112), (10, -120), (-44, -122),
)  # fmt: skip


def _back(p: Palette) -> tuple[Part, ...]:
    mass = loop(
        (0, -196), (84, -178), (124, -120), (130, -50), (122, 10), (96, 50), (0, 60), (-96, 50), (-122, 10),
        (-130, -50),
        (-124, -120), (-84, -178),
    )  # fmt: skip
    return (
        Part("hair-back-mass", "hair-back", "hair_back", ramp((0, p["hair.back"]), (1, p["hair.back-low"])), (mass,)),
    )


def _neck(p: Palette) -> tuple[Part, ...]:
    skin = loop(
        (-78, 60, 1), (-79, 140), (-82, 190), (-104, 220), (-140, 240, 1), (-120, 402, 1), (120, 402, 1),
        (140, 240, 1), (104, 220),
        (82, 190), (79, 140), (78, 60, 1),
    )  # fmt: skip
    jaw = face_outline(((0, 0), *((x * 0.985, y - 2.0) for x, y in OUTLINE[4:])))
    shadow = loop(
        (-100, 100, 1), (-82, 160), (-44, 202), (10, 218), (58, 228), (112, 240, 1), (120, 180), (110, 100, 1)
    )
    tendons = (
        ribbon((-52, 204, 0.01), (-38, 240, 3.4), (-16, 276, 0.01)),
        ribbon((56, 214, 0.01), (40, 244, 3.4), (18, 276, 0.01)),
        ribbon((-8, 226, 0.01), (0, 232, 3), (8, 226, 0.01)),
    )
    tone = ramp((0, mix(p["skin.base"], p["skin.shade"], 0.6)), (1, p["skin.base"]))
    return (
        Part("neck-skin", "neck", "neck", tone, (skin,)),
        Part("neck-shadow", "neck", "neck_shadow", p["skin.deep"], (shadow,), 0.6, ("neck-skin",)),
        Part("neck-tendons", "neck", "neck", p["skin.shade"], tendons, 0.8),
        Part("neck-under-jaw", "neck", "under_jaw", mix(p["skin.shade"], p["skin.deep"], 0.55), (jaw,)),
    )


def _clothes(p: Palette) -> tuple[Part, ...]:
    shirt = loop(
        (-96, 206, 1), (-110, 262), (-60, 402, 1), (-60, 900, 1), (60, 900, 1), (60, 402, 1), (110, 262),
        (96, 206, 1), (58, 270),
        (4, 318, 1), (-50, 270),
    )  # fmt: skip
    shirt_shade = (
        loop((-4, 318, 1), (4, 318, 1), (8, 402, 1), (8, 900, 1), (-3, 900, 1), (-3, 402, 1)),
        loop((60, 300, 1), (30, 350), (16, 402, 1), (60, 402, 1), (90, 330)),
    )
    half = loop(
        (112, 214, 1), (170, 236), (236, 262), (284, 316), (304, 402, 1), (310, 900, 1), (8, 900, 1), (46, 402, 1),
        (92, 320),
    )  # fmt: skip
    lapel = loop(
        (108, 222, 1), (132, 262), (140, 312, 1), (118, 318, 1), (122, 334, 1), (46, 402, 1), (8, 900, 1), (2, 900, 1),
        (46, 402, 1), (90, 318),
    )  # fmt: skip
    fold = loop((196, 402), (214, 350), (244, 306, 1), (234, 350), (236, 402), (228, 620, 1))
    folds = (fold, mirror(fold), loop((140, 312, 1), (128, 340), (60, 402, 1), (46, 402, 1), (122, 334, 1)))
    light = loop((-166, 236, 1), (-236, 264), (-286, 322, 1), (-234, 278))
    collar = loop((98, 200, 1), (112, 226), (116, 268, 1), (70, 322, 1), (8, 318, 1), (58, 268))
    collar_right = loop((-98, 200, 1), (-112, 226), (-116, 268, 1), (-62, 320, 1), (-8, 318, 1), (-54, 268))
    collar_shade = (
        loop((-116, 268, 1), (-62, 320, 1), (-8, 318, 1), (-60, 326, 1)),
        loop((98, 200, 1), (112, 226), (116, 268, 1), (96, 292, 1), (100, 240)),
    )
    cloth = ramp((0, p["clothes.base"]), (0.27, p["clothes.shade"]), (1, p["clothes.shade"]))
    dark = ramp((0, p["clothes.fold"], 0.8), (0.3, p["clothes.fold"], 0.25), (1, p["clothes.fold"], 0.1))
    white = ramp((0, p["fixed.shirt"]), (0.28, p["fixed.shirt-low"]), (1, p["fixed.shirt-low"]))
    return (
        Part("clothes-shirt", "clothes", "body", white, (shirt,)),
        Part("clothes-shirt-shade", "clothes", "body", p["fixed.shirt-shade"], shirt_shade, 0.8),
        *both(Part("clothes-jacket", "clothes", "body", cloth, (half,))),
        Part("clothes-lapels", "clothes", "body", p["clothes.lapel"], (mirror(lapel), lapel)),
        Part("clothes-folds", "clothes", "body", dark, folds),
        Part("clothes-light", "clothes", "body", p["clothes.light"], (light,), 0.5),
        Part("clothes-collar", "clothes", "body", p["fixed.collar"], (collar_right, collar)),
        Part("clothes-collar-shade", "clothes", "body", p["fixed.collar-shade"], collar_shade, 0.9),
    )


EAR = loop((114, -14), (128, -27), (142, -16), (141, 12), (132, 36), (124, 54), (114, 56), (110, 40))
EAR_INNER = loop((121, -10), (133, -14), (134, 6), (127, 26), (119, 34), (124, 14))


def _ears(p: Palette) -> tuple[Part, ...]:
    return (
        *both(Part("ear", "ears", "ear", mix(p["skin.base"], p["skin.shade"], 0.3), (EAR,))),
        *both(Part("ear-inner", "ears", "ear", p["skin.deep"], (EAR_INNER,), 0.6)),
    )


def _face(p: Palette) -> tuple[Part, ...]:
    base, shade = p["skin.base"], p["skin.shade"]
    skin = Radial((Stop(0, p["skin.light"]), Stop(0.55, base), Stop(1, mix(base, shade, 0.5))), (0.38, 0.42), 0.72)
    fade = (0, 0.3), (0.48, 0.26), (0.8, 0), (1, 0)
    growth = Radial(tuple(Stop(at, p["skin.stubble"], strength) for at, strength in fade))
    beard = loop((256, 120), (0, 332), (-256, 120), (0, 12))
    side = loop(
        (140, -120, 1), (106, -60), (104, 0), (107, 40), (97, 96), (76, 140), (40, 170), (0, 190), (60, 210),
        (150, 120),
    )  # fmt: skip
    cast = loop(
        (-110, -70, 1), (-92, -108), (-40, -120), (30, -116), (88, -100), (112, -60), (116, 6, 1), (140, 0),
        (140, -180),
        (-140, -180),
    )  # fmt: skip
    brow = loop((-84, -66), (-46, -104), (16, -100), (46, -64), (0, -40), (-52, -44))
    plane = ramp((0, shade, 0), (1, shade, 0.9), line=ACROSS)
    return (
        Part("face-skin", "face", "contour", skin, (face_outline(OUTLINE),)),
        Part("face-stubble", "face", "skin", growth, (beard,), 1, FACE),
        Part("face-side", "face", "skin", plane, (side,), clip=FACE),
        Part("face-hair-shadow", "face", "skin", p["skin.deep"], (cast,), 0.42, FACE),
        Part("face-forehead-light", "face", "skin", glow(p["skin.gleam"], 0.95, 0.5), (brow,), 0.55),
        Part("face-chin-light", "face", "mouth", glow(p["skin.gleam"], 0.95, 0.5), (spot(-4, 158, 24, 13),), 0.28),
        *near_ear(p, mix(base, shade, 0.3), EAR, EAR_INNER),
    )


def _nose(p: Palette) -> tuple[Part, ...]:
    shade = p["skin.shade"]
    bridge = ramp((0, shade, 0), (0.45, shade, 0.6), (1, shade, 0.85))
    side = loop((11, -26, 1), (9, 8), (13, 38), (25, 58), (28, 70, 1), (18, 54), (21, 18), (24, -16))
    under = loop((-21, 73, 1), (-11, 74), (0, 78), (11, 74), (22, 72, 1), (14, 82), (0, 86), (-13, 82))
    wings = (
        ribbon((-22, 56, 0.01), (-27, 66, 2.3), (-21, 74.5, 0.01)),
        ribbon((22, 56, 0.01), (27, 66, 2.6), (21, 74.5, 0.01)),
    )
    nostril = loop((17, 73.5, 1), (11.5, 70.6), (5.5, 75, 1), (11, 75.8))
    ridge = loop((-4, -10, 1), (-6, 20), (-5, 46, 1), (-2, 20))
    tip = loop((-13, 60), (-3, 50), (8, 60), (-2, 70))
    return (
        Part("nose-side", "nose", "nose", bridge, (side,), 0.85),
        Part("nose-under", "nose", "nose", p["skin.deep"], (under,), 0.6),
        Part("nose-wings", "nose", "nose", p["skin.wing"], wings, 0.9),
        Part("nose-nostrils", "nose", "nose", p["skin.nostril"], (mirror(nostril), nostril), 0.9),
        *nose_edges(p, ribbon((12.5, -8, 0.01), (11, 10, 2), (13, 36, 2.4), (17, 53, 2.2), (12, 66, 0.01))),
        *nose_light(p, ridge, tip, (0.4, 0.5)),
    )


def _front(p: Palette) -> tuple[Part, ...]:
    temple = loop(
        (90, -150, 1), (114, -121), (127.5, -57), (125, -6), (114, 26, 1), (115, -14), (112, -56), (100, -86),
        (84, -108),
        (72, -128, 1),
    )  # fmt: skip
    under = loop(
        (-90, -110, 1), (-44, -122), (10, -120), (60, -112), (104, -88, 1), (80, -124), (20, -142), (-50, -144)
    )
    dark = (
        ribbon((-96, -120, 0.01), (-80, -166, 5), (-20, -196, 5), (60, -190, 0.01)),
        ribbon((-70, -124, 0.01), (-40, -158, 5), (30, -170, 5), (100, -140, 0.01)),
        ribbon((-110, -128, 0.01), (-108, -170, 4), (-60, -208, 4), (0, -218, 0.01)),
        ribbon((-20, -126, 0.01), (30, -148, 4), (80, -138, 4), (112, -102, 0.01)),
    )
    light = (
        ribbon((-92, -146, 0.01), (-66, -186, 7), (-10, -208, 7), (50, -206, 0.01)),
        ribbon((-60, -146, 0.01), (-30, -176, 5), (30, -186, 5), (84, -166, 0.01)),
        ribbon((-20, -140, 0.01), (24, -156, 4), (70, -150, 0.01)),
        ribbon((60, -204, 0.01), (98, -184, 5), (116, -148, 0.01)),
    )
    loose = (
        ribbon((10, -226, 0.01), (52, -226, 7), (98, -198, 0.01)),
        ribbon((-84, -204, 0.01), (-36, -226, 7), (16, -228, 0.01)),
    )
    fade = ramp(
        (0, p["hair.back"]), (0.6, p["hair.side"]), (0.8, p["hair.side-low"], 0.85), (1, p["hair.side-low"], 0),
    )  # fmt: skip
    mass = ramp((0, p["hair.top"]), (0.5, p["hair.base"]), (1, p["hair.low"]))
    return (
        *both(Part("hair-side", "hair-front", "hair_side", fade, (temple,))),
        Part("hair-top", "hair-front", "hair", mass, (loop(*TOP),)),
        Part("hair-under", "hair-front", "hair", p["hair.under"], (under,), 0.7, HAIR),
        Part("hair-strands", "hair-front", "hair", p["hair.strand"], dark, 0.7, HAIR),
        Part("hair-lights", "hair-front", "hair", p["hair.light"], light, 0.65, HAIR),
        Part("hair-loose", "hair-front", "hair", p["hair.base"], loose),
    )


def parts(p: Palette) -> tuple[Part, ...]:
    """All parts, back to front."""
    lines = expression_lines(p, -44, 76, 187)
    return (
        *_back(p),
        *_neck(p),
        *_clothes(p),
        *_ears(p),
        *_face(p),
        *(line for line in lines if line.group == "face"),
        *cheek_parts(p, 78, 60, (0.6, 0.3), 0.34),
        *_nose(p),
        *(line for line in lines if line.group == "nose"),
        *mouth_parts(p, 0.45),
        *eye_parts(p, 0.6, 0.5, lashes=False),
        *brow_parts(p, loop(*BROW), BROW_HAIRS),
        *_front(p),
    )


MAN = FaceStyle(
    name="man",
    d=114.0,
    outline=OUTLINE,
    shell=(1.30, 2.0),
    nose_base=76.0,
    nose_width=25.0,
    eye=EyeStyle(
        half_width=29,
        up=13,
        down=9.6,
        inner=3,
        outer=-2,
        iris=12.6,
        iris_y=-1.2,
        crease=(-5, -15.5, -20.5, -18, -5),
        crease_width=1.8,
        shade=5,
        line=(0, 1.6, 2.3, 2.5, 1.6),
        wing=(3, 1.0),
    ),
    brow=BrowStyle(20, 98),
    mouth=MouthStyle(
        y=114,
        half_width=45,
        corner=-2.5,
        upper=8,
        lower=12.5,
        tubercle=1.5,
        bow=10,
        dip=1.8,
        under=7,
        line=1.7,
        tick=-2,
        nose_base=81,
        wing=(31, 68),
    ),
    palette=PALETTE,
    parts=parts,
    backdrop=backdrop_parts,
    points={"hairline": (0, -120), "temple": (78, -104), "ear-top": (130, -27), "ear-low": (130, 52)},
    hair=(
        (0, -228), (20, -228), (84, -210), (122, -168), (129, -126), (131, -62), (128, -22), (122, 30), (112, -56),
        (104, -88),
        (60, -112), (10, -120), (-44, -122), (-88, -112), (-112, -56), (-122, 30), (-128, -22), (-131, -62),
        (-128, -116),
        (-128, -152), (-104, -192), (-76, -210), (-48, -222),
    ),
)  # fmt: skip
