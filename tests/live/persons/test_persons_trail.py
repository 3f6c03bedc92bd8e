"""The path of a person seen live: what it says of a time it says for ever, and it jumps only where she was lost."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.ir.values import Point
from facescript.space.trail import STOPPING, Fix, Leg, Trail

places = st.tuples(st.floats(-200, 200), st.floats(-100, 100), st.floats(30, 400))
speeds = st.tuples(st.floats(-150, 150), st.floats(-50, 50), st.floats(-100, 100))
learned = st.lists(
    st.tuples(st.sampled_from([0.0, 0.01, 0.033, 0.2, 0.7, 1.5]), places, speeds, st.floats(0, 0.15), st.booleans()),
    min_size=1,
    max_size=12,
)


def fix(time: float, place: tuple[float, float, float], speed: tuple[float, float, float]) -> Fix:
    return Fix(time, place, speed, 0.2, time + 0.6)


def values(trail: Trail, times: np.ndarray) -> np.ndarray:
    return np.array([(point.x, point.y, point.z) for point in map(trail.at, times.tolist())])


@settings(max_examples=25, deadline=None)
@given(learned)
def test_what_was_said_of_a_time_is_said_for_ever(what: list) -> None:
    trail, now, said = Trail(), 1.0, []
    for step, place, speed, late, jump in what:
        times = np.linspace(now, now + step, 9)[1:]
        trail.final = max(trail.final, now + step)
        said.append((times, values(trail, times), [trail.gap(time) is None for time in times.tolist()]))
        now = float(np.nextafter(now + step, inf))
        trail.learn(now, fix(now - late, place, speed), jump)
    for times, before, seen in said[1:]:
        assert np.array_equal(values(trail, times), before)
        assert [trail.gap(time) is None for time in times.tolist()] == seen


@settings(max_examples=25, deadline=None)
@given(learned)
def test_nothing_jumps_but_where_she_was_lost(what: list) -> None:
    trail, now = Trail(), 1.0
    for step, place, speed, late, _ in what:
        now += min(step, 0.4) + 0.01
        trail.learn(now, fix(now - late, place, speed))
        if len(trail.legs) > 1:
            old, new = trail.legs[-2], trail.legs[-1]
            (place, speed), (other, faster) = _moved(old, now), _moved(new, now)
            assert place == pytest.approx(other, abs=1e-6)
            assert speed == pytest.approx(faster, abs=2.0)


def _moved(leg: Leg, time: float) -> tuple[float, float]:
    """Place and speed of a leg, the first axis."""
    low, here, high = (leg.at(time + offset).x for offset in (-1e-5, 0.0, 1e-5))
    return here, (high - low) / 2e-5


def test_she_goes_on_stops_and_is_lost() -> None:
    trail = Trail()
    trail.learn(1.0, Fix(0.9, (0.0, 0.0, 100.0), (100.0, 0.0, 0.0), 0.2, 1.5))
    assert trail.at(1.0) == Point(pytest.approx(10.0), 0.0, 100.0)
    assert trail.at(1.1).x == pytest.approx(20.0)
    stopped = trail.at(1.1 + STOPPING).x
    assert stopped == pytest.approx(20.0 + 100.0 * STOPPING / 2)
    assert trail.at(9.0).x == stopped
    assert trail.gap(1.6) is None
    trail.final = 1.6
    assert trail.gap(1.6) == (1.5, inf)
    trail.learn(2.0, Fix(2.0, (-50.0, 0.0, 100.0), (0.0, 0.0, 0.0), 0.2, 2.6))
    assert trail.gaps() == [(-inf, 1.0), (1.5, 2.0)]
    assert trail.at(1.99).x == stopped
    assert trail.at(2.0).x == -50.0


def test_it_can_be_asked_what_was_expected() -> None:
    trail = Trail()
    trail.learn(1.0, Fix(1.0, (0.0, 0.0, 100.0), (100.0, 0.0, 0.0), 0.2, inf))
    expected = trail.at(1.15)
    trail.learn(1.1, Fix(1.1, (10.0, 0.0, 100.0), (-100.0, 0.0, 0.0), 0.2, inf))
    assert trail.at(1.15, known=1.05) == expected
    assert trail.at(1.15).x < expected.x


def test_what_is_final_cannot_be_changed() -> None:
    trail = Trail()
    trail.final = 2.0
    with pytest.raises(ValueError, match="final"):
        trail.learn(1.9, fix(1.9, (0.0, 0.0, 100.0), (0.0, 0.0, 0.0)))
