"""The curves of changes as plain arithmetic: the share of the time (0..1) to the share done, numbers and arrays alike.

It needs no numpy, so that the schedule can say how far a change came. Outside of 0..1 they mean nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

Polynomial = Callable[[Any], Any]
"""A share of time, as a number or an array, to the share done in the same form."""


def linear(x: Any) -> Any:
    return x


def minimum_jerk(x: Any) -> Any:
    return x * x * x * (10.0 + x * (-15.0 + x * 6.0))


def beta_3_5(x: Any) -> Any:
    return x * x * x * (35.0 + x * (-105.0 + x * (126.0 + x * (-70.0 + x * 15.0))))


def beta_5_3(x: Any) -> Any:
    return 1.0 - beta_3_5(1.0 - x)


def beta_5_5(x: Any) -> Any:
    return x * x * x * x * x * (126.0 + x * (-420.0 + x * (540.0 + x * (-315.0 + x * 70.0))))


POLYNOMIALS: dict[str, Polynomial] = {
    "linear": linear,
    "smooth": minimum_jerk,
    "in": beta_5_3,
    "out": beta_3_5,
    "in-out": beta_5_5,
}
"""By the names an author writes after `ease`."""
