"""The painter: what it draws, and that a frame does not depend on the frames before it."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.canvas.box import Box
from facescript.canvas.painter import Painter
from facescript.rig.picture import Contour, Linear, Radial, Shape, Stop

WIDTH, HEIGHT = 96, 64
WHITE = np.full((HEIGHT, WIDTH), 0xFFFFFFFF, dtype=np.uint32)
BLUE = np.full((HEIGHT, WIDTH), 0xFF0000FF, dtype=np.uint32)
FADE = Linear((Stop(0.0, "#ff0000"), Stop(1.0, "#0000ff", 0.5)))
GLOW = Radial((Stop(0.0, "#ffff00"), Stop(1.0, "#ffff00", 0.0)))

OVAL = 13
"""Points of an oval."""


def oval(x: float, y: float, across: float, down: float) -> np.ndarray:
    """An ellipse of four cubics, clockwise from the right."""
    k = 4 / 3 * (math.sqrt(2) - 1)
    unit = [(1, 0), (1, k), (k, 1), (0, 1), (-k, 1), (-1, k), (-1, 0), (-1, -k), (-k, -1), (0, -1), (k, -1), (1, -k)]
    return np.array([x, y]) + np.array([*unit, unit[0]]) * (across, down)


def shape(number: int, fill: object = "#00ff00", clip: tuple[str, ...] = (), moving: bool = True) -> Shape:
    return Shape(f"s{number}", "face", (Contour(number * OVAL, OVAL),), fill, clip, moving)  # type: ignore[arg-type]


SHAPES = (
    shape(0, "#888888", moving=False),
    shape(1, GLOW, moving=False),
    shape(2, FADE),
    shape(3, "#00ff00", clip=("s2",)),
    shape(4, GLOW, clip=("s2", "s5")),
    shape(5, "#000000"),
)


def draw(
    shapes: tuple[Shape, ...],
    points: np.ndarray,
    opacity: object = None,
    ground: np.ndarray = WHITE,
    turns: np.ndarray | float = 0.0,
) -> np.ndarray:
    painter = Painter(WIDTH, HEIGHT, shapes)
    shades = np.ones(len(shapes)) if opacity is None else np.array(opacity, dtype=float)
    painter.draw(points, shades, ground, turns)
    return painter.pixels.copy()


ovals = st.tuples(st.floats(-20, 120), st.floats(-20, 90), st.floats(0, 60), st.floats(0, 60)).map(lambda it: oval(*it))
shades = st.sampled_from([0.0, 0.001, 0.3, 1.0])
frames = st.tuples(
    st.lists(ovals, min_size=6, max_size=6).map(np.concatenate),
    st.lists(shades, min_size=6, max_size=6).map(np.array),
    st.sampled_from([WHITE, BLUE]),
    st.lists(st.booleans(), min_size=6, max_size=6),
    st.sampled_from([0.0, 0.3]),
)


@settings(max_examples=60, deadline=None)
@given(st.lists(frames, min_size=2, max_size=5))
def test_a_frame_is_the_same_alone_and_in_a_run(run: list[tuple]) -> None:
    painter = Painter(WIDTH, HEIGHT, SHAPES)
    points = np.zeros((6 * OVAL, 2))
    for fresh, opacity, ground, keep, turns in run:
        points = np.where(np.repeat(keep, OVAL)[:, None], points, fresh)
        before = painter.pixels.copy()
        boxes = painter.draw(points, opacity, ground, turns)
        alone = draw(SHAPES, points, opacity, ground, turns)
        assert (painter.pixels == alone).all()
        for box in boxes:
            box.of(before)[...] = box.of(painter.pixels)
        assert (before == painter.pixels).all(), "something changed outside the boxes"


def test_a_frame_that_is_the_same_again_changes_nothing() -> None:
    painter = Painter(WIDTH, HEIGHT, SHAPES)
    points = np.concatenate([oval(40 + n, 30, 20, 10) for n in range(6)])
    assert painter.draw(points, np.ones(6), WHITE) == (Box(0, 0, WIDTH, HEIGHT),)
    assert not painter.draw(points + 1e-9, np.ones(6), WHITE)


def test_a_gradient_fades_though_its_outline_stands_still() -> None:
    painter = Painter(WIDTH, HEIGHT, (shape(0, FADE),))
    points = oval(48, 32, 30, 20)
    painter.draw(points, np.array([1.0]), WHITE)
    painter.draw(points, np.array([0.25]), WHITE)
    assert (painter.pixels == draw((shape(0, FADE),), points, [0.25])).all()


def test_clips_bound_a_shape_by_all_their_outlines_together() -> None:
    left, right, whole = oval(24, 32, 10, 10), oval(72, 32, 10, 10), oval(48, 32, 46, 30)
    shapes = (shape(0), shape(1), shape(2, "#ff0000", clip=("s0", "s1")))
    pixels = draw(shapes, np.concatenate([left, right, whole]), [0, 0, 1])
    assert pixels[32, 24] == pixels[32, 72] == 0xFFFF0000
    assert pixels[32, 48] == 0xFFFFFFFF
    red = (255 - (pixels & 0xFF).astype(float)).sum() / 255
    assert red == pytest.approx(2 * math.pi * 100, rel=0.02)


def test_gradients_span_the_bounding_box_of_the_curve() -> None:
    pixels = draw((shape(0, Linear((Stop(0, "#000000"), Stop(1, "#ff0000")))),), oval(48, 32, 30, 24))
    red = (pixels[:, 48] >> 16 & 0xFF).astype(int)
    assert red[10] < 20
    assert red[32] == pytest.approx(128, abs=6)
    assert red[54] > 235


@pytest.mark.parametrize("fill", [FADE, Linear(FADE.stops, (0.2, 0.9), (0.8, 0.1)), GLOW])
@pytest.mark.parametrize("turn", [-0.5, 0.02, 0.4])
def test_a_gradient_turns_with_its_outline(fill: Linear | Radial, turn: float) -> None:
    """The colours of a turned leaf are those of the upright one at the places that turn there."""
    middle = np.array([48.0, 32.0])
    cos, sin = math.cos(turn), math.sin(turn)
    leaf = oval(0, 0, 26, 15)
    leaf[1:3] += (4, 6)
    leaf[7:9] -= (9, 1)
    upright = draw((shape(0, fill),), middle + leaf).view(np.uint8).reshape(HEIGHT, WIDTH, 4).astype(float)
    turned = middle + leaf @ np.array([[cos, sin], [-sin, cos]])
    pixels = draw((shape(0, fill),), turned, turns=np.array([turn])).view(np.uint8).reshape(HEIGHT, WIDTH, 4)
    for place in np.array([(-14, 0), (14, 2), (0, -9), (3, 9), (8, 4), (-6, -5), (0, 0)]):
        there = place @ np.array([[cos, sin], [-sin, cos]])
        assert between(pixels, middle + there) == pytest.approx(between(upright, middle + place), abs=3.0)


def between(pixels: np.ndarray, place: np.ndarray) -> np.ndarray:
    """The colour at a place that is no pixel's middle."""
    (column, row), (x, y) = np.floor(place - 0.5).astype(int), (place - 0.5) % 1.0
    four = pixels[row : row + 2, column : column + 2].astype(float)
    return np.asarray(np.einsum("y,x,yxc->c", (1 - y, y), (1 - x, x), four))


def test_a_turn_alone_changes_a_gradient_and_nothing_else() -> None:
    painter = Painter(WIDTH, HEIGHT, (shape(0), shape(1, FADE)))
    points = np.concatenate([oval(30, 30, 20, 10), oval(60, 30, 20, 10)])
    painter.draw(points, np.ones(2), WHITE)
    assert not painter.draw(points, np.ones(2), WHITE, np.array([0.3, 0.0]))
    assert painter.draw(points, np.ones(2), WHITE, np.array([0.3, 0.3]))


def test_opacity_mixes_with_what_lies_below() -> None:
    pixel = draw((shape(0, "#000000"),), oval(48, 32, 30, 20), [0.5])[32, 48]
    assert int(pixel) & 0xFF == pytest.approx(127, abs=2)


def test_a_stage_without_shapes_is_its_ground() -> None:
    assert (draw((), np.zeros((0, 2)), []) == WHITE).all()


def test_what_is_drawn_agrees_with_cairo() -> None:
    cairo = pytest.importorskip("cairo")
    fills = ("#cc8844", "#2266aa", "#113322")
    places = [oval(40, 30, 30, 20), oval(50.3, 36.7, 12.5, 20.2), oval(60, 20, 9, 3.4)]
    surface = cairo.ImageSurface(cairo.FORMAT_RGB24, WIDTH, HEIGHT)
    pen = cairo.Context(surface)
    pen.set_source_rgb(1, 1, 1)
    pen.paint()
    for fill, points in zip(fills, places, strict=True):
        pen.move_to(*points[0])
        for at in range(1, OVAL, 3):
            pen.curve_to(*points[at : at + 3].ravel())
        pen.set_source_rgb(*(int(fill[n : n + 2], 16) / 255 for n in (1, 3, 5)))
        pen.fill()
    surface.flush()
    theirs = np.frombuffer(surface.get_data(), np.uint8).reshape(HEIGHT, WIDTH, 4)[..., :3].astype(int)
    shapes = tuple(replace(shape(n), fill=fill) for n, fill in enumerate(fills))
    ours = draw(shapes, np.concatenate(places)).view(np.uint8).reshape(HEIGHT, WIDTH, 4)[..., :3].astype(int)
    assert np.abs(ours - theirs).mean() < 0.3
    assert np.abs(ours - theirs).max() < 24
