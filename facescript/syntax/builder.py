"""Terminals and rules of the grammar to nodes of the tree: the method that a terminal or a rule names."""

from __future__ import annotations

import re
import unicodedata
from typing import Any

from facescript.syntax import tree
from facescript.text import Piece, Source, Span

_PARTS = re.compile(r'"([^"\n]*)"|([^."]+)')
_NUMBER = re.compile(r"-?[0-9]*\.?[0-9]+")


class Builder:
    """Makes the nodes of one source or piece. Rules get the values of their symbols without punctuation, and their
    start and end.

    A line that could not be read has the value None; whatever holds lines leaves it out.
    """

    def __init__(self, place: Source | Piece) -> None:
        self.place = place

    # -------------------------------------------------------------------------------------------- terminals

    def name(self, text: str, start: int, end: int) -> tree.Name:
        return tree.Name(_composed(text), Span(self.place, start, end))

    def dotted(self, text: str, start: int, end: int) -> tree.Dotted:
        parts: list[str | int] = []
        quoted: list[bool] = []
        for match in _PARTS.finditer(text):
            word, name = match.groups()
            quoted.append(word is not None)
            if word is not None:
                parts.append(word)
            else:
                parts.append(int(name) if name[0] in "0123456789" else _composed(name))
        return tree.Dotted(tuple(parts), tuple(quoted), Span(self.place, start, end))

    def string(self, text: str, start: int, end: int) -> tree.String:
        return tree.String(text[1:-1], Span(self.place, start, end))

    def quantity(self, text: str, start: int, end: int) -> tree.Quantity:
        digits = _NUMBER.match(text).end()  # type: ignore[union-attr]
        return tree.Quantity(float(text[:digits]), text[digits:], Span(self.place, start, end))

    def integer(self, text: str, start: int, end: int) -> tree.Integer:
        return tree.Integer(int(text), Span(self.place, start, end))

    def size(self, text: str, start: int, end: int) -> tree.Size:
        width, height = text.split("x")
        return tree.Size(int(width), int(height), Span(self.place, start, end))

    def colour(self, text: str, start: int, end: int) -> tree.Colour:
        return tree.Colour(text, Span(self.place, start, end))

    def operator(self, text: str, start: int, end: int) -> tree.Operator:
        return tree.Operator(text, Span(self.place, start, end))

    # -------------------------------------------------------------------------------------------- words

    def call(self, children: list[Any], start: int, end: int) -> tree.Call:
        name, *arguments = children
        return tree.Call(name, tuple(arguments), Span(self.place, start, end))

    def argument(self, children: list[Any], start: int, end: int) -> tree.Argument:
        return tree.Argument(None, children[0], Span(self.place, start, end))

    def named_argument(self, children: list[Any], start: int, end: int) -> tree.Argument:
        name, value = children
        return tree.Argument(name, value, Span(self.place, start, end))

    def bracket(self, children: list[Any], start: int, end: int) -> tree.Point | tree.Bracket:
        inner = children[0]
        span = Span(self.place, start, end)
        if len(inner.words) in (2, 3) and all(type(word) is tree.Quantity for word in inner.words):
            return tree.Point(inner.words, span)
        return tree.Bracket(inner, span)

    def phrase(self, children: list[Any], start: int, end: int) -> tree.Phrase:
        return tree.Phrase(tuple(children), Span(self.place, start, end))

    def phrases(self, children: list[Any], start: int, end: int) -> tuple[tree.Phrase, ...]:
        return tuple(children)

    def cue(self, children: list[Any], start: int, end: int) -> tuple[tree.Phrase, ...]:
        phrases: tuple[tree.Phrase, ...] = children[0]
        return phrases

    # -------------------------------------------------------------------------------------------- statements

    def act(self, children: list[Any], start: int, end: int) -> tree.Act:
        phrases, *under = children
        parts = under[0] if under else ()
        more = tuple(part for part in parts if type(part) is tree.String)
        ons = tuple(part for part in parts if type(part) is tree.On)
        return tree.Act(phrases, more, ons, Span(self.place, start, end))

    def life_act(self, children: list[Any], start: int, end: int) -> tree.Act:
        verb, (first, *others) = children
        first = tree.Phrase((verb, *first.words), verb.span.to(first.span))
        return tree.Act((first, *others), (), (), Span(self.place, start, end))

    def under(self, children: list[Any], start: int, end: int) -> tuple[Any, ...]:
        return _read(children)

    def on(self, children: list[Any], start: int, end: int) -> tree.On:
        word, *nth, body = children
        return tree.On(word, nth[0] if nth else 1, body, Span(self.place, start, end))

    def nth(self, text: str, start: int, end: int) -> int:
        return int(text[1:])

    def word(self, text: str, start: int, end: int) -> str:
        """A keyword that says which kind of block."""
        return text

    def group(self, children: list[Any], start: int, end: int) -> tree.Group:
        kind, body = children
        return tree.Group(kind, body, Span(self.place, start, end))

    def repeat(self, children: list[Any], start: int, end: int) -> tree.Repeat:
        how, body = children
        return tree.Repeat(how, body, Span(self.place, start, end))

    def cast(self, children: list[Any], start: int, end: int) -> tree.Cast:
        face, body = children
        return tree.Cast(face, body, Span(self.place, start, end))

    def moment(self, children: list[Any], start: int, end: int) -> tree.Moment:
        time, body = children
        return tree.Moment(time, body, Span(self.place, start, end))

    def body(self, children: list[Any], start: int, end: int) -> tuple[tree.Statement, ...]:
        return _read(children)

    def fault(self, children: list[Any], start: int, end: int) -> None:
        return None

    spoilt = fault

    # -------------------------------------------------------------------------------------------- definitions

    def expression(self, children: list[Any], start: int, end: int) -> tree.ExpressionDefinition:
        name, *head, value = children
        return tree.ExpressionDefinition(name, head[0] if head else (), value, Span(self.place, start, end))

    def action(self, children: list[Any], start: int, end: int) -> tree.ActionDefinition:
        name, *head, body = children
        return tree.ActionDefinition(name, head[0] if head else (), body, Span(self.place, start, end))

    def parameters(self, children: list[Any], start: int, end: int) -> tuple[tree.Parameter, ...]:
        return tuple(children)

    def parameter(self, children: list[Any], start: int, end: int) -> tree.Parameter:
        name, *default = children
        return tree.Parameter(name, default[0] if default else None, Span(self.place, start, end))

    def let(self, children: list[Any], start: int, end: int) -> tree.LetDefinition:
        name, value = children
        return tree.LetDefinition(name, value, Span(self.place, start, end))

    def viseme(self, children: list[Any], start: int, end: int) -> tree.VisemeDefinition:
        sound, value = children
        return tree.VisemeDefinition(sound, value, Span(self.place, start, end))

    def face(self, children: list[Any], start: int, end: int) -> tree.Declaration:
        return self._declaration("face", children, start, end)

    def life(self, children: list[Any], start: int, end: int) -> tree.Declaration:
        return self._declaration("life", children, start, end)

    def kind(self, children: list[Any], start: int, end: int) -> tree.Declaration:
        return self._declaration("kind", children, start, end)

    def target(self, children: list[Any], start: int, end: int) -> tree.Declaration:
        return self._declaration("target", children, start, end)

    def _declaration(self, kind: str, children: list[Any], start: int, end: int) -> tree.Declaration:
        name, phrases, *lines = children
        return tree.Declaration(kind, name, phrases, lines[0] if lines else (), Span(self.place, start, end))

    def lines(self, children: list[Any], start: int, end: int) -> tuple[tuple[tree.Phrase, ...], ...]:
        return _read(children)

    def line(self, children: list[Any], start: int, end: int) -> tuple[tree.Phrase, ...]:
        phrases: tuple[tree.Phrase, ...] = children[0]
        return phrases

    def film(self, children: list[Any], start: int, end: int) -> tree.Setting:
        return tree.Setting("film", children[0], Span(self.place, start, end))

    def event(self, children: list[Any], start: int, end: int) -> tree.Setting:
        return tree.Setting("event", children[0], Span(self.place, start, end))

    def use(self, children: list[Any], start: int, end: int) -> tree.Use:
        return tree.Use(children[0], Span(self.place, start, end))

    def scene(self, children: list[Any], start: int, end: int) -> tree.Scene:
        name, *rest, body = children
        title = rest.pop(0) if rest and isinstance(rest[0], tree.String) else None
        return tree.Scene(name, tuple(rest), body, Span(self.place, start, end), title)

    def when(self, children: list[Any], start: int, end: int) -> tree.When:
        event, body = children
        return tree.When(event, body, Span(self.place, start, end))

    def start(self, children: list[Any], start: int, end: int) -> tuple[tree.Item, ...]:
        return _read(children)


TERMINALS = {
    "NAME": "name",
    "DOTTED": "dotted",
    "STRING": "string",
    "QUANTITY": "quantity",
    "INTEGER": "integer",
    "SIZE": "size",
    "COLOUR": "colour",
    "OPERATOR": "operator",
    "NTH": "nth",
    "LIFE": "name",
    "TOGETHER": "word",
    "CHOOSE": "word",
    "IN_TURN": "word",
}
"""The method of each terminal that has a value."""


def _read(children: list[Any]) -> tuple[Any, ...]:
    return tuple(child for child in children if child is not None)


def _composed(text: str) -> str:
    """A name in composed form, so that two ways to type one letter make one name."""
    return text if text.isascii() else unicodedata.normalize("NFC", text)
