"""A kind of face as data: its measures, colours, shapes, and what moves them; the rig draws it.

Lengths are points of the art box, 720 x 720 of them, from the middle between the eyes: x to the viewer's right, y down.
Depths are in eye distances in front of the neck's axis. What is noted is the face's left side (x > 0); the right is its
mirror image.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from facescript.ir.acts import Voice
from facescript.text import Span

BOX = 720
"""Points of the art box, across and down."""


@dataclass(frozen=True, slots=True)
class Tone:
    """A colour: a name of the palette (`skin.base`) or `#rrggbb`; `share` of the way to `other`."""

    name: str
    other: str = ""
    share: float = 0.0


@dataclass(frozen=True, slots=True)
class TonedStop:
    """A place of a gradient, 0..1: its colour there, and its opacity."""

    tone: Tone
    at: float
    opacity: float = 1.0


@dataclass(frozen=True, slots=True)
class Fill:
    """What a shape is filled with. `where` is, in fractions of its bounding box, of a line x0, y0, x1, y1 and of a
    round one the centre and the radius; an `outward` one is mirrored on the face's right."""

    form: Literal["plain", "line", "round"]
    stops: tuple[TonedStop, ...]
    where: tuple[float, ...] = ()
    outward: bool = False


@dataclass(frozen=True, slots=True)
class KindPoint:
    """A point of an outline: x, y, and of a stroke its width, of an ellipse its radii; a corner if `sharp`; its own
    depth, if it has one."""

    numbers: tuple[float, ...]
    sharp: bool = False
    depth: float | None = None


@dataclass(frozen=True, slots=True)
class KindOutline:
    """A closed curve through points; the right half of one; a tapered stroke; a small ellipse at one depth; a disc."""

    form: Literal["outline", "half", "stroke", "spot", "disc"]
    points: tuple[KindPoint, ...]


@dataclass(frozen=True, slots=True)
class KindShape:
    """A shape, in drawing order. `sides` says whether it stands on both, and if so whether in a layer each. Without
    outlines it is drawn by the eye or the mouth. `when` are the looks under which it is there: name and choices."""

    id: str
    group: str
    law: str
    fill: Fill
    span: Span
    outlines: tuple[KindOutline, ...] = ()
    opacity: float = 1.0
    clip: tuple[str, ...] = ()
    sides: Literal["", "both", "each"] = ""
    depth: float | None = None
    when: tuple[tuple[str, tuple[str, ...]], ...] = ()


@dataclass(frozen=True, slots=True)
class PullField:
    """How far a signal moves what is near a place: x, y; dx, dy; fading out at the distance `within`."""

    at: tuple[float, float]
    by: tuple[float, float]
    within: float


@dataclass(frozen=True, slots=True)
class Pull:
    """What a signal at 1 moves: each anchor of the shapes `by` an offset (or all by one), or by fields."""

    signal: str
    shapes: tuple[str, ...]
    span: Span
    sides: bool = False
    by: tuple[tuple[float, float], ...] = ()
    fields: tuple[PullField, ...] = ()


@dataclass(frozen=True, slots=True)
class ShadeTerm:
    """A signal's share in an opacity; with another it counts as that one does."""

    signal: str
    share: float
    other: str = ""


@dataclass(frozen=True, slots=True)
class Shade:
    """How much more (or less) a shape shows by signals, its opacity never above `most`."""

    shape: str
    terms: tuple[ShadeTerm, ...]
    span: Span
    sides: bool = False
    most: float = 1.0


@dataclass(frozen=True, slots=True)
class Measures:
    """The measures of an eye, of the mouth: numbers by name. An eye that is not one of the usual two has a name and a
    place."""

    values: tuple[tuple[str, tuple[float, ...]], ...]
    name: str = ""
    at: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class KindJaw:
    """Flesh lower than `start` goes down with the jaw, the chin by `drop`, the shadow below it by a part of that."""

    start: float = 62.0
    drop: float = 24.0


@dataclass(frozen=True, slots=True)
class Tint:
    """A colour with a name; `goes` are the skins that it goes with, all if none is named."""

    name: str
    colour: str
    goes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class KindHead:
    """What a face may choose of its kind: the usual voice, channels of its own, `looks` (choices by name, the first one
    usual), `amounts` (signals that a face sets once, with the value for which the kind is drawn), the families that
    take a colour, and colours by family that have a name."""

    voice: Voice | None = None
    channels: tuple[str, ...] = ()
    looks: tuple[tuple[str, tuple[str, ...]], ...] = ()
    amounts: tuple[tuple[str, float], ...] = ()
    families: tuple[str, ...] = ()
    tints: tuple[tuple[str, tuple[Tint, ...]], ...] = ()


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of face. `outline` is the right half of the head's, crown to chin; `shell` the half width and height of
    hair or skull in eye distances; `nose` the height of its base and its width; `points` are feature points by name
    that no shape has, `hair` those round the hair."""

    name: str
    distance: float
    eyes_at: tuple[float, float]
    outline: tuple[tuple[float, float], ...]
    shell: tuple[float, float]
    nose: tuple[float, float]
    eyes: tuple[Measures, ...]
    mouth: Measures
    shapes: tuple[KindShape, ...]
    pulls: tuple[Pull, ...]
    shades: tuple[Shade, ...]
    colours: tuple[tuple[str, str], ...]
    span: Span
    jaw: KindJaw = KindJaw()
    head: KindHead = KindHead()
    points: tuple[tuple[str, tuple[float, float]], ...] = ()
    hair: tuple[tuple[float, float], ...] = ()
