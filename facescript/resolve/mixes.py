"""Sums of muscles, FACS units, expressions and channels to mixes; nested expressions flatten to their drivers."""

from __future__ import annotations

from functools import partial

from facescript.ir.values import Amount, Draw, Driver, Mix, Term
from facescript.performance.channels import SIDES
from facescript.resolve.arguments import bind
from facescript.resolve.arithmetic import bounds, scaled
from facescript.resolve.drivers import PRIMITIVES, Primitive, side_of
from facescript.resolve.names import Definition
from facescript.resolve.project import Project
from facescript.resolve.reader import Reader, spelled
from facescript.resolve.scope import GLOBAL, Scope, expand, inside
from facescript.resolve.sums import left_over, read_degree
from facescript.resolve.units import SHARE, article
from facescript.resolve.words import undrawable
from facescript.syntax.tree import (
    Bracket,
    Call,
    Dotted,
    ExpressionDefinition,
    Integer,
    Name,
    Operator,
    Phrase,
    Quantity,
    Word,
)
from facescript.text import Span


def mix(project: Project, words: tuple[Word, ...], scope: Scope, span: Span) -> Mix:
    """The mix that a whole phrase states. Raises `Refused`."""
    reader = Reader(words, scope, span)
    found = read_mix(project, reader)
    left_over(project, reader)
    return found


def read_mix(project: Project, reader: Reader) -> Mix:
    """Reads a sum; leaves the words behind it. Raises `Refused`."""
    terms = _term(project, reader, 1.0)
    while sign := reader.operator("+", "-"):
        terms = terms + _term(project, reader, 1.0 if sign == "+" else -1.0)
    return Mix(terms)


def drivers_of(project: Project, value: Phrase) -> tuple[Driver, ...]:
    """What a whole phrase drives, each channel once. Raises `Refused`."""
    return _flattened(project, mix(project, value.words, GLOBAL, value.span), value.span)


def expression_mix(project: Project, name: str, side: str, degree: Amount, span: Span) -> Mix:
    """One expression of the library or of the author as a mix: what a gesture's far pose is."""
    definition = project.names.find(name)
    if definition is None or not isinstance(definition.node, ExpressionDefinition):
        raise project.refuse("FS201", span, name=name, meant=".")
    drivers = expression_drivers(project, definition, side, span)
    return Mix((Term(f"{name}.{side}" if side else name, degree, drivers),))


def _term(project: Project, reader: Reader, sign: float) -> tuple[Term, ...]:
    word = reader.next()
    if isinstance(word, Bracket):
        with project.deeper(word.span):
            inner = mix(project, word.inner.words, reader.scope, word.span)
        return _weighted(project, reader, inner.terms, sign, word.span)
    if isinstance(word, Call):
        return (_called(project, reader, word, sign),)
    if isinstance(word, Name | Dotted):
        return _named(project, reader, word, sign)
    span = word.span if word is not None else reader.span
    if isinstance(word, Quantity | Integer):
        raise project.refuse(
            "FS312", span, text=span.text, advice="a sum is of names with a degree: `smile 40% + AU4 10%`"
        )
    raise project.refuse(
        "FS312", span, text=span.text, advice="an expression, FACS unit, muscle or channel belongs here"
    )


def _named(project: Project, reader: Reader, word: Name | Dotted, sign: float) -> tuple[Term, ...]:
    name = spelled(word)
    if name == "neutral":
        return ()
    primitive = PRIMITIVES.get(name)
    if primitive is not None:
        return (_primitive(project, reader, name, primitive, sign, word.span),)
    expansion = expand(project, word, reader.scope)
    if expansion is not None:
        with inside(project, expansion, word.span):
            inner = mix(project, expansion.words, expansion.scope, word.span)
        return _weighted(project, reader, inner.terms, sign, word.span)
    definition, side = find_expression(project, word)
    drivers = expression_drivers(project, definition, side, word.span)
    degree = _degree(project, reader, word.span, definition.name)
    return (Term(name, scaled(degree, sign), drivers),)


def _weighted(project: Project, reader: Reader, terms: tuple[Term, ...], sign: float, span: Span) -> tuple[Term, ...]:
    degree = _degree(project, reader, span, span.text)
    if not isinstance(degree, Draw):
        return tuple(Term(term.name, scaled(term.degree, degree * sign), term.drivers) for term in terms)
    if any(isinstance(term.degree, Draw) for term in terms):
        raise project.refuse("FS306", span, text=span.text, reason="two draws cannot be multiplied")
    return tuple(Term(term.name, scaled(degree, sign * bounds(term.degree)[0]), term.drivers) for term in terms)


def _primitive(project: Project, reader: Reader, name: str, primitive: Primitive, sign: float, span: Span) -> Term:
    if primitive.kind == SHARE:
        degree = _degree(project, reader, span, name if primitive.largest else "")
        return Term(name, scaled(degree, sign), tuple(Driver(driver, 1.0) for driver in primitive.names))
    if not _amount_follows(reader):
        raise project.refuse("FS234", span, name=name, kind=article(primitive.kind))
    amount = scaled(read_degree(project, reader, primitive.kind), sign)
    if isinstance(amount, Draw):
        return Term(name, amount, tuple(Driver(driver, 1.0) for driver in primitive.names))
    return Term(name, 1.0, tuple(Driver(driver, amount) for driver in primitive.names))


def _called(project: Project, reader: Reader, word: Call, sign: float) -> Term:
    definition, _ = find_expression(project, word.name)
    assert isinstance(definition.node, ExpressionDefinition)
    project.stand_for(len(definition.node.value.words), word.span)
    given = [(argument.name, argument.value.words, argument.span) for argument in word.arguments]
    scope = bind(project, definition.node.parameters, given, reader.scope, word.span, definition.name)
    with project.entering(definition, word.span):
        drivers = _flattened(project, mix(project, definition.node.value.words, scope, word.span), word.span)
    degree = _degree(project, reader, word.span, definition.name)
    return Term(definition.name, scaled(degree, sign), drivers)


def _degree(project: Project, reader: Reader, span: Span, name: str) -> Amount:
    """The degree behind a name, 100 % where none is written; beyond 100 % of a `name` is told."""
    if not _amount_follows(reader):
        return 1.0
    first = reader.here()
    degree = read_degree(project, reader, SHARE)
    if name and max(abs(edge) for edge in bounds(degree)) > 1.0:
        project.report("FS305", first, name=name, text=first.text)
    return degree


def _amount_follows(reader: Reader) -> bool:
    word = reader.peek()
    return word is not None and not isinstance(word, Operator)


# ------------------------------------------------------------------------------------------------ expressions


def find_expression(project: Project, word: Name | Dotted) -> tuple[Definition, str]:
    """The expression that a name is, and the side it takes of it ("" for both). Raises `Refused`."""
    name, side = _sided(word)
    definition = project.names.find(name)
    if definition is None:
        if undrawable(name):
            raise project.refuse("FS219", word.span, name=name)
        known = [*project.names.known("expression"), *PRIMITIVES, *_other_sides(project, word)]
        raise project.unknown("FS201", spelled(word), known, word.span)
    if definition.kind != "expression":
        wanted = "an expression, FACS unit, muscle or channel"
        raise project.refuse("FS214", word.span, name=name, kind=article(definition.kind), wanted=wanted)
    return definition, side


def _other_sides(project: Project, word: Name | Dotted) -> list[str]:
    """The sides of what a name means but for its last part."""
    base = ".".join(str(part) for part in word.parts[:-1]) if isinstance(word, Dotted) else ""
    definition = project.names.written.get(base) or project.names.library.get(base)
    known = base in PRIMITIVES or (definition is not None and definition.kind == "expression")
    return [f"{base}.{side}" for side in SIDES] if known else []


def is_shown(project: Project, word: Word) -> bool:
    """Whether a word alone could stand in a sum: what a line without `show` begins with."""
    if isinstance(word, Call):
        word = word.name
    if not isinstance(word, Name | Dotted):
        return False
    name, _ = _sided(word)
    definition = project.names.written.get(name) or project.names.library.get(name)
    return spelled(word) in PRIMITIVES or (definition is not None and definition.kind == "expression")


def _sided(word: Name | Dotted) -> tuple[str, str]:
    if isinstance(word, Dotted) and word.parts[-1] in SIDES:
        return ".".join(str(part) for part in word.parts[:-1]), str(word.parts[-1])
    return spelled(word), ""


def expression_drivers(project: Project, definition: Definition, side: str, span: Span) -> tuple[Driver, ...]:
    """What an expression drives at 100 %, of one side where one is named. Raises `Refused`."""
    key, work = ("drivers", definition.name), partial(_whole, project, definition, span)
    drivers = project.memo.once(project, key, definition.node, work)
    if side:
        drivers = tuple(driver for driver in drivers if side_of(driver.name) == side)
        if not drivers:
            raise project.refuse("FS220", span, name=definition.name, side=side)
    return drivers


def _whole(project: Project, definition: Definition, span: Span) -> tuple[Driver, ...]:
    node = definition.node
    assert isinstance(node, ExpressionDefinition)
    scope = bind(project, node.parameters, [], GLOBAL, span, definition.name) if node.parameters else GLOBAL
    with project.entering(definition, span):
        return _flattened(project, mix(project, node.value.words, scope, node.value.span), node.value.span)


def check_expression(project: Project, definition: Definition, scope: Scope) -> None:
    """Reads the definition of an expression, its parameters as `scope` has them. Raises `Refused`."""
    node = definition.node
    assert isinstance(node, ExpressionDefinition)
    with project.entering(definition, definition.span):
        _flattened(project, mix(project, node.value.words, scope, node.value.span), node.value.span)


def _flattened(project: Project, inner: Mix, span: Span) -> tuple[Driver, ...]:
    """The drivers of a mix added up by name. A draw has no place in it: both sides would be drawn apart."""
    total: dict[str, float] = {}
    for term in inner.terms:
        if isinstance(term.degree, Draw):
            raise project.refuse("FS307", span, text=span.text)
        for driver in term.drivers:
            assert not isinstance(driver.value, Draw)
            total[driver.name] = total.get(driver.name, 0.0) + driver.value * term.degree
    return tuple(Driver(name, round(value, 9)) for name, value in total.items())
