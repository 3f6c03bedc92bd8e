"""A table of shapes of the library (`stdlib/shapes/NAME.csv`, one row a shape) to its rows, and to the sums in them."""

from __future__ import annotations

import csv
from functools import cache

from facescript.resources import folder


@cache
def rows(name: str) -> tuple[dict[str, str], ...]:
    """The rows of a table of the library, by column."""
    with (folder("stdlib") / "shapes" / f"{name}.csv").open(encoding="utf-8", newline="") as file:
        return tuple(csv.DictReader(file))


def terms(text: str) -> dict[str, float]:
    """`lip.upper.left 1 + lips.parted 0.6` as factors by name; nothing for what no channel makes."""
    pairs = (term.rsplit(None, 1) for term in text.split(" + ") if term)
    return {name: float(factor) for name, factor in pairs}
