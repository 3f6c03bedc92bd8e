"""A statement to how strong it is, and to the edit that makes it stronger or weaker."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.preview.dragging.allowed import Said
from facescript.preview.dragging.amounts import Change, Literal, Stuck, literal, number, written
from facescript.resolve.lines import Words, segments
from facescript.resolve.units import UNITS
from facescript.syntax import tree

GESTURES = frozenset(("nod", "shake", "tilt", "blink", "wink"))
SIDES = frozenset(("left", "right"))
TURN, TURNED = 20.0, {"left": 45.0, "right": 45.0, "up": 30.0, "down": 30.0}
"""Degrees that `look left` turns unless said, and how far the head turns."""


@dataclass(frozen=True, slots=True)
class Degree:
    """How strong a statement is: `now` in base units, and between what it may be dragged. Its number is `found`, or
    would stand at `place`."""

    unit: str
    now: float
    least: float
    most: float
    place: int
    found: Literal | None

    def changed(self, value: float) -> Change:
        """What makes it another degree. Raises `Stuck` beyond its bounds."""
        if not self.least <= value <= self.most:
            raise Stuck(f"its degree goes from {written(self.least, self.unit)} to {written(self.most, self.unit)}.")
        if self.found is not None:
            return self.found.changed(value)
        return Change(self.place, self.place, f" {written(value, self.unit)}")


def degree(said: Said) -> Degree:
    """The degree of a statement. Raises `Stuck` where it has none, or none that stands in its line as a number."""
    words = segments(said.phrases[0].words)[0]
    if said.verb in GESTURES:
        sided = len(words) > 1 and isinstance(words[1], tree.Name) and words[1].text in SIDES
        return _read(said, words[: 2 if sided else 1], words[2 if sided else 1 :])
    if said.verb in ("show", "add"):
        bare = words[0].span.text != said.verb
        return _summed(said, words if bare else words[1:])
    if said.verb == "look" and len(words) > 1 and isinstance(words[1], tree.Name) and words[1].text in TURNED:
        return _turned(said, words)
    raise Stuck("it is done or not done: it has no degree.")


def _summed(said: Said, words: Words) -> Degree:
    """Of a sum of one term, which is that term's."""
    operators = [word for word in words if isinstance(word, tree.Operator)]
    if operators or not isinstance(words[0], tree.Name | tree.Dotted | tree.Call) or words[0].span.text == "neutral":
        raise Stuck("it is a sum: each of its parts has a degree of its own, to be changed in the text.")
    return _read(said, words[:1], words[1:])


def _read(said: Said, named: Words, rest: Words) -> Degree:
    if not rest:
        return Degree("%", 1.0, 0.0, 1.0, named[-1].span.end, None)
    found = number(rest, said.script, "its degree")
    unit = found.word.unit
    if unit == "%":
        return Degree(unit, found.value, -1.0 if found.value < 0 else 0.0, max(1.0, found.value), 0, found)
    most = max(TURNED["left"] if unit == "deg" else 10.0 * UNITS[unit].times, abs(found.value))
    return Degree(unit, found.value, -most, most, 0, found)


def _turned(said: Said, words: Words) -> Degree:
    """Of a look in one direction: how far it turns."""
    if len(words) > 3 or (len(words) == 3 and literal(words[2:]) is None):
        raise Stuck("it turns in two directions, or by a value with a name: change that in the text.")
    most = TURNED[words[1].span.text]
    if len(words) == 2:
        return Degree("deg", TURN, 0.0, most, words[1].span.end, None)
    found = number(words[2:], said.script, "its degree")
    return Degree("deg", found.value, 0.0, max(most, found.value), 0, found)
