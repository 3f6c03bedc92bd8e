"""Presets of life and their knobs: `calm, blink 8/min`."""

from __future__ import annotations

from facescript.ir.acts import Life
from facescript.ir.values import Amount
from facescript.resolve.lines import Line
from facescript.resolve.names import Definition
from facescript.resolve.project import Project
from facescript.resolve.scope import GLOBAL, expand, inside
from facescript.resolve.units import RATE, SHARE, article
from facescript.resolve.words import KNOBS, MODIFIERS
from facescript.syntax.tree import Declaration, Name, Phrase, Word
from facescript.text import Span

KINDS = {name: RATE if MODIFIERS[name].takes == "rate" else SHARE for name in KNOBS}
ROWS = {name: MODIFIERS[name] for name in KNOBS}
USUAL = "calm"
"""The life of a face that says nothing of it."""


def life_of(project: Project, line: Line) -> Life:
    """The life of a line `life PRESET, knobs`. Raises `Refused`."""
    reader = line.reader()
    reader.next()
    word = reader.next()
    base = _preset(project, word, reader.span, line)
    line.finish(reader)
    return _tuned(base, line)


def preset(project: Project, name: str, span: Span) -> Life:
    """A preset of the library or of the author. Raises `Refused`."""
    definition = project.names.find(name)
    if definition is None:
        raise project.unknown("FS206", name, project.names.known("life"), span)
    if definition.kind != "life":
        raise project.refuse("FS214", span, name=name, kind=article(definition.kind), wanted="a life")
    return _defined(project, definition, span)


def _preset(project: Project, word: Word | None, span: Span, line: Line) -> Life:
    if not isinstance(word, Name):
        where = word.span if word is not None else span
        raise project.refuse("FS312", where, text=where.text, advice="it is written `life PRESET, blink 8/min`")
    expansion = expand(project, word, line.scope)
    if expansion is not None and len(expansion.words) == 1:
        with inside(project, expansion, word.span):
            return _preset(project, expansion.words[0], span, line)
    return preset(project, word.text, word.span)


def _defined(project: Project, definition: Definition, span: Span) -> Life:
    """A definition `life NAME = PRESET, knobs`, or knobs alone: those that are not written are 0."""
    node = definition.node
    assert isinstance(node, Declaration)
    with project.entering(definition, span):
        knobs_only = node.phrases and _is_knob(node.phrases[0])
        if knobs_only:
            still = Life(definition.name if definition.library else "still", tuple((name, 0.0) for name in KNOBS))
            line = Line(project, "life", (_nothing(node.phrases[0]), *node.phrases), ROWS, GLOBAL)
            return _tuned(still, line)
        line = Line(project, "life", node.phrases, ROWS, GLOBAL)
        reader = line.reader()
        base = _preset(project, reader.next(), reader.span, line)
        line.finish(reader)
        return _tuned(base, line)


def _is_knob(phrase: Phrase) -> bool:
    word = phrase.words[0] if phrase.words else None
    return isinstance(word, Name) and word.text in KNOBS


def _nothing(phrase: Phrase) -> Phrase:
    return Phrase((), phrase.span)


def _tuned(base: Life, line: Line) -> Life:
    knobs: dict[str, Amount] = dict(base.knobs)
    for name in KNOBS:
        amount = line.amount(name, KINDS[name])
        if amount is not None:
            knobs[name] = amount
    return Life(base.name, tuple(knobs.items()))
