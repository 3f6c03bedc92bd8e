"""Arithmetic over the words of a phrase: quantities in base units, draws, moments on the clock."""

from __future__ import annotations

import math
from dataclasses import dataclass

from facescript.ir.values import Amount, Draw, Mark, Moment
from facescript.resolve.marks import mark_of
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader, over, spelled
from facescript.resolve.scope import Scope, expand, inside
from facescript.resolve.suggest import replace
from facescript.resolve.units import (
    COUNT,
    EXAMPLES,
    LARGEST,
    SHARE,
    TIME,
    UNITS,
    USUAL_UNIT,
    article,
    written,
)
from facescript.syntax.tree import Bracket, Dotted, Integer, Name, Quantity, Word
from facescript.text import Span


@dataclass(frozen=True, slots=True)
class Value:
    """A quantity: an amount in base units, what it measures, and the mark it counts from if it is a moment."""

    amount: Amount
    kind: str
    span: Span
    mark: Mark | None = None


def quantity(
    project: Project,
    words: tuple[Word, ...],
    scope: Scope,
    kind: str,
    span: Span,
    *,
    least: float | None = 0.0,
    draws: bool = True,
) -> Amount:
    """The amount that a whole phrase states, which must be of `kind` and not below `least`. Raises `Refused`."""
    reader = Reader(words, scope, span)
    amount = read_quantity(project, reader, kind, least=least, draws=draws)
    left_over(project, reader)
    return amount


def number(
    project: Project, words: tuple[Word, ...], scope: Scope, kind: str, span: Span, *, least: float | None = 0.0
) -> float:
    """As `quantity`, where the seed cannot draw: definitions and settings."""
    amount = quantity(project, words, scope, kind, span, least=least, draws=False)
    assert not isinstance(amount, Draw)
    return amount


def read_quantity(
    project: Project, reader: Reader, kind: str, *, least: float | None = 0.0, draws: bool = True
) -> Amount:
    """Reads an amount of `kind` (`20% to 40%` is a draw); leaves the words behind it. Raises `Refused`."""
    value = ranged(project, reader)
    if value.mark is not None:
        raise project.refuse("FS328", value.span, text=value.span.text, example=EXAMPLES[kind])
    return checked(project, value, kind, least, draws)


def checked(project: Project, value: Value, kind: str, least: float | None, draws: bool) -> Amount:
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


def moment(project: Project, words: tuple[Word, ...], scope: Scope, span: Span) -> Moment:
    """The moment that a whole phrase states: from the block's start, or from a mark. Raises `Refused`."""
    reader = Reader(words, scope, span)
    value = ranged(project, reader)
    left_over(project, reader)
    least = 0.0 if value.mark is None else None
    return Moment(checked(project, value, TIME, least, draws=True), value.mark)


def left_over(project: Project, reader: Reader) -> None:
    """Refuses words that stand behind a finished value."""
    if reader.peek() is not None:
        text = over(reader.rest()).text
        raise project.refuse("FS312", over(reader.rest()), text=text, advice="nothing more can stand here")


def bounds(amount: Amount) -> tuple[float, float]:
    return (amount.low, amount.high) if isinstance(amount, Draw) else (amount, amount)


def scaled(amount: Amount, factor: float) -> Amount:
    if isinstance(amount, Draw):
        low, high = sorted((amount.low * factor, amount.high * factor))
        return Draw(low, high)
    return amount * factor


# ------------------------------------------------------------------------------------------------ the arithmetic


def ranged(project: Project, reader: Reader) -> Value:
    value = _total(project, reader)
    return _drawn(project, reader, value, _total(project, reader)) if reader.word("to") else value


def read_degree(project: Project, reader: Reader, kind: str) -> Amount:
    """Reads the amount behind a name of a sum (`smile warmth * 2 + ...`): products, but no sum outside brackets."""
    value = _product(project, reader)
    if reader.word("to"):
        value = _drawn(project, reader, value, _product(project, reader))
    if value.mark is not None:
        raise project.refuse("FS328", value.span, text=value.span.text, example=EXAMPLES[kind])
    return checked(project, value, kind, None, draws=True)


def _drawn(project: Project, reader: Reader, low: Value, high: Value) -> Value:
    span = low.span.to(high.span)
    if low.kind != high.kind:
        raise _mismatch(project, "to", low, high, span)
    if isinstance(low.amount, Draw) or isinstance(high.amount, Draw) or low.mark or high.mark:
        raise project.refuse("FS306", span, text=span.text, reason="`to` stands between two plain quantities")
    if low.amount > high.amount:
        raise project.refuse("FS306", span, text=span.text, reason="the smaller amount stands first")
    return Value(Draw(low.amount, high.amount), low.kind, span)


def _total(project: Project, reader: Reader) -> Value:
    value = _product(project, reader)
    while sign := reader.operator("+", "-"):
        value = _added(project, value, _product(project, reader), sign)
    return value


def _product(project: Project, reader: Reader) -> Value:
    value = primary(project, reader)
    while sign := reader.operator("*", "/"):
        value = _multiplied(project, value, primary(project, reader), sign)
    return value


def _added(project: Project, first: Value, second: Value, sign: str) -> Value:
    span = _joined(first, second)
    if first.kind != second.kind:
        raise _mismatch(project, sign, first, second, span)
    if second.mark and (first.mark or sign == "-"):
        reason = "a moment takes one mark, and times added to it or taken from it"
        raise project.refuse("FS306", span, text=span.text, reason=reason)
    if isinstance(first.amount, Draw) and isinstance(second.amount, Draw):
        raise project.refuse("FS306", span, text=span.text, reason="two draws cannot be added")
    factor = 1.0 if sign == "+" else -1.0
    amount = _sum(first.amount, scaled(second.amount, factor))
    return Value(amount, first.kind, span, first.mark or second.mark)


def _sum(first: Amount, second: Amount) -> Amount:
    if isinstance(first, Draw) or isinstance(second, Draw):
        low, high = bounds(first)
        other_low, other_high = bounds(second)
        return Draw(low + other_low, high + other_high)
    return first + second


def _multiplied(project: Project, first: Value, second: Value, sign: str) -> Value:
    span = _joined(first, second)
    if first.mark or second.mark:
        raise project.refuse("FS306", span, text=span.text, reason="a moment cannot be multiplied")
    if sign == "/":
        return _divided(project, first, second, span)
    if first.kind in (COUNT, SHARE) and (second.kind not in (COUNT, SHARE) or isinstance(second.amount, Draw)):
        first, second = second, first
    if second.kind not in (COUNT, SHARE):
        reason = f"{article(first.kind)} cannot be multiplied by {article(second.kind)}"
        raise project.refuse("FS306", span, text=span.text, reason=reason)
    if isinstance(second.amount, Draw):
        reason = "a draw cannot be a factor; draw between two products"
        raise project.refuse("FS306", span, text=span.text, reason=reason)
    kind = second.kind if first.kind == COUNT else first.kind
    return Value(scaled(first.amount, second.amount), kind, span)


def _divided(project: Project, first: Value, second: Value, span: Span) -> Value:
    if isinstance(second.amount, Draw):
        raise project.refuse("FS306", span, text=span.text, reason="a draw cannot divide")
    if second.amount == 0.0:
        raise project.refuse("FS306", span, text=span.text, reason="it divides by zero")
    if second.kind not in (COUNT, SHARE, first.kind):
        reason = f"{article(first.kind)} cannot be divided by {article(second.kind)}"
        raise project.refuse("FS306", span, text=span.text, reason=reason)
    kind = COUNT if second.kind == first.kind else first.kind
    return Value(scaled(first.amount, 1.0 / second.amount), kind, span)


def primary(project: Project, reader: Reader) -> Value:
    word = reader.next()
    if isinstance(word, Quantity):
        return _quantity(project, word)
    if isinstance(word, Integer):
        return Value(_finite(project, float(word.value), word.span), COUNT, word.span)
    if isinstance(word, Bracket):
        inner = Reader(word.inner.words, reader.scope, word.span)
        value = ranged(project, inner)
        left_over(project, inner)
        return Value(value.amount, value.kind, word.span, value.mark)
    if isinstance(word, Name | Dotted):
        return _named(project, word, reader.scope)
    span = word.span if word is not None else reader.span
    raise project.refuse("FS312", span, text=span.text, advice="a quantity such as `2s` or `40%` belongs here")


def _quantity(project: Project, word: Quantity) -> Value:
    unit = UNITS.get(word.unit)
    if unit is None:
        known = ", ".join(f"`{name}`" for name in UNITS)
        raise project.refuse("FS303", word.span, unit=word.unit, text=word.span.text, known=known)
    amount = word.value * unit.times / unit.over
    return Value(_finite(project, amount, word.span), unit.kind, word.span)


def _finite(project: Project, amount: float, span: Span) -> float:
    if not math.isfinite(amount):
        raise project.refuse("FS304", span, text=span.text, limits="numbers that can be reckoned with")
    return amount


def _named(project: Project, word: Name | Dotted, scope: Scope) -> Value:
    expansion = expand(project, word, scope)
    if expansion is not None:
        with inside(project, expansion, word.span):
            inner = Reader(expansion.words, expansion.scope, word.span)
            value = ranged(project, inner)
            left_over(project, inner)
        return Value(value.amount, value.kind, word.span, value.mark)
    mark = mark_of(project, word, scope)
    if mark is not None:
        return Value(0.0, TIME, word.span, mark)
    definition = project.names.find(spelled(word))
    if definition is not None:
        wanted = "a quantity such as `2s` or `40%`"
        raise project.refuse("FS214", word.span, name=definition.name, kind=article(definition.kind), wanted=wanted)
    labels = scope.labels.seen() if scope.labels else []
    first = str(word.parts[0]) if isinstance(word, Dotted) else word.text
    if isinstance(word, Dotted):
        raise project.unknown("FS205", first, labels, word.span)
    raise project.unknown("FS207", first, [*scope.bindings, *project.names.known("let"), *labels], word.span)


def _joined(first: Value, second: Value) -> Span:
    if first.span.source is second.span.source and first.span.start <= second.span.end:
        return first.span.to(second.span)
    return second.span


def _mismatch(project: Project, sign: str, first: Value, second: Value, span: Span) -> Refused:
    reason = f"`{sign}` stands between {article(first.kind)} and {article(second.kind)}"
    return project.refuse("FS306", span, text=span.text, reason=reason)


def _wrong_unit(project: Project, value: Value, kind: str) -> Refused:
    text = value.span.text
    low, high = bounds(value.amount)
    unit = USUAL_UNIT[kind]
    if value.kind == COUNT and low == high and unit:
        shown = f"{low:.10g}{unit}"
        fixes = (replace(value.span, shown),) if text.isdigit() else ()
        return project.refuse("FS301", value.span, fixes=fixes, text=text, wanted=article(kind), example=shown)
    called = article(value.kind)
    mend = f"for example `{EXAMPLES[kind]}`"
    fixes = ()
    if kind == TIME and text.endswith("m") and text[:-1].replace(".", "").isdigit():
        minutes = f"{float(text[:-1]) * 60:.10g}s"
        called, mend, fixes = "metres", f"`{minutes}`?", (replace(value.span, minutes),)
    return project.refuse("FS302", value.span, fixes=fixes, text=text, kind=called, wanted=article(kind), mend=mend)
