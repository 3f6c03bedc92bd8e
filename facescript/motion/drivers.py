"""Gives every driver of a mix its row, and turns a mix into the columns that the motion passes add up."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from facescript.ir.values import Amount, Mix, Term
from facescript.performance.channels import CHANNELS, SIDES

Floats = NDArray[np.float64]
Drive = NDArray[np.float64]
"""What one source asks of a face: array[row, time], 0 where it asks nothing.

Rows are the channels in their order, counted from their rest (`gaze.*` is how far the line of sight is moved), then
`blink.left` and `blink.right` (0 open, 1 shut).
"""

BLINKS = tuple(f"blink.{side}" for side in SIDES)
_DRIVEN = (*(channel.name for channel in CHANNELS), *BLINKS)
ROWS: dict[str, int] = {name: row for row, name in enumerate(_DRIVEN)}


def rows(names: Iterable[str]) -> NDArray[np.intp]:
    """The rows of drivers."""
    return np.array([ROWS[name] for name in names], dtype=np.intp)


def number(amount: Amount) -> float:
    """A quantity of a score: its draws are drawn."""
    assert isinstance(amount, (int, float)), "a score holds plain numbers"
    return float(amount)


def term_column(term: Term) -> Floats:
    """What a term asks at its apex: array[row], its degree times its drivers."""
    column = np.zeros(len(ROWS))
    for driver in term.drivers:
        column[ROWS[driver.name]] += number(term.degree) * number(driver.value)
    return column


def mix_column(mix: Mix) -> Floats:
    """What a whole sum asks: array[row]."""
    return sum((term_column(term) for term in mix.terms), np.zeros(len(ROWS)))
