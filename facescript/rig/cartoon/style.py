"""What a cartoon face is made of, as data: its measures, colours and parts; a face's module fills it in."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from facescript.rig.cartoon.eye import EyeStyle
from facescript.rig.cartoon.lips import MouthStyle
from facescript.rig.cartoon.outline import Part
from facescript.rig.cartoon.palette import Palette


@dataclass(frozen=True, slots=True)
class BrowStyle:
    """Where a brow begins and ends, px from the axis."""

    inner: float
    outer: float


@dataclass(frozen=True, slots=True)
class FaceStyle:
    """One drawn face, px from the eyes' middle, y down. `parts` draws it with a palette, back to front.

    `outline` is the right half of the face's outline from crown to chin; `shell` the half width and height of the
    hair, in d; `nose_base` and `nose_width` are of the nose; `points` are the feature points that no drawn part
    has (`features.py`).
    """

    name: str
    d: float
    outline: tuple[tuple[float, float], ...]
    shell: tuple[float, float]
    nose_base: float
    nose_width: float
    eye: EyeStyle
    brow: BrowStyle
    mouth: MouthStyle
    palette: Palette
    parts: Callable[[Palette], tuple[Part, ...]]
    backdrop: Callable[[Palette], tuple[Part, ...]]
    points: Mapping[str, tuple[float, float]]
    hair: tuple[tuple[float, float], ...]
