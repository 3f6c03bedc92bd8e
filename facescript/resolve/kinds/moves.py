"""The `muscle` and `shade` rows of a kind to what signals move and show."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from facescript.ir.kind import Pull, PullField, Shade, ShadeTerm
from facescript.performance.channels import MUSCLES, SIDES
from facescript.resolve.kinds.row import Row, Words, spelled
from facescript.resolve.kinds.words import OTHER_SIGNALS
from facescript.syntax.tree import Operator, Word
from facescript.text import Span

SIDED = (*MUSCLES, "lid", "ear", "muzzle", "near", "far")
SIGNALS = frozenset({*MUSCLES, *OTHER_SIGNALS, *(f"{name}.{side}" for name in SIDED for side in SIDES)})


def pull(row: Row, amounts: Collection[str]) -> Pull:
    """What one signal moves; `amounts` are the kind's own signals. Raises `Refused`."""
    signal = _signal(row, row.phrases[0].words[1:], row.phrases[0].span, amounts)
    sides = False
    shapes: tuple[str, ...] = ()
    by: tuple[tuple[float, float], ...] = ()
    fields: list[PullField] = []
    for phrase, (word, words) in zip(row.phrases[1:], row.clauses(), strict=True):
        if word in ("both", "each"):
            sides = True
        elif word == "moves" and words:
            shapes = tuple(row.name(each, "shape") for each in words)
        elif word == "by" and words:
            by = tuple(row.pair(each) for each in words)
        elif word == "at":
            fields.append(_field(row, words, phrase.span))
        else:
            raise row.refuse(phrase.span)
    if not shapes or bool(by) == bool(fields):
        raise row.refuse(row.span)
    return Pull(signal, shapes, row.span, sides, by, tuple(fields))


def _field(row: Row, words: Words, span: Span) -> PullField:
    """`at (20 70) by (4.6 -4) within 40`."""
    if len(words) != 5 or (spelled(words[1]), spelled(words[3])) != ("by", "within"):
        raise row.refuse(span)
    within = row.number(words[4])
    if within <= 0.0:
        raise row.refuse(words[4].span)
    return PullField(row.pair(words[0]), row.pair(words[2]), within)


def shade(row: Row, amounts: Collection[str]) -> Shade:
    """How much more of a shape is seen by signals. Raises `Refused`."""
    shape = row.name(row.one(row.phrases[0].words[1:], row.span), "shape")
    sides, most = False, 1.0
    terms: list[ShadeTerm] = []
    for phrase, (word, words) in zip(row.phrases[1:], row.clauses(), strict=True):
        if word in ("both", "each"):
            sides = True
        elif word == "at" and len(words) == 2 and spelled(words[0]) == "most":
            most = row.share(words[1])
        else:
            terms += [_term(row, part, phrase.span, amounts) for part in _parts(phrase.words)]
    if not terms:
        raise row.refuse(row.span)
    return Shade(shape, tuple(terms), row.span, sides, most)


def _parts(words: Words) -> Iterator[Words]:
    """The summands of a sum."""
    part: list[Word] = []
    for word in words:
        if isinstance(word, Operator) and word.text == "+":
            yield tuple(part)
            part = []
        else:
            part.append(word)
    yield tuple(part)


def _term(row: Row, words: Words, span: Span, amounts: Collection[str]) -> ShadeTerm:
    """`cheek.upper 34%`, or `cheek.upper 22% with cheek.lower`."""
    if len(words) == 4 and spelled(words[2]) == "with":
        other = _signal(row, words[3:], span, amounts)
        return ShadeTerm(_signal(row, words[:1], span, amounts), row.number(words[1]), other)
    if len(words) < 2:
        raise row.refuse(span)
    return ShadeTerm(_signal(row, words[:-1], span, amounts), row.number(words[-1]))


def _signal(row: Row, words: Words, span: Span, amounts: Collection[str]) -> str:
    """A muscle or another signal; `ear up` and `ear down` are two of their own."""
    if len(words) == 2 and spelled(words[0]) == "ear" and spelled(words[1]) in ("up", "down"):
        return f"ear {spelled(words[1])}"
    return row.name(row.one(words, span), "muscle or signal", SIGNALS.union(amounts))
