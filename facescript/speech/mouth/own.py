"""What an author says of single sounds to the table of mouth shapes."""

from __future__ import annotations

from collections.abc import Iterable

from facescript.ir import play
from facescript.speech.mouth.visemes import PARTS, PLAIN, Table, Values, Viseme


def table_of(visemes: Iterable[play.Viseme]) -> Table:
    """The table with an author's sounds before it. A sound keeps its kind, stop or vowel, where the table knows it."""
    own: dict[str, tuple[Viseme, ...]] = {}
    for each in visemes:
        own[each.sound] = _like(each) if each.like else (_shaped(each),)
    return Table(own)


def _like(viseme: play.Viseme) -> tuple[Viseme, ...]:
    """The shapes of the sound that it is like, at its degree."""
    shapes = PLAIN.visemes(viseme.like)
    return tuple(Viseme(each.shape, each.kind, each.degree * viseme.degree) for each in shapes)


def _shaped(viseme: play.Viseme) -> Viseme:
    """A shape of its own; the gap between the lips is what they rise and sink where nothing is said of it."""
    usual = PLAIN.visemes(viseme.sound)
    parts = {each.name.removeprefix("mouth."): each.value for each in viseme.drivers}
    found = {name: float(value) for name, value in parts.items() if isinstance(value, int | float)}
    found.setdefault("open", max(found.get("upper", 0.0) + found.get("lower", 0.0), 0.0))
    opened, wide, rounded, upper, lower, jaw, teeth, tongue = (found.get(name, 0.0) for name in PARTS)
    values: Values = (opened, wide, rounded, upper, lower, jaw, teeth, tongue)
    return Viseme(viseme.sound, usual[-1].kind if usual else "sound", 1.0, values)
