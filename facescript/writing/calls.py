"""Calls to statements of the language: a method a verb, keywords to modifiers, numbers to quantities."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Generic, TypeVar

from facescript.resolve.words import MODIFIERS, VALUE, Modifier

Value = str | float | int | bool
"""A number is of the unit that belongs there: seconds, a share (0.6 is 60 %), times a minute, a count; text is taken as
it is written in the language, but in quotes where a file or a text belongs."""

T = TypeVar("T")


class Calls(ABC, Generic[T]):
    """A face by its verbs; what becomes of a statement is for `statement` to say."""

    @abstractmethod
    def statement(self, words: str) -> T:
        """Takes a statement of this face, without its name."""

    def do(self, words: str, **modifiers: Value) -> T:
        """A statement as it is written in the language, such as an action of a library: `do("greet(60%)")`."""
        closer = [worded(MODIFIERS, name, value) for name, value in modifiers.items()]
        joined = [f"{' ' if direct else ', '}{text}" for text, direct in sorted(closer, key=lambda one: not one[1])]
        return self.statement(f"{words}{''.join(joined)}")

    def look(self, at: object, **modifiers: Value) -> T:
        """Turns the gaze there and stays on it."""
        return self.do(f"look at {at}", **modifiers)

    def glance(self, at: object, **modifiers: Value) -> T:
        """Looks there and back."""
        return self.do(f"glance {at}", **modifiers)

    def show(self, expression: str, **modifiers: Value) -> T:
        """Makes a sum of expressions and muscles the face's own: `smile 60% + brow.inner 20%`."""
        return self.do(f"show {expression}", **modifiers)

    def add(self, expression: str, **modifiers: Value) -> T:
        """Lays a sum on top of what is shown."""
        return self.do(f"add {expression}", **modifiers)

    def drop(self, name: str, **modifiers: Value) -> T:
        """Lets go of what was added, or of a statement by its name."""
        return self.do(f"drop {name}", **modifiers)

    def say(self, text: str, **modifiers: Value) -> T:
        """Speaks a text; what stands in it in brackets is done, and `*word*` is stressed, as in the language."""
        return self.do(f"say {quoted(text)}", **modifiers)

    def nod(self, degree: float = 1.0, **modifiers: Value) -> T:
        return self.do(f"nod {_share(degree)}", **modifiers)

    def shake(self, degree: float = 1.0, **modifiers: Value) -> T:
        return self.do(f"shake {_share(degree)}", **modifiers)

    def blink(self, degree: float = 1.0, **modifiers: Value) -> T:
        return self.do(f"blink {_share(degree)}", **modifiers)


def worded(table: Mapping[str, Modifier], name: str, value: Value) -> tuple[str, bool]:
    """A keyword and its value as the language has them, and whether they follow without a comma."""
    key = name.rstrip("_").replace("_", " ")
    row = table.get(key) or table.get(key.replace(" ", "-"))
    if row is None:
        raise TypeError(f"`{name}` is no word that belongs here: {', '.join(table)}")
    if (value is True) != (not row.takes):
        raise TypeError(f"`{name}` takes {'a ' + row.takes if row.takes else 'no value: `True`'}")
    said = _valued(row.takes, value)
    return " ".join(said if word == VALUE else word for word in row.pattern), row.direct


def _valued(kind: str, value: Value) -> str:
    if kind in ("file", "text"):
        return quoted(str(value))
    if isinstance(value, str):
        return value
    units = {"time": "s", "rate": "/min", "frame rate": "fps", "angle": "deg", "length": "cm"}
    if kind in ("percentage", "screen"):
        return _share(value)
    return f"{number(value)}{units.get(kind, '')}"


def _share(value: float) -> str:
    return f"{number(100.0 * value)}%"


def number(value: float) -> str:
    """A number as the language has it: without an exponent."""
    return f"{value:.6f}".rstrip("0").rstrip(".")


def quoted(text: str) -> str:
    """A text between quotes, in which the signs of the language keep their meaning."""
    plain = re.sub(r"\s+", " ", text.replace("\\", "\\\\").replace('"', '\\"'))
    return f'"{plain}"'
