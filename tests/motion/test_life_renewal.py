"""Waits have the distribution they were given, whatever interrupts them, and what happened long ago is forgotten."""

from __future__ import annotations

from itertools import pairwise
from math import log

import numpy as np
import pytest
from distributions import gamma_of_two, kolmogorov_smirnov
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.motion.dice import Dice, Event
from facescript.motion.life.renewal import Span, Wait, gamma_wait, log_normal_wait, renewals
from facescript.motion.life.stretches import NEVER, Stretches

HOUR = Span(0.0, 3600.0)


def found(wait: Wait, seed: int, closed: Stretches = NEVER, least: float = 0.0, span: Span = HOUR) -> list[Event]:
    return list(renewals(Dice(seed, ()), "blink", wait, span, lambda number: 0.2 + number % 7 / 100, closed, least))


def waits(events: list[Event]) -> np.ndarray:
    return np.array([after.start - before.end for before, after in pairwise(events)])


@pytest.mark.parametrize("seed", range(1, 6))
def test_gamma_waits_are_gamma(seed: int) -> None:
    assert kolmogorov_smirnov(waits(found(gamma_wait(1.48), seed)), gamma_of_two(1.48)) > 0.01


@pytest.mark.parametrize(("mean", "variation"), [(3.13, 1.01), (7.92, 0.2), (0.8, 0.5)])
def test_log_normal_waits_have_their_mean_and_deviation(mean: float, variation: float) -> None:
    some = np.concatenate([waits(found(log_normal_wait(mean, variation), seed)) for seed in range(1, 9)])
    assert some.mean() == pytest.approx(mean, rel=0.05)
    assert some.std() == pytest.approx(mean * variation, rel=0.15)
    assert np.median(some) == pytest.approx(mean / np.sqrt(1.0 + variation**2), rel=0.05)
    assert some.min() > 0.0


def test_interruptions_bias_no_wait() -> None:
    """Waits that are cut off say only that they were longer: the chances passed by come to one an event."""
    theta, risked, events = 1.48, 0.0, 0
    for seed in range(1, 9):
        closed = Stretches((5.0 * k, 5.0 * k + 0.25) for k in range(720))
        rest = 0.0
        for event in sorted([*found(gamma_wait(theta), seed, closed, 0.5), *(Event(-1, *one) for one in closed)],
                            key=lambda one: one.start):  # fmt: skip
            free = event.index >= 0
            waited = (event.start if free else event.start - 0.5) - rest
            risked += max(0.0, waited) / theta - log(1.0 + max(0.0, waited) / theta)
            events += free
            rest = event.end
    assert events > 5000
    assert events / risked == pytest.approx(1.0, abs=0.04)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 500), st.lists(st.floats(0.0, 20.0), max_size=4))
def test_nothing_begins_where_it_may_not(seed: int, starts: list[float]) -> None:
    closed = Stretches((start, start + 1.5) for start in starts)
    for event in found(log_normal_wait(0.6, 0.5), seed, closed, 0.1, Span(0.0, 30.0)):
        shut, opened = closed.next(event.start)
        assert (event.start + 0.1 <= shut and event.end <= shut) or shut == opened


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 500), st.floats(0.0, 20.0), st.sampled_from([gamma_wait(1.48), log_normal_wait(3.13, 1.01)]))
def test_what_happened_early_is_forgotten(seed: int, start: float, wait: Wait) -> None:
    span = Span(0.0, 400.0)
    one, other = found(wait, seed, span=span), found(wait, seed, Stretches([(start, start + 1.0)]), span=span)
    late = [[event for event in events if event.start > 200.0] for events in (one, other)]
    assert late[0] == late[1] != []


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 500), st.floats(0.0, 1000.0))
def test_a_process_that_starts_later_is_the_same_later(seed: int, shift: float) -> None:
    wait = log_normal_wait(2.0, 0.6)
    one, other = (found(wait, seed, span=Span(start, start + 60.0)) for start in (0.0, shift))
    assert [event.index for event in one] == [event.index for event in other]
    assert [event.start + shift for event in one] == pytest.approx([event.start for event in other])


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 50), st.integers(1, 9))))
def test_stretches_and_what_they_leave_free_make_a_whole(pairs: list[tuple[int, int]]) -> None:
    made = Stretches((start, start + length) for start, length in pairs)
    parts = sorted([*((max(0, low), min(60, high)) for low, high in made), *made.between(0, 60)])
    assert [low for low, _ in parts] == [0, *(high for _, high in parts[:-1])] and parts[-1][1] == 60
    for time in range(60):
        inside = any(start <= time < start + length for start, length in pairs)
        assert (made.next(time)[0] <= time) == inside
