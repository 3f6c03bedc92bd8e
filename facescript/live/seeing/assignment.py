"""Costs of pairs to the pairs that cost least together: which face of a picture is which person."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

Costs = Sequence[Sequence[float]]


def pairs(costs: Costs, most: float) -> list[tuple[int, int]]:
    """The pairs (row, column) of the cheapest matching: each row and column in one at most, none of `most` or more.

    A row that stays alone costs `most`, so that as many are paired as can be.
    """
    rows, columns = len(costs), len(costs[0]) if costs else 0
    padded = [[*(min(cost, most) for cost in row), *[most] * rows] for row in costs]
    return [pair for pair in _matched(padded) if pair[1] < columns and costs[pair[0]][pair[1]] < most]


def _matched(costs: Costs) -> list[tuple[int, int]]:
    """Every row with a column of its own, at the least cost; there are no fewer columns than rows. Shortest augmenting
    paths (Kuhn 1955, Jonker and Volgenant 1987): n^3 steps."""
    if not costs:
        return []
    wide = len(costs[0])
    rows_price, columns_price = [0.0] * len(costs), [0.0] * (wide + 1)
    taken: list[int | None] = [None] * (wide + 1)
    for row in range(len(costs)):
        taken[wide] = row  # a column beside the others, where the row waits for one of them
        column, before = _way(costs, taken, rows_price, columns_price)
        while column != wide:
            taken[column] = taken[before[column]]
            column = before[column]
    return sorted((row, column) for column, row in enumerate(taken[:wide]) if row is not None)


def _way(
    costs: Costs, taken: list[int | None], rows_price: list[float], columns_price: list[float]
) -> tuple[int, list[int]]:
    """The free column that is reached most cheaply by moving rows, and from which column each is reached."""
    wide = len(taken) - 1
    least, before = [inf] * wide, [wide] * wide
    column, seen = wide, [wide]
    while (row := taken[column]) is not None:
        open_ = [other for other in range(wide) if other not in seen]
        for other in open_:
            cost = costs[row][other] - rows_price[row] - columns_price[other]
            if cost < least[other]:
                least[other], before[other] = cost, column
        column = min(open_, key=lambda other: least[other])
        step = least[column]
        for other in seen:
            holder = taken[other]
            assert holder is not None
            rows_price[holder] += step
            columns_price[other] -= step
        for other in open_:
            least[other] -= step
        seen.append(column)
    return column, before
