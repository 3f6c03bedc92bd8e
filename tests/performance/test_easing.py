"""The easing curves: their ends, their speed, and that no movement goes back on itself."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facescript.performance.easing import EASINGS, easing, through

NAMES = sorted(EASINGS)
SHARES = np.linspace(0.0, 1.0, 10_001)


@pytest.mark.parametrize("name", NAMES)
def test_begins_at_exactly_nothing_and_ends_at_exactly_all(name: str) -> None:
    assert easing(name)(np.array([-1.0, 0.0, 1.0, 2.0])).tolist() == [0.0, 0.0, 1.0, 1.0]


@pytest.mark.parametrize("name", NAMES)
def test_never_goes_back(name: str) -> None:
    assert np.diff(easing(name)(SHARES)).min() > -1e-12


@pytest.mark.parametrize("name", [name for name in NAMES if name != "linear"])
def test_all_but_linear_are_at_rest_at_both_ends(name: str) -> None:
    speed = np.gradient(easing(name)(SHARES), SHARES)
    assert max(abs(speed[0]), abs(speed[-1])) < 1e-3
    assert np.abs(np.diff(speed)).max() < 0.01


def test_in_is_late_out_is_early_and_in_out_keeps_to_the_middle() -> None:
    early, half = ({name: float(easing(name)(np.array([share]))[0]) for name in NAMES} for share in (0.25, 0.5))
    assert early["in"] < early["in-out"] < early["smooth"] < early["out"]
    assert half["in"] < 0.3 and half["out"] > 0.7
    assert half["smooth"] == half["in-out"] == half["linear"] == 0.5


def test_smooth_is_what_is_meant_where_nothing_is_said() -> None:
    assert easing(None) is EASINGS["smooth"]


@given(st.lists(st.tuples(st.floats(0.01, 0.99), st.floats(-2, 2)), min_size=1, max_size=6, unique_by=lambda k: k[0]))
def test_a_curve_through_knots_meets_them_at_rest(inner: list[tuple[float, float]]) -> None:
    knots = [(0.0, 0.0), *sorted(inner), (1.0, 0.0)]
    curve = through(*knots)
    places = np.array([place for place, _ in knots])
    values = np.array([value for _, value in knots])
    assert curve(places) == pytest.approx(values, abs=1e-12)
    near = 1e-3 * np.diff(places).min()
    assert curve(places + near) == pytest.approx(values, abs=1e-6)
    assert curve(places - near) == pytest.approx(values, abs=1e-6)
