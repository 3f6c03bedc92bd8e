"""Arithmetic over the words of a phrase: quantities in base units, draws, moments on the clock."""

from __future__ import annotations

import math

from facescript.diagnostics.model import Fix
from facescript.ir.values import Amount, Draw, Moment
from facescript.resolve.arithmetic import MOMENT, Value, added, checked, drawn, multiplied
from facescript.resolve.marks import mark_of
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader, over, spelled
from facescript.resolve.scope import Scope, expand, inside
from facescript.resolve.suggest import replace
from facescript.resolve.units import (
    COUNT,
    MENDS,
    TIME,
    UNITS,
    article,
)
from facescript.syntax.tree import Bracket, Dotted, Integer, Name, Quantity, Word
from facescript.text import Span


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
    return checked(project, value, kind, least, draws)


def moment(project: Project, words: tuple[Word, ...], scope: Scope, span: Span) -> Moment:
    """The moment that a whole phrase states: from the block's start, or from a mark. Raises `Refused`."""
    reader = Reader(words, scope, span)
    value = ranged(project, reader)
    left_over(project, reader)
    least = 0.0 if value.mark is None else None
    return Moment(checked(project, value, MOMENT, least, draws=True), value.mark)


def left_over(project: Project, reader: Reader) -> None:
    """Refuses words that stand behind a finished value."""
    if reader.peek() is not None:
        text = over(reader.rest()).text
        raise project.refuse("FS312", over(reader.rest()), text=text, advice="nothing more can stand here")


# ------------------------------------------------------------------------------------------------ the arithmetic


def ranged(project: Project, reader: Reader) -> Value:
    value = _total(project, reader)
    return drawn(project, value, _total(project, reader)) if reader.word("to") else value


def read_degree(project: Project, reader: Reader, kind: str) -> Amount:
    """Reads the amount behind a name of a sum (`smile warmth * 2 + ...`): products, but no sum outside brackets."""
    value = _product(project, reader)
    if reader.word("to"):
        value = drawn(project, value, _product(project, reader))
    return checked(project, value, kind, None, draws=True)


def _total(project: Project, reader: Reader) -> Value:
    value = _product(project, reader)
    while sign := reader.operator("+", "-"):
        value = added(project, value, _product(project, reader), sign)
    return value


def _product(project: Project, reader: Reader) -> Value:
    value = primary(project, reader)
    while sign := reader.operator("*", "/"):
        value = multiplied(project, value, primary(project, reader), sign)
    return value


def primary(project: Project, reader: Reader) -> Value:
    word = reader.next()
    if isinstance(word, Quantity):
        return _quantity(project, word)
    if isinstance(word, Integer):
        return Value(_finite(project, float(word.value), word.span), COUNT, word.span)
    if isinstance(word, Bracket):
        inner = Reader(word.inner.words, reader.scope, word.span)
        with project.deeper(word.span):
            value = ranged(project, inner)
        left_over(project, inner)
        return Value(value.amount, value.kind, word.span, value.mark, value.cell)
    if isinstance(word, Name | Dotted):
        return _named(project, word, reader.scope)
    span = word.span if word is not None else reader.span
    raise project.refuse("FS312", span, text=span.text, advice="a quantity such as `2s` or `40%` belongs here")


def _quantity(project: Project, word: Quantity) -> Value:
    unit = UNITS.get(word.unit)
    if not word.unit:
        if project.is_told(word.span):
            raise Refused
        return Value(word.value, COUNT, word.span)
    if unit is None:
        raise _unknown_unit(project, word)
    amount = word.value * unit.times / unit.over
    return Value(_finite(project, amount, word.span), unit.kind, word.span)


def _unknown_unit(project: Project, word: Quantity) -> Refused:
    """Refuses a unit, with the quantity in a known one where that can be said."""
    known = ", ".join(f"`{name}`" for name in UNITS)
    fixes: tuple[Fix, ...] = ()
    if word.unit in MENDS:
        unit, times = MENDS[word.unit]
        fixes = (replace(word.span, f"{word.value * times:.10g}{unit}"),)
    return project.refuse("FS303", word.span, fixes=fixes, unit=word.unit, text=word.span.text, known=known)


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
        return Value(value.amount, value.kind, word.span, value.mark, expansion.cell or value.cell)
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
