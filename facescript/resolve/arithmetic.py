"""Arithmetic of quantities that remember their kind: sums, products, draws, and whether an amount fits its place."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.diagnostics.model import Fix
from facescript.ir.values import Amount, Draw, Mark
from facescript.resolve.project import Cell, Project, Refused
from facescript.resolve.suggest import replace
from facescript.resolve.units import COUNT, EXAMPLES, LARGEST, SHARE, TIME, USUAL_UNIT, article, written
from facescript.text import Span

MOMENT = "moment"
"""The kind of place that takes a time or a time from a mark."""


@dataclass(frozen=True, slots=True)
class Value:
    """A quantity: an amount in base units, what it measures, the mark it counts from if it is a moment, and the cell of
    a table that it came from, if any."""

    amount: Amount
    kind: str
    span: Span
    mark: Mark | None = None
    cell: Cell | None = None


def checked(project: Project, value: Value, kind: str, least: float | None, draws: bool) -> Amount:
    """The amount of a value that must be of `kind`, within bounds, and drawn only where it may be. Raises `Refused`."""
    with project.blaming(value.cell):
        if value.mark is not None and kind != MOMENT:
            raise project.refuse("FS328", value.span, text=value.span.text, example=EXAMPLES[kind])
        kind = TIME if kind == MOMENT else kind
        if value.kind != kind:
            raise _wrong_unit(project, value, kind)
        if isinstance(value.amount, Draw) and not draws:
            raise project.refuse("FS307", value.span, text=value.span.text)
        low, high = bounds(value.amount)
        bottom = -LARGEST[kind] if least is None else least
        if low < bottom or high > LARGEST[kind]:
            limits = f"{written(kind, bottom)} to {written(kind, LARGEST[kind])}"
            raise project.refuse("FS304", value.span, text=value.span.text, limits=limits)
        return value.amount


def bounds(amount: Amount) -> tuple[float, float]:
    return (amount.low, amount.high) if isinstance(amount, Draw) else (amount, amount)


def scaled(amount: Amount, factor: float) -> Amount:
    if isinstance(amount, Draw):
        low, high = sorted((amount.low * factor, amount.high * factor))
        return Draw(low, high)
    return amount * factor


def drawn(project: Project, first: Value, second: Value) -> Value:
    """`first to second`. Raises `Refused`."""
    span = _joined(first, second)
    if first.kind != second.kind:
        raise _mismatch(project, "to", first, second, span)
    if isinstance(first.amount, Draw) or isinstance(second.amount, Draw) or first.mark or second.mark:
        raise _fault(project, span, "`to` stands between two plain quantities", first, second)
    if first.amount > second.amount:
        raise _fault(project, span, "the smaller amount stands first", first, second)
    return Value(Draw(first.amount, second.amount), first.kind, span, cell=first.cell or second.cell)


def added(project: Project, first: Value, second: Value, sign: str) -> Value:
    span = _joined(first, second)
    if first.kind != second.kind:
        raise _mismatch(project, sign, first, second, span)
    if second.mark and (first.mark or sign == "-"):
        reason = "a moment takes one mark, and times added to it or taken from it"
        raise _fault(project, span, reason, first, second)
    if isinstance(first.amount, Draw) and isinstance(second.amount, Draw):
        raise _fault(project, span, "two draws cannot be added", first, second)
    factor = 1.0 if sign == "+" else -1.0
    amount = _sum(first.amount, scaled(second.amount, factor))
    return Value(amount, first.kind, span, first.mark or second.mark, first.cell or second.cell)


def _sum(first: Amount, second: Amount) -> Amount:
    if isinstance(first, Draw) or isinstance(second, Draw):
        low, high = bounds(first)
        other_low, other_high = bounds(second)
        return Draw(low + other_low, high + other_high)
    return first + second


def multiplied(project: Project, first: Value, second: Value, sign: str) -> Value:
    span = _joined(first, second)
    if first.mark or second.mark:
        raise _fault(project, span, "a moment cannot be multiplied", first, second)
    if sign == "/":
        return _divided(project, first, second, span)
    if first.kind in (COUNT, SHARE) and (second.kind not in (COUNT, SHARE) or isinstance(second.amount, Draw)):
        first, second = second, first
    if second.kind not in (COUNT, SHARE):
        reason = f"{article(first.kind)} cannot be multiplied by {article(second.kind)}"
        raise _fault(project, span, reason, first, second)
    if isinstance(second.amount, Draw):
        reason = "a draw cannot be a factor; draw between two products"
        raise _fault(project, span, reason, first, second)
    kind = second.kind if first.kind == COUNT else first.kind
    return Value(scaled(first.amount, second.amount), kind, span, cell=first.cell or second.cell)


def _divided(project: Project, first: Value, second: Value, span: Span) -> Value:
    if isinstance(second.amount, Draw):
        raise _fault(project, span, "a draw cannot divide", first, second)
    if second.amount == 0.0:
        raise _fault(project, span, "it divides by zero", first, second)
    if second.kind not in (COUNT, SHARE, first.kind):
        reason = f"{article(first.kind)} cannot be divided by {article(second.kind)}"
        raise _fault(project, span, reason, first, second)
    kind = COUNT if second.kind == first.kind else first.kind
    return Value(scaled(first.amount, 1.0 / second.amount), kind, span, cell=first.cell or second.cell)


def _joined(first: Value, second: Value) -> Span:
    if first.span.source is second.span.source and first.span.start <= second.span.end:
        return first.span.to(second.span)
    return second.span


def _mismatch(project: Project, sign: str, first: Value, second: Value, span: Span) -> Refused:
    reason = f"`{sign}` stands between {article(first.kind)} and {article(second.kind)}"
    return _fault(project, span, reason, first, second)


def _fault(project: Project, span: Span, reason: str, first: Value, second: Value) -> Refused:
    with project.blaming(first.cell or second.cell):
        return project.refuse("FS306", span, text=span.text, reason=reason)


def _wrong_unit(project: Project, value: Value, kind: str) -> Refused:
    text = value.span.text
    low, high = bounds(value.amount)
    unit = USUAL_UNIT[kind]
    if value.kind == COUNT and low == high and unit:
        part = kind == SHARE and 0.0 < low <= 1.0 and "." in text
        return _bare_number(project, value, kind, f"{100 * low if part else low:.10g}{unit}")
    called = article(value.kind)
    mend = f"for example `{EXAMPLES[kind]}`"
    fixes: tuple[Fix, ...] = ()
    if kind == TIME and text.endswith("m") and text[:-1].replace(".", "").isdigit():
        minutes = f"{float(text[:-1]) * 60:.10g}s"
        called, mend, fixes = "metres", f"`{minutes}`?", (replace(value.span, minutes),)
    return project.refuse("FS302", value.span, fixes=fixes, text=text, kind=called, wanted=article(kind), mend=mend)


def _bare_number(project: Project, value: Value, kind: str, shown: str) -> Refused:
    text = value.span.text
    fixes = (replace(value.span, shown),) if text.replace(".", "", 1).isdigit() else ()
    return project.refuse("FS301", value.span, fixes=fixes, text=text, wanted=article(kind), example=shown)
