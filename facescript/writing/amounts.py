"""Amounts in base units to quantities as an author writes them: `300ms`, `40% to 60%`, `-12cm`."""

from __future__ import annotations

from fractions import Fraction

from facescript.ir.values import Amount, Draw
from facescript.resolve.units import COUNT, TIME, UNITS, USUAL_UNIT

LONGEST = 15
"""Characters of a number that is written plainly."""

DENOMINATOR = 10**9
"""The largest divisor that is tried for a number that no decimals say exactly."""

TINY = 10**12
"""What the rest is divided by, of a number that no quotient says exactly either."""


def amount(value: Amount, kind: str) -> str:
    """`value` of a `kind` as `resolve/units.py` has them, read again as the very same number."""
    if isinstance(value, Draw):
        return f"{one(value.low, kind)} to {one(value.high, kind)}"
    return one(value, kind)


def one(value: float, kind: str) -> str:
    """A plain amount: the shortest decimals that are read as `value`, or else a quotient in brackets."""
    unit = "ms" if kind == TIME and 0.0 < abs(value) < 1.0 else USUAL_UNIT[kind]
    return _decimal(value, unit) or _decimal(value, USUAL_UNIT[kind]) or _quotient(value, USUAL_UNIT[kind])


def number(value: float) -> str:
    """A bare number, as the rows of a kind have them."""
    return _decimal(value, "") or _near(value, "")


def _scale(unit: str) -> tuple[float, float]:
    found = UNITS.get(unit)
    return (found.times, found.over) if found else (1.0, 1.0)


def _decimal(value: float, unit: str) -> str:
    """The shortest decimals that are exactly `value` in a unit; nothing where there are none."""
    times, over = _scale(unit)
    for digits in range(LONGEST):
        text = _plain(value * over / times, digits)
        if len(text) <= LONGEST and float(text) * times / over == value:
            return text + unit
    return ""


def _plain(value: float, digits: int) -> str:
    text = f"{value:.{digits}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text


def _quotient(value: float, unit: str) -> str:
    """`(1s / 3)`: two whole numbers whose quotient is exactly `value`, else decimals and a tiny rest."""
    times, over = _scale(unit)
    exact = Fraction(value) * Fraction(over) / Fraction(times)
    limit = 2
    while limit <= DENOMINATOR:
        ratio = exact.limit_denominator(limit)
        top, bottom = ratio.numerator, ratio.denominator
        if abs(top) < 10**LONGEST and top * times / over * (1.0 / bottom) == value:
            return f"({top}{unit} / {bottom})"
        limit *= 2
    return _rested(value, unit)


def _rested(value: float, unit: str) -> str:
    """`(0.8s - 0.000111s / 1000000000000)`, where that is exactly `value`."""
    near = _near(value, unit)
    times, over = _scale(unit)
    base = float(near.removesuffix(unit)) * times / over
    rest = _near(abs(value - base) * TINY, unit)
    sign = "-" if value < base else "+"
    return near if value == base else f"({near} {sign} {rest} / {TINY})"


def _near(value: float, unit: str) -> str:
    """Decimals as near as a script can say them."""
    times, over = _scale(unit)
    shown = value * over / times
    whole = len(str(int(abs(shown)))) + 2
    return _plain(shown, max(0, LONGEST - whole)) + unit


def count(value: int) -> str:
    return f"{value}{USUAL_UNIT[COUNT]}"
