"""A kind as data and the looks chosen -> what the cartoon rig draws: measures, parts, what moves and shades them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from facescript.ir.kind import Kind, KindJaw, Measures, Pull, Shade
from facescript.performance.channels import SIDES
from facescript.rig.cartoon.drawn import Choices, measured, parts_of
from facescript.rig.cartoon.eye import EyeStyle
from facescript.rig.cartoon.lips import MouthStyle
from facescript.rig.cartoon.outline import Part
from facescript.rig.cartoon.palette import Palette

BACKGROUND = "background"
"""The layer of those shapes that stand behind all faces."""


@dataclass(frozen=True, slots=True)
class Eye:
    """One eye: its name, where its middle is (px from the middle between the usual two), its measures."""

    name: str
    x: float
    y: float
    style: EyeStyle


@dataclass(frozen=True, slots=True)
class FaceStyle:
    """One drawn face, px from the eyes' middle, y down; `parts` are drawn back to front, `backdrop` behind all faces.

    `outline` is the right half of the face's outline from crown to chin; `shell` the half width and height of the
    hair, in d; `nose_base` and `nose_width` are of the nose; `points` and `hair` are the feature points that no drawn
    part has (`features.py`), none of a kind without them; `amounts` are signals that stay as they are.
    """

    name: str
    d: float
    eyes_at: tuple[float, float]
    outline: tuple[tuple[float, float], ...]
    shell: tuple[float, float]
    nose_base: float
    nose_width: float
    jaw: KindJaw
    eyes: tuple[Eye, ...]
    mouth: MouthStyle
    parts: tuple[Part, ...]
    backdrop: tuple[Part, ...]
    pulls: tuple[Pull, ...]
    shades: tuple[Shade, ...]
    points: Mapping[str, tuple[float, float]]
    hair: tuple[tuple[float, float], ...]
    amounts: Mapping[str, float]


def style_of(kind: Kind, palette: Palette, choices: Choices, amounts: Mapping[str, float]) -> FaceStyle:
    """The style of a kind in a palette; what is not chosen is as usual."""
    chosen = {name: options[0] for name, options in kind.head.looks} | dict(choices)
    own = {name: amounts.get(name, usual) - usual for name, usual in kind.head.amounts}
    hidden = _hidden(kind, own)
    parts = [part for part in parts_of(kind, palette, chosen) if part.opacity > 0.0 or part.id not in hidden]
    return FaceStyle(
        name=kind.name,
        d=kind.distance,
        eyes_at=kind.eyes_at,
        outline=kind.outline,
        shell=kind.shell,
        nose_base=kind.nose[0],
        nose_width=kind.nose[1],
        jaw=kind.jaw,
        eyes=tuple(eye for measures in kind.eyes for eye in _eyes(measures, kind.distance)),
        mouth=MouthStyle(**measured(kind.mouth)),
        parts=tuple(part for part in parts if part.group != BACKGROUND),
        backdrop=tuple(part for part in parts if part.group == BACKGROUND),
        pulls=kind.pulls,
        shades=kind.shades,
        points=dict(kind.points),
        hair=kind.hair,
        amounts=own,
    )


def _hidden(kind: Kind, amounts: Mapping[str, float]) -> set[str]:
    """The parts that only the face's amounts could show, and do not: they need not be drawn at all."""
    found: set[str] = set()
    for shade in kind.shades:
        if all(term.signal in amounts for term in shade.terms):
            shown = sum(term.share * amounts[term.signal] for term in shade.terms)
            names = (shade.shape, *(f"{shade.shape}-{side}" for side in SIDES))
            found.update(names if shown <= 0.0 else ())
    return found


def _eyes(measures: Measures, d: float) -> Iterator[Eye]:
    """The eyes of a row: the face's right and left one, or the one that it names."""
    style = EyeStyle(**measured(measures, LISTS))
    if measures.name:
        yield Eye(measures.name, *measures.at, style)
    else:
        yield from (Eye(side, sign * d / 2, 0.0, style) for side, sign in (("right", -1), ("left", 1)))


LISTS = ("lash",)
"""Measures that may stand more than once."""
