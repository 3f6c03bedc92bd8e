"""Premultiplied pixels to straight ones: colours come back whole, edges look like what they are the edge of."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facescript.canvas.alpha import ClearPlanes, bled, cut_out, straight

HAIR = (0x80, 0x40, 0x20)


def premultiplied(colour: tuple[int, int, int], alpha: int) -> int:
    red, green, blue = (round(channel * alpha / 255) for channel in colour)
    return alpha << 24 | red << 16 | green << 8 | blue


def channels(pixel: int) -> tuple[int, ...]:
    return tuple(int(pixel) >> shift & 0xFF for shift in (24, 16, 8, 0))


def bust(alpha: int = 128) -> np.ndarray:
    """A block of hair with an edge of the given opacity on a clear ground."""
    pixels = np.zeros((90, 160), dtype=np.uint32)
    pixels[30:, 40:100] = premultiplied(HAIR, 255)
    pixels[30:, 39] = premultiplied(HAIR, alpha)
    return pixels


@given(st.tuples(*[st.integers(0, 255)] * 3), st.integers(1, 255))
def test_a_straight_colour_over_a_ground_is_the_premultiplied_one(colour: tuple[int, int, int], alpha: int) -> None:
    before = premultiplied(colour, alpha)
    (after,) = straight(np.array([before], dtype=np.uint32)).tolist()
    assert channels(after)[0] == alpha
    for whole, dimmed in zip(channels(after)[1:], channels(before)[1:], strict=True):
        assert whole * alpha / 255 == pytest.approx(dimmed, abs=0.51)


def test_opaque_and_clear_pixels_stay_as_they_are() -> None:
    pixels = np.array([0, 0xFF123456, 0xFF000000], dtype=np.uint32)
    assert (straight(pixels) == pixels).all()


def test_a_cut_keeps_whole_colours_and_knows_no_half() -> None:
    cut = cut_out(np.array([premultiplied(HAIR, alpha) for alpha in (0, 127, 128, 255)], dtype=np.uint32))
    assert cut.tolist()[:2] == [0, 0]
    assert channels(cut[2]) == pytest.approx((255, *HAIR), abs=1)
    assert channels(cut[3]) == (255, *HAIR)


@pytest.mark.parametrize("alpha", [3, 40, 200])
def test_what_is_clear_takes_the_colour_beside_it(alpha: int) -> None:
    whole = bled(bust(alpha))
    for x in (0, 30, 39, 40, 70, 105, 159):
        assert channels(whole[60, x]) == pytest.approx((255, *HAIR), abs=6), x


def test_a_picture_of_nothing_has_some_colour() -> None:
    assert (bled(np.zeros((5, 7), dtype=np.uint32)) >> 24 == 255).all()


def test_planes_end_in_the_opacity() -> None:
    planes = ClearPlanes(160, 90)
    planes.take(bust())
    alpha = planes.data[-160 * 90 :].reshape(90, 160)
    assert (alpha == bust() >> 24).all()
    luma = planes.data[: 160 * 90].reshape(90, 160)
    assert np.ptp(luma[60].astype(int)) < 6, "nothing of the clear ground's colour is in the picture"
