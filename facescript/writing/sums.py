"""Mixes to sums: `smile 40% + AU4 10%`; an expression that is not the library's gets a definition of its own."""

from __future__ import annotations

from collections.abc import Iterable

from facescript.ir.values import Amount, Draw, Driver, Mix, Term
from facescript.performance.channels import SIDES
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.units import SHARE
from facescript.writing.amounts import amount, one
from facescript.writing.context import Context

Shape = tuple[tuple[str, float], ...]
"""What a term drives: values by name, in order, without those that do nothing."""


def shape(drivers: Iterable[Driver]) -> Shape:
    pairs = ((driver.name, driver.value) for driver in drivers)
    return tuple((name, value) for name, value in pairs if not isinstance(value, Draw) and value != 0.0)


def sided(name: str) -> tuple[str, str]:
    """An expression's name, and the side it takes."""
    base, _, side = name.rpartition(".")
    return (base, side) if side in SIDES and base else (name, "")


class Sums:
    """The expressions of a play: those that differ from the library's by name, each with all its shapes."""

    def __init__(self, context: Context) -> None:
        self.context = context
        self.shapes: dict[str, dict[str, list[Shape]]] = {}

    def note(self, mix: Mix) -> None:
        """Sees the terms of a mix, before anything is written."""
        for term in mix.terms:
            base, side = sided(term.name)
            found = shape(term.drivers)
            library = self.context.library_drivers(base, side)
            if term.name in PRIMITIVES or (library is not None and dict(shape(library)) == dict(found)):
                continue
            shapes = self.shapes.setdefault(base, {}).setdefault(side, [])
            if dict(found) not in map(dict, shapes):
                shapes.append(found)

    # -------------------------------------------------------------------------------------------- definitions

    def define(self) -> list[str]:
        """The lines that define what is not the library's."""
        self.context.taken |= self.shapes.keys()
        return [self._defined(name) for name in self.shapes]

    def _whole(self, name: str) -> Shape:
        """The shape that a name has where nothing is given: its first, or what its sides have together."""
        shapes = self.shapes[name]
        if shapes.get(""):
            return shapes[""][0]
        return tuple({pair: None for found in shapes.values() for pair in found[0]})

    def _open(self, name: str) -> list[str]:
        """The channels that are not the same in all shapes of a name: its parameters."""
        whole = [dict(each) for each in self.shapes[name].get("", ())]
        channels = dict.fromkeys(channel for each in whole for channel in each)
        return [channel for channel in channels if len({each.get(channel, 0.0) for each in whole}) > 1]

    def _defined(self, name: str) -> str:
        usual, given = dict(self._whole(name)), self._open(name)
        parameters = ", ".join(
            f"{_parameter(channel)} = {one(usual.get(channel, 0.0), _kind(channel))}" for channel in given
        )
        fixed = driven((channel, value) for channel, value in usual.items() if channel not in given)
        terms = [*fixed, *(f"{channel} {_parameter(channel)}" for channel in given)]
        return f"expression {name}{f'({parameters})' if parameters else ''} = {' + '.join(terms) or 'neutral'}"

    # -------------------------------------------------------------------------------------------- sums

    def sum(self, mix: Mix) -> str:
        """A mix as it is written; nothing is `neutral`."""
        text = ""
        for term in mix.terms:
            minus = bool(text) and _below(term.degree)
            sign = " - " if minus else " + " if text else ""
            text += sign + self._term(_turned(term) if minus else term)
        return text or "neutral"

    def _term(self, term: Term) -> str:
        primitive = PRIMITIVES.get(term.name)
        if primitive is not None and primitive.kind != SHARE:
            return _channel(term, primitive.kind)
        return f"{self._name(term)}{_degree(term.degree)}"

    def _name(self, term: Term) -> str:
        """The name, with what it is given where it has several shapes."""
        if term.name not in self.shapes or term.name in PRIMITIVES:
            return term.name
        usual, own = dict(self._whole(term.name)), dict(shape(term.drivers))
        given = [
            f"{_parameter(channel)} = {one(own.get(channel, 0.0), _kind(channel))}"
            for channel in self._open(term.name)
            if own.get(channel, 0.0) != usual.get(channel, 0.0)
        ]
        return f"{term.name}({', '.join(given)})" if given else term.name


def _kind(channel: str) -> str:
    """What the values of a channel measure; of one that there is not, which is then refused by its name, a share."""
    primitive = PRIMITIVES.get(channel)
    return primitive.kind if primitive is not None else SHARE


def _parameter(channel: str) -> str:
    return "of-" + channel.replace(".", "-")


def _below(degree: Amount) -> bool:
    return (degree.high if isinstance(degree, Draw) else degree) < 0.0


def _turned(term: Term) -> Term:
    degree = term.degree
    turned: Amount = Draw(-degree.high, -degree.low) if isinstance(degree, Draw) else -degree
    return Term(term.name, turned, term.drivers)


def _channel(term: Term, kind: str) -> str:
    """A channel of angles or lengths: its amount stands in the drivers, but a draw stands in the degree."""
    if isinstance(term.degree, Draw):
        return f"{term.name} {amount(term.degree, kind)}"
    value = term.drivers[0].value if term.drivers else 0.0
    text = f"{term.name} {amount(value, kind)}"
    return text if term.degree == 1.0 else f"({text}){_degree(term.degree)}"


def _degree(degree: Amount) -> str:
    return "" if degree == 1.0 else f" {amount(degree, SHARE)}"


def driven(pairs: Iterable[tuple[str, float]]) -> list[str]:
    """Channels with their values as the terms of a sum; a left side and a right one that are alike are one term."""
    rest = list(pairs)
    terms = []
    while rest:
        channel, value = rest.pop(0)
        name = channel
        if ".left" in channel and rest and rest[0] == (channel.replace(".left", ".right"), value):
            del rest[0]
            name = channel.replace(".left", "")
        text = amount(value, _kind(channel))
        terms.append(name if text == "100%" else f"{name} {text}")
    return terms
