"""A face's colours by family, and one new colour a family -> the whole family in the new colour."""

from __future__ import annotations

import math
from collections.abc import Mapping

from facescript.rig.picture import Tone

Palette = dict[str, str]
"""Colours `#rrggbb` by `family.tone`, e.g. `skin.base`."""

Lab = tuple[float, float, float]


TONED = 0.6
"""How much of a tone's own chroma and hue (against its base) a new colour keeps: all of it looks painted on."""

COLOURED = 0.04
"""From this chroma on a pale colour's shadows are as much more vivid than it as those of the drawn one: pale skin has
shadows of flesh; a grey has grey ones."""

BRIGHTEST = 1.6
"""Light tones stand out from a dark base by at most this many times what they do from the drawn one."""

BROWS = "#2e211b", 0.4
"""Brows are darker than hair: the hair's colour with this share of this brown."""

BEARD = "#3a2318", 0.15
"""So are beards, by less."""


def tinted(palette: Mapping[str, str], looks: Mapping[str, str]) -> Palette:
    """The palette with each family of `looks` (hair, skin, eyes, lips, clothes) built on the colour given.

    Every tone keeps its place in lightness against the family's `base`, and most of its share of chroma and its
    difference of hue, measured in OKLab (B. Ottosson, 2020). Brows and a beard follow the hair. A family that the face
    does not have (a dog's skin) changes nothing.
    """
    out = dict(palette)
    families = dict(looks)
    if "hair" in families:
        families.setdefault("brows", mix(families["hair"], *BROWS))
        families.setdefault("beard", mix(families["hair"], *BEARD))
    for family, colour in families.items():
        if f"{family}.base" not in palette:
            continue
        base = to_lab(palette[f"{family}.base"])
        for name, tone in palette.items():
            if name.startswith(f"{family}."):
                out[name] = to_hex(_moved(to_lab(tone), base, to_lab(colour[:7])))
    return named(out)


def named(palette: Mapping[str, str]) -> Palette:
    """The palette with colours that know their names."""
    return {name: Tone(colour, name) for name, colour in palette.items()}


def mix(a: str, b: str, t: float) -> str:
    """Between two colours, channel by channel; a mixture of tones is a tone."""
    pairs = zip(_channels(a), _channels(b), strict=True)
    mixed = "#" + "".join(f"{round(x + (y - x) * t):02x}" for x, y in pairs)
    if isinstance(a, Tone) and isinstance(b, Tone):
        return Tone(mixed, f"{a.name}-{b.name}-{100 * t:.0f}", (a, b, t))
    return mixed


def _moved(tone: Lab, base: Lab, new: Lab) -> Lab:
    darker = new[0] * tone[0] / base[0]
    lighter = new[0] + (tone[0] - base[0]) * min(BRIGHTEST, (1 - new[0]) / (1 - base[0]))
    chroma, hue = _polar(tone)
    base_chroma, base_hue = _polar(base)
    new_chroma, new_hue = _polar(new)
    share = new_chroma * (chroma / max(base_chroma, 1e-3)) ** TONED
    if chroma > base_chroma:
        share = max(share, new_chroma + min(1.0, new_chroma / COLOURED) * (chroma - base_chroma))
    angle = new_hue + TONED * math.remainder(hue - base_hue, math.tau)
    return (darker if tone[0] <= base[0] else lighter, share * math.cos(angle), share * math.sin(angle))


def _polar(lab: Lab) -> tuple[float, float]:
    return math.hypot(lab[1], lab[2]), math.atan2(lab[2], lab[1])


def _channels(colour: str) -> tuple[int, int, int]:
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def to_lab(colour: str) -> Lab:
    """`#rrggbb` to OKLab."""
    r, g, b = (_linear(c / 255) for c in _channels(colour))
    long = (0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) ** (1 / 3)
    medium = (0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) ** (1 / 3)
    short = (0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b) ** (1 / 3)
    return (
        0.2104542553 * long + 0.7936177850 * medium - 0.0040720468 * short,
        1.9779984951 * long - 2.4285922050 * medium + 0.4505937099 * short,
        0.0259040371 * long + 0.7827717662 * medium - 0.8086757660 * short,
    )


def to_hex(lab: Lab) -> str:
    """OKLab to the nearest `#rrggbb`."""
    light, a, b = lab
    long = (light + 0.3963377774 * a + 0.2158037573 * b) ** 3
    medium = (light - 0.1055613458 * a - 0.0638541728 * b) ** 3
    short = (light - 0.0894841775 * a - 1.2914855480 * b) ** 3
    rgb = (
        4.0767416621 * long - 3.3077115913 * medium + 0.2309699292 * short,
        -1.2684380046 * long + 2.6097574011 * medium - 0.3413193965 * short,
        -0.0041960863 * long - 0.7034186147 * medium + 1.7076147010 * short,
    )
    return "#" + "".join(f"{round(255 * min(1.0, max(0.0, _coded(c)))):02x}" for c in rgb)


def _linear(value: float) -> float:
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def _coded(value: float) -> float:
    value = max(0.0, value)
    return value * 12.92 if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
