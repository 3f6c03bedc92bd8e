"""An amount as an author wrote it to the same with another value: in its unit, as fine as eyes and frames need."""

from __future__ import annotations

import math
from dataclasses import dataclass

from facescript.resolve.units import UNITS
from facescript.syntax.tree import Dotted, LetDefinition, Name, Operator, Quantity, Script, Word

STEPS = {"ms": 10.0, "s": 0.01, "%": 1.0, "deg": 1.0, "cm": 0.1, "m": 0.01}
"""To how much a value is rounded, in its unit: 10 ms, one per cent, one degree."""


class Stuck(Exception):
    """A way that cannot be gone; `args[0]` is a sentence that says why, and what an author may do."""


@dataclass(frozen=True, slots=True)
class Change:
    """Puts `text` in the place of what stands from `start` to `end`, offsets in characters."""

    start: int
    end: int
    text: str


def written(value: float, unit: str) -> str:
    """A value in base units as it is written in a unit: `1.4s`, `600ms`, `40%`."""
    step = STEPS[unit]
    shown = math.floor(value * UNITS[unit].over / UNITS[unit].times / step + 0.5) * step + 0.0
    return f"{shown:.2f}".rstrip("0").rstrip(".") + unit


def time(seconds: float) -> str:
    """A new time: below a second in milliseconds."""
    return written(seconds, "ms" if seconds < 0.995 else "s")


@dataclass(frozen=True, slots=True)
class Literal:
    """The last number of an amount, by which the whole may be changed: `value` in base units, below 0 behind a minus.

    `first` is where it begins with the operator before it, None where it is all there is.
    """

    word: Quantity
    value: float
    first: int | None = None

    def changed(self, value: float) -> Change:
        """What makes it another value."""
        end = self.word.span.end
        if self.first is None:
            return Change(self.word.span.start, end, written(value, self.word.unit))
        shown = written(abs(value), self.word.unit)
        if shown == written(0.0, self.word.unit):
            return Change(self.first, end, "")
        return Change(self.first, end, f" {'-' if value < 0 else '+'} {shown}")


def literal(words: tuple[Word, ...]) -> Literal | None:
    """The number that an amount is, or ends in: `600ms`, `hello.end + 600ms`; None for any other."""
    *before, last = words
    if not isinstance(last, Quantity) or last.unit not in STEPS or drawn(words):
        return None
    value = last.value * UNITS[last.unit].times / UNITS[last.unit].over
    if not before:
        return Literal(last, value)
    sign = before[-1]
    if len(before) < 2 or not isinstance(sign, Operator) or sign.text not in "+-":
        return None
    return Literal(last, -value if sign.text == "-" else value, before[-2].span.end)


def drawn(words: tuple[Word, ...]) -> bool:
    return any(isinstance(word, Name) and word.text == "to" for word in words)


def number(words: tuple[Word, ...], script: Script, what: str) -> Literal:
    """As `literal`. Raises `Stuck` with what stands behind the amount: `what` is it that it says."""
    found = literal(words)
    if found is not None:
        return found
    text = words[0].span.to(words[-1].span).text
    if drawn(words):
        raise Stuck(f"{what} is drawn by the seed, `{text}`: change that in the text.")
    raise Stuck(f"{what} is `{text}`, {_where(words, script)}: change that in the text, or write a number here.")


def _where(words: tuple[Word, ...], script: Script) -> str:
    names = {
        str(word.text if isinstance(word, Name) else word.parts[0]) for word in words if isinstance(word, Name | Dotted)
    }
    for item in script.items:
        if isinstance(item, LetDefinition) and item.name.text in names:
            return f"which line {script.source.position(item.span.start)[0]} defines"
    return "which is given elsewhere" if names else "which is worked out"
