"""The list of shapes, the looks, the backdrop: what others build on."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from facescript.performance.performance import REST
from facescript.resolve.kinds.library import kind_names, library_kind
from facescript.rig.cartoon.backdrop import backdrop
from facescript.rig.cartoon.palette import tinted, to_hex, to_lab
from facescript.rig.picture import Linear, Paint, Shape
from facescript.rig.rigs import rig, style
from rig.poses import plain

GOLDEN = Path(__file__).parent / "golden"
KINDS = pytest.mark.parametrize("kind", kind_names())
FAMILIES = {kind: {name.partition(".")[0] for name, _ in library_kind(kind).colours} for kind in kind_names()}
"""The families of colours of each kind."""


def paint(fill: Paint) -> str:
    if isinstance(fill, str):
        return fill
    stops = " ".join(
        f"{stop.colour}@{stop.offset:g}" + (f"/{stop.opacity:g}" if stop.opacity < 1 else "") for stop in fill.stops
    )
    return f"{'linear' if isinstance(fill, Linear) else 'radial'} {stops}"


def line(shape: Shape) -> str:
    segments = "+".join(str((contour.count - 1) // 3) for contour in shape.contours)
    clip = f" in {' '.join(shape.clip)}" if shape.clip else ""
    return f"{shape.group:11s} {shape.id:22s} {segments:14s} {paint(shape.fill)}{clip}\n"


@KINDS
def test_the_shape_list(kind: str) -> None:
    """A golden list: layer, id, segments of each contour, paint, clip."""
    text = "".join(line(shape) for shape in rig(plain(kind)).shapes)
    assert text == (GOLDEN / f"{kind}_shapes.txt").read_text()


@KINDS
def test_looks_tint_their_family_and_nothing_else(kind: str) -> None:
    usual = rig(plain(kind))
    look = "hair" if "hair" in FAMILIES[kind] else "clothes"
    parts = {"hair": ("hair-", "brow-body", "brow-hairs"), "clothes": ("clothes-",)}[look]
    tinted_rig = rig(plain(kind, **{look: "#ff88cc"}))
    changed = {a.id for a, b in zip(usual.shapes, tinted_rig.shapes, strict=True) if paint(a.fill) != paint(b.fill)}
    assert changed
    assert all(name.startswith(parts) for name in changed)


@KINDS
def test_looks_do_not_change_the_geometry(kind: str) -> None:
    usual, other = rig(plain(kind)), rig(plain(kind, skin="#6b4a36", eyes="#3a5fa0", lips="#803040", clothes="#aa3333"))
    assert np.array_equal(usual.draw(REST[None]).points, other.draw(REST[None]).points)


def test_an_unknown_kind_is_a_key_error() -> None:
    with pytest.raises(KeyError):
        rig(plain("unicorn"))


def test_a_tinted_family_keeps_its_order_of_lightness() -> None:
    """Light stays lighter than base and shade darker, whatever colour is given; the base becomes that colour."""
    palette = {"skin.base": "#f3c6a5", "skin.light": "#fbdcc3", "skin.shade": "#dc9c7c", "fixed.white": "#ffffff"}
    for colour in ("#3b2219", "#c08a5e", "#ffe0d0", "#808080", "#88ff88"):
        new = tinted(palette, {"skin": colour})
        assert new["skin.base"] == colour
        assert to_lab(new["skin.light"])[0] > to_lab(colour)[0] > to_lab(new["skin.shade"])[0]
        assert new["fixed.white"] == "#ffffff"


def test_colours_survive_oklab() -> None:
    for colour in ("#000000", "#ffffff", "#f3c6a5", "#14302a", "#0000ff", "#ff0000"):
        assert to_hex(to_lab(colour)) == colour


@KINDS
def test_the_backdrop_never_moves_and_fills_the_box(kind: str) -> None:
    shapes, picture = backdrop(style(plain(kind)))
    assert not any(shape.moving for shape in shapes)
    assert {shape.group for shape in shapes} == {"background"}
    ground = picture.points[0, : shapes[0].contours[0].count]
    assert ground.min(axis=0).tolist() == [0.0, 0.0] and ground.max(axis=0).tolist() == [720.0, 720.0]


@KINDS
def test_the_bust_reaches_below_the_box(kind: str) -> None:
    """A film taller than its faces shows no cut-off bust."""
    drawn = rig(plain(kind))
    points = drawn.draw(REST[None]).points[0]
    below = [
        shape.id
        for shape in drawn.shapes
        for contour in shape.contours
        if points[contour.first : contour.first + contour.count, 1].max() > 1100
    ]
    assert any(name.startswith(("clothes-", "body-")) for name in below)
