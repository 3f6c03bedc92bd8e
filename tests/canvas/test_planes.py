"""Video's colours and the planes for encoders: BT.709 by the book, and the same whether taken whole or in parts."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.canvas.box import Box
from facescript.canvas.planes import Planes
from facescript.canvas.video import video_pixels

WIDTH, HEIGHT = 400, 200
WHOLE = Box(0, 0, WIDTH, HEIGHT)


def noise(seed: int) -> np.ndarray:
    generator = np.random.default_rng(seed)
    return generator.integers(0, 2**24, (HEIGHT, WIDTH), dtype=np.uint32) | np.uint32(0xFF000000)


def by_the_book(pixels: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """ITU-R BT.709-6, 3.2 and 3.4: luma, and the colour differences of squares of four pixels, limited range."""
    red, green, blue = ((pixels >> shift & 0xFF) / 255 for shift in (16, 8, 0))
    luma = 0.2126 * red + 0.7152 * green + 0.0722 * blue
    difference = [(blue - luma) / 1.8556, (red - luma) / 1.5748]
    squares = [each.reshape(HEIGHT // 2, 2, WIDTH // 2, 2).mean(axis=(1, 3)) for each in difference]
    return 16 + 219 * luma, 128 + 224 * squares[0], 128 + 224 * squares[1]


def split(data: np.ndarray) -> list[np.ndarray]:
    luma, quarter = WIDTH * HEIGHT, WIDTH * HEIGHT // 4
    parts = data[:luma], data[luma : luma + quarter], data[luma + quarter :]
    return [part.astype(float) for part in parts]


def test_colours_are_bt709() -> None:
    planes = Planes(WIDTH, HEIGHT)
    planes.take(video_pixels(noise(1)), WHOLE)
    for ours, book in zip(split(planes.data), by_the_book(noise(1)), strict=True):
        assert np.abs(ours - book.ravel()).max() < 1.5
        assert abs((ours - book.ravel()).mean()) < 0.3


def test_greys_have_no_colour() -> None:
    planes = Planes(WIDTH, HEIGHT)
    grey = np.arange(WIDTH * HEIGHT, dtype=np.uint32).reshape(HEIGHT, WIDTH) % 256 * 0x010101 | np.uint32(0xFF000000)
    planes.take(video_pixels(grey), WHOLE)
    assert (split(planes.data)[1] == 128).all()
    assert (split(planes.data)[2] == 128).all()


@settings(max_examples=30, deadline=None)
@given(st.integers(0, WIDTH), st.integers(0, WIDTH), st.integers(0, HEIGHT), st.integers(0, HEIGHT))
def test_a_part_is_taken_as_in_the_whole(x: int, across: int, y: int, down: int) -> None:
    box = Box(x, y, min(x + across, WIDTH), min(y + down, HEIGHT))
    mixed = noise(2)
    box.of(mixed)[...] = box.of(noise(3))
    parts, whole = Planes(WIDTH, HEIGHT), Planes(WIDTH, HEIGHT)
    parts.take(noise(2), WHOLE)
    parts.take(mixed, box)
    whole.take(mixed, WHOLE)
    assert (parts.data == whole.data).all()
