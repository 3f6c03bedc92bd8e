"""Parts that every cartoon human has in the same form: eyes, mouth, brows, nose, cheeks, lines of expression."""

from __future__ import annotations

from collections.abc import Sequence

from facescript.rig.cartoon.outline import Loop, Part, both, disc, loop, mirror, ribbon, spot
from facescript.rig.cartoon.palette import Palette, mix
from facescript.rig.picture import Linear, Paint, Radial, Stop

ACROSS = ((0.0, 0.0), (1.0, 0.0))
"""A gradient's line from left to right."""


def ramp(
    *stops: tuple[float, str] | tuple[float, str, float], line: tuple[tuple[float, float], ...] = ((0, 0), (0, 1))
) -> Linear:
    """A linear gradient, from top to bottom unless `line` says otherwise."""
    return Linear(tuple(Stop(*stop) for stop in stops), line[0], line[1])


def glow(colour: str, *strength: float) -> Radial:
    """A spot of `colour` that fades to nothing: opacity at its middle, halfway and (0) at the rim."""
    middle, half = strength
    return Radial((Stop(0, colour, middle), Stop(0.5, colour, half), Stop(1, colour, 0)))


def eye_parts(p: Palette, socket: float, lid: float, lashes: bool) -> tuple[Part, ...]:
    """Both eyes, the image's left first; `socket` and `lid` are the opacities of the shades around them."""
    return tuple(part for side in ("right", "left") for part in _eye(p, side, socket, lid, lashes))


def _eye(p: Palette, side: str, socket: float, lid: float, lashes: bool) -> list[Part]:
    group, white = f"eye-{side}", (f"eye-white-{side}",)
    deep, base, shade = p["skin.deep"], p["skin.base"], p["skin.shade"]
    hollow = Radial((Stop(0, deep, 0.75), Stop(0.6, deep, 0.35), Stop(1, deep, 0)))
    lid_tone = mix(mix(base, shade, 0.8), deep, 0.25)
    skin = Radial((Stop(0, lid_tone, 1), Stop(0.55, lid_tone, 0.85), Stop(1, lid_tone, 0.1)), (0.5, 0.62), 0.58)
    iris = Radial(
        (
            Stop(0, p["eyes.light"]),
            Stop(0.45, p["eyes.base"]),
            Stop(0.78, p["eyes.shade"]),
            Stop(0.88, p["eyes.ring"]),
            Stop(1, p["eyes.rim"]),
        ),
        (0.5, 0.56),
        0.53,
    )
    rows: list[tuple[str, Paint, float, tuple[str, ...], str]] = [
        ("socket", hollow, socket, ("face-skin",), "skin"),
        ("lid", skin, lid, (), "eye"),
        ("white", ramp((0, p["fixed.white-shade"]), (1, p["fixed.white"])), 1, (), "eye"),
        ("iris", iris, 1, white, "ball"),
        ("rays", p["eyes.rays"], 0.4, white, "ball"),
        ("pupil", p["fixed.pupil"], 1, white, "ball"),
        ("shade", p["fixed.ball-shade"], 0.38, white, "eye"),
        ("light", "#ffffff", 0.96, white, "ball"),
        ("pouch", p["skin.deep"], 0, (), "eye"),
        ("crows", p["skin.line"], 0, (), "eye"),
        ("lowerlid", p["skin.low-lid"], 0.6, (), "eye"),
        ("line", p["fixed.lash"], 1, (), "eye"),
        ("lashes", p["fixed.lash"], 1, (), "eye"),
        ("crease", p["skin.crease"], 0.75, (), "eye"),
    ]
    return [
        Part(f"eye-{name}-{side}", group, depth, fill, (), opacity, clip)
        for name, fill, opacity, clip, depth in rows
        if lashes or name != "lashes"
    ]


def mouth_parts(p: Palette, light: float) -> tuple[Part, ...]:
    inside = ("mouth-cavity",)
    rows: list[tuple[str, Paint, float, tuple[str, ...]]] = [
        ("under", p["skin.deep"], 0.42, ()),
        ("cavity", ramp((0, p["fixed.cavity"]), (1, p["fixed.cavity-low"])), 1, ()),
        ("tongue", ramp((0, p["fixed.tongue"]), (1, p["fixed.tongue-low"])), 1, inside),
        (
            "teeth-upper",
            ramp((0, p["fixed.teeth-shade"]), (0.5, p["fixed.teeth"]), (1, p["fixed.teeth"])),
            1,
            inside,
        ),
        ("teeth-lower", p["fixed.teeth-low"], 1, inside),
        ("teeth-gaps", p["fixed.ball-shade"], 0.22, inside),
        ("lip-lower", ramp((0, p["lips.lower-top"]), (0.6, p["lips.base"]), (1, p["lips.lower-edge"])), 1, ()),
        ("lip-light", p["lips.light"], light, ()),
        ("lip-upper", ramp((0, p["lips.upper"]), (1, p["lips.upper-edge"])), 1, ()),
        ("line", p["lips.line"], 0.9, ()),
    ]
    return tuple(Part(f"mouth-{name}", "mouth", "mouth", fill, (), alpha, clip) for name, fill, alpha, clip in rows)


def brow_parts(p: Palette, body: Loop, hairs: Sequence[Loop]) -> tuple[Part, ...]:
    """Both brows from that on the image's right: lighter and softer at the nose."""
    parts = []
    for side, line, turn in (("right", ((1, 0), (0, 0)), mirror), ("left", ACROSS, lambda outline: outline)):
        fill = ramp((0, p["brows.light"], 0.8), (0.3, p["brows.base"]), (1, p["brows.tail"]), line=line)
        parts.append(Part(f"brow-body-{side}", f"brow-{side}", "brow", fill, (turn(body),)))
        loops = tuple(turn(outline) for outline in hairs)
        parts.append(Part(f"brow-hairs-{side}", f"brow-{side}", "brow", p["brows.hair"], loops, 0.55))
    return tuple(parts)


def cheek_parts(p: Palette, x: float, y: float, strength: tuple[float, float], opacity: float) -> tuple[Part, ...]:
    """Blush, and the folds that the mouth draws."""
    blush = Part(
        "cheek-blush",
        "cheeks",
        "skin",
        glow(p["skin.blush"], *strength),
        (spot(x, y, 42, 30),),
        opacity,
        ("face-skin",),
    )
    folds = [Part(f"cheek-fold-{side}", "cheeks", "skin", p["skin.line"], (), 0) for side in ("right", "left")]
    return (*both(blush), *folds)


def expression_lines(p: Palette, brow_y: float, nose_y: float, chin_y: float) -> tuple[Part, ...]:
    """Lines that muscles draw: across the forehead, between the brows, on the bridge of the nose, on the chin."""
    line = p["skin.line"]
    high = [
        ribbon((-58 + k * 6, y + 3, 0.01), (-20, y, 2.0), (20, y + 0.5, 2.0), (58 - k * 6, y + 3.5, 0.01))
        for k, y in enumerate((brow_y - 27, brow_y - 38, brow_y - 48))
    ]
    frown = (
        ribbon((-9, brow_y + 30, 0.01), (-7, brow_y + 18, 2.4), (-10, brow_y + 5, 0.01)),
        ribbon((8, brow_y + 30, 0.01), (7, brow_y + 18, 2.2), (9, brow_y + 7, 0.01)),
    )
    bridge = [ribbon((-9, nose_y - 84, 0.01), (0, nose_y - 81.5, 2.0), (9, nose_y - 84.5, 0.01))]
    bridge += [
        ribbon((s * 4, nose_y - y, 0.01), (s * 10, nose_y - y + 1, 2.1), (s * reach, nose_y - y + 10, 0.01))
        for s, rows in ((-1, ((73, 19), (58, 17))), (1, ((75, 18), (61, 20))))
        for y, reach in rows
    ]
    wings = [
        ribbon((s * 8, nose_y - 40, 0.01), (s * 14, nose_y - 32, 1.9), (s * 16, nose_y - 22, 0.01)) for s in (-1, 1)
    ]
    chin = (
        ribbon((-13, chin_y - 22, 0.01), (-2, chin_y - 25, 2.4), (12, chin_y - 21, 0.01)),
        ribbon((-9, chin_y - 12, 0.01), (-5, chin_y - 15, 1.8), (-1, chin_y - 12, 0.01)),
        ribbon((3, chin_y - 13, 0.01), (6, chin_y - 16, 1.8), (10, chin_y - 12, 0.01)),
    )
    faded = ramp((0, line, 0), (0.35, line), (0.65, line), (1, line, 0), line=ACROSS)
    return (
        Part("forehead-lines", "face", "skin", faded, tuple(high), 0),
        Part("brow-furrow", "face", "skin", line, frown, 0),
        Part("nose-wrinkles", "nose", "nose", line, (*bridge, *wings), 0),
        Part("chin-lines", "face", "mouth", line, chin, 0),
    )


def near_ear(p: Palette, tone: str, rim: Loop, inner: Loop) -> tuple[Part, ...]:
    """The ears again, before the cheek, its skin running into theirs: each shows while its side is turned to us."""
    parts: list[Part] = []
    for side, line, turn in (("right", ((1, 0), (0, 0)), mirror), ("left", ACROSS, lambda outline: outline)):
        skin = ramp((0, tone, 0), (0.45, tone), (1, tone), line=line)
        parts.append(Part(f"ear-near-{side}", "face", "ear", skin, (turn(rim),), 0))
        parts.append(Part(f"ear-near-inner-{side}", "face", "ear", p["skin.deep"], (turn(inner),), 0))
    return tuple(parts)


def nose_edges(p: Palette, edge: Loop) -> tuple[Part, ...]:
    """The ridge's edge against the far cheek, on either side: it shows as the head turns."""
    return tuple(
        Part(f"nose-edge-{side}", "nose", "nose", p["skin.wing"], (outline,), 0)
        for side, outline in (("right", mirror(edge)), ("left", edge))
    )


def nose_light(p: Palette, ridge: Loop, tip: Loop, strength: tuple[float, float]) -> tuple[Part, ...]:
    """The light along the ridge and on the tip."""
    return (
        Part("nose-light", "nose", "nose", p["skin.gleam"], (ridge,), strength[0]),
        Part("nose-tip-light", "nose", "nose", glow(p["skin.gleam"], 0.95, 0.5), (tip,), strength[1]),
    )


def face_outline(half: Sequence[tuple[float, float]]) -> Loop:
    """The whole outline from its right half, crown to chin."""
    right = loop(*half)
    return right + mirror(right)[1:-1]


def backdrop_parts(p: Palette) -> tuple[Part, ...]:
    """The ground and disc behind the bust."""
    ground = loop((-360, -318, 1), (360, -318, 1), (360, 402, 1), (-360, 402, 1))
    return (
        Part(
            "backdrop-ground", "background", "body", ramp((0, p["fixed.ground"]), (1, p["fixed.ground-low"])), (ground,)
        ),
        Part(
            "backdrop-disc",
            "background",
            "body",
            ramp((0, p["fixed.disc"]), (1, p["fixed.disc-low"])),
            (disc(0, 30, 292, 292),),
        ),
    )
