"""The cheapest pairs, against all there are."""

from __future__ import annotations

from itertools import permutations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.live.seeing.assignment import pairs

TABLES = st.integers(0, 4).flatmap(
    lambda columns: st.lists(st.lists(st.floats(0.0, 2.0), min_size=columns, max_size=columns), min_size=0, max_size=4)
)


def cheapest(costs: list[list[float]]) -> float:
    """The least cost of all matchings, where one that stays alone costs 1."""
    rows, columns = len(costs), len(costs[0]) if costs else 0
    best = float(rows)
    for places in permutations([*range(columns), *[-1] * rows], rows):
        best = min(best, sum(1.0 if place < 0 else costs[row][place] for row, place in enumerate(places)))
    return best


@given(TABLES)
@settings(max_examples=50)
def test_nothing_is_cheaper(costs: list[list[float]]) -> None:
    found = pairs(costs, 1.0)
    assert len({row for row, _ in found}) == len({column for _, column in found}) == len(found)
    assert all(costs[row][column] < 1.0 for row, column in found)
    total = sum(costs[row][column] for row, column in found) + len(costs) - len(found)
    assert total == pytest.approx(cheapest(costs))


def test_the_pair_that_is_best_by_itself_is_not_always_taken() -> None:
    assert pairs([[0.1, 0.2], [0.2, 0.9]], 1.0) == [(0, 1), (1, 0)]
    assert pairs([], 1.0) == pairs([[]], 1.0) == []
    assert pairs([[1.5, 2.0]], 1.0) == []
