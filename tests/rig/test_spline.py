"""Hobby's spline as a map from anchors to handles: exact where it was fitted, smooth wherever the anchors go."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.rig.cartoon.outline import disc, loop, mirror, ribbon
from facescript.rig.cartoon.spline import Anchor, handle_map

BLOB: tuple[Anchor, ...] = loop((0, 0), (40, -12), (70, 10), (62, 48), (30, 60), (-8, 38))
LEAF: tuple[Anchor, ...] = loop((0, 0, 1), (20, -14), (45, -10), (70, 4, 1), (46, 14), (18, 12))


def handles(outline: tuple[Anchor, ...], at: np.ndarray) -> np.ndarray:
    """Handles array[segment, 2, 2] of the outline fitted as given, for anchors `at`."""
    return np.array([[sum(w * at[k] for k, w in handle) for handle in pair] for pair in handle_map(outline)])


def places(outline: tuple[Anchor, ...]) -> np.ndarray:
    return np.array([anchor[:2] for anchor in outline])


def test_a_circle_is_a_circle() -> None:
    """Four anchors: the handles are 0.5523 of the radius, within a thousandth."""
    arms = handles(disc(0, 0, 1, 1), places(disc(0, 0, 1, 1)))
    assert arms[0, 0] == pytest.approx([1, 0.5523], abs=1e-3)
    assert arms[0, 1] == pytest.approx([0.5523, 1], abs=1e-3)


@pytest.mark.parametrize("outline", [BLOB, LEAF])
def test_weights_add_to_one(outline: tuple[Anchor, ...]) -> None:
    """So a shift of all anchors shifts the curve."""
    for pair in handle_map(outline):
        for handle in pair:
            assert sum(w for _, w in handle) == pytest.approx(1.0)
            assert len({k for k, _ in handle}) == len(handle) <= 3


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(st.floats(-15, 15), st.floats(-15, 15)), min_size=6, max_size=6))
def test_smooth_anchors_stay_smooth(shifts: list[tuple[float, float]]) -> None:
    """However the anchors move, the arms at each lie on one line and point apart (G1)."""
    at = places(BLOB) + np.array(shifts)
    arms = handles(BLOB, at)
    for i in range(len(BLOB)):
        out, into = arms[i, 0] - at[i], arms[i - 1, 1] - at[i]
        if min(np.hypot(*out), np.hypot(*into)) > 0.5:
            assert out[0] * into[1] - out[1] * into[0] == pytest.approx(
                0, abs=1e-6 * np.hypot(*out) * np.hypot(*into) + 1e-6
            )
            assert out @ into < 0


def test_the_fit_is_hobbys() -> None:
    """At the fitted anchors the mock curvature is continuous: turning in equals turning out at each smooth anchor."""
    at = places(BLOB)
    arms = handles(BLOB, at)
    for i in range(len(BLOB)):
        before = _curvature(at[i - 1], arms[i - 1, 0], arms[i - 1, 1], at[i], end=True)
        after = _curvature(at[i], arms[i, 0], arms[i, 1], at[(i + 1) % len(BLOB)], end=False)
        assert before == pytest.approx(after, rel=0.5, abs=0.01)


def _curvature(a: np.ndarray, b: np.ndarray, c: np.ndarray, d: np.ndarray, end: bool) -> float:
    one, two = ((d - c), (c - b)) if end else ((b - a), (c - b))
    cross = two[0] * one[1] - two[1] * one[0] if end else one[0] * two[1] - one[1] * two[0]
    return float(2 / 3 * cross / math.hypot(*one) ** 3)


def test_corners_have_arms_of_their_own() -> None:
    arms, at = handles(LEAF, places(LEAF)), places(LEAF)
    out, into = arms[0, 0] - at[0], arms[-1, 1] - at[0]
    assert abs(out[0] * into[1] - out[1] * into[0]) > 1


def test_a_ribbon_is_as_wide_as_said() -> None:
    outline = ribbon((0, 0, 0.01), (10, 0, 4), (20, 0, 0.01))
    ys = [y for _, y, _ in outline]
    assert max(ys) - min(ys) == pytest.approx(4)
    assert sum(corner for _, _, corner in outline) == 2


def test_a_mirror_mirrors() -> None:
    assert sorted(mirror(LEAF)) == sorted((-x, y, corner) for x, y, corner in LEAF)
    assert mirror(mirror(LEAF)) == LEAF
