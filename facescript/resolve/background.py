"""`background` to an act: a colour, a gradient, a picture that can be used, or nothing."""

from __future__ import annotations

from dataclasses import dataclass, replace

from facescript.ir.acts import Gradient, SetBackground
from facescript.resolve.lines import Line
from facescript.resolve.pictures import picture_path
from facescript.resolve.place import Place
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader
from facescript.resolve.scope import Scope, expand, inside
from facescript.resolve.suggest import nearest
from facescript.resolve.suggest import replace as instead
from facescript.resolve.sums import left_over, number
from facescript.resolve.units import ANGLE, TIME
from facescript.resolve.words import COURSES, NOTHING
from facescript.syntax.tree import Colour, Dotted, Name, String, Word
from facescript.text import Span

MOST_COLOURS = 16
"""Colours of one gradient."""

NOTHING_TOO = ("transparent", "clear", "nothing", "off", "no")
"""What people also write for `none`."""

DOWN = -90.0
"""The direction of a gradient that does not say its own, deg."""

DIRECTIONS = {"top to bottom": DOWN, "left to right": 0.0, "round": None}


@dataclass(frozen=True, slots=True)
class Part:
    """A colour, or a picture's path in the project, or neither: nothing. `span` is where it is written."""

    span: Span
    colour: str | None = None
    picture: str | None = None


def background(project: Project, line: Line, place: Place) -> SetBackground:
    reader = line.reader()
    reader.next()
    parts = _parts(project, reader)
    line.finish(reader)
    made = _made(project, line, parts)
    return replace(made, over=line.amount("over", TIME) or 0.0)


def check_ground(project: Project, words: tuple[Word, ...], scope: Scope, span: Span) -> None:
    """Reads words that begin as a background does, the value of a `let`. Raises `Refused`."""
    reader = Reader(words, scope, span)
    parts = _parts(project, reader)
    left_over(project, reader)
    if len(parts) > 1:
        _colours(project, parts)


def is_ground(project: Project, words: tuple[Word, ...], scope: Scope) -> bool:
    """Whether words begin as a background of colours or as none, and not as a quantity or a name of something else."""
    word = words[0] if words else None
    if isinstance(word, Name | Dotted):
        if isinstance(word, Name) and word.text == NOTHING:
            return True
        expansion = expand(project, word, scope)
        if expansion is None or (expansion.definition is not None and expansion.definition in project.open):
            return False
        with inside(project, expansion, word.span):
            return is_ground(project, expansion.words, expansion.scope)
    return isinstance(word, Colour)


def _made(project: Project, line: Line, parts: list[Part]) -> SetBackground:
    course = next((name for name in COURSES if name in line.parts), None)
    if len(parts) == 1 and course is None:
        return SetBackground(parts[0].colour, parts[0].picture)
    colours = _colours(project, parts)
    if len(colours) == 1:
        raise project.refuse(
            "FS340", line.spans["course"], reason="it has one colour; write a second one: `#102040 to #304060`"
        )
    towards = DIRECTIONS.get(course or "top to bottom", DOWN)
    if course == "towards":
        towards = number(project, line.parts[course], line.scope, ANGLE, line.spans["course"], least=None)
    return SetBackground(None, None, gradient=Gradient(colours, towards))


def _colours(project: Project, parts: list[Part]) -> tuple[str, ...]:
    """The colours of a gradient. Raises `Refused` where a part is something else."""
    for part in parts:
        if part.colour is None:
            reason = f"`{part.span.text}` is no colour, and it goes from colour to colour"
            raise project.refuse("FS340", part.span, reason=reason)
    if len(parts) > MOST_COLOURS:
        span = parts[MOST_COLOURS].span
        raise project.refuse("FS340", span, reason=f"it has more than {MOST_COLOURS} colours; leave some out")
    return tuple(part.colour or "" for part in parts)


# ------------------------------------------------------------------------------------------------ words


def _parts(project: Project, reader: Reader) -> list[Part]:
    """What `to` joins. Raises `Refused`."""
    parts = _part(project, reader)
    while reader.word("to"):
        parts += _part(project, reader)
    if isinstance(word := reader.peek(), Colour):
        fix = instead(word.span, f"to {word.text}")
        raise project.refuse("FS340", word.span, fixes=(fix,), reason="between two colours stands `to`")
    return parts


def _part(project: Project, reader: Reader) -> list[Part]:
    """One colour, picture or `none`, or what a name stands for."""
    word = reader.next()
    if isinstance(word, Colour):
        return [Part(word.span, colour=word.text.lower())]
    if isinstance(word, String):
        return [Part(word.span, picture=picture_path(project, word.value, word.span))]
    if isinstance(word, Name) and word.text == NOTHING:
        return [Part(word.span)]
    if isinstance(word, Name | Dotted):
        found = _named(project, word, reader.scope)
        if found is not None:
            return [replace(part, span=word.span) for part in found]
    raise _no_ground(project, word, word.span if word is not None else reader.span)


def _named(project: Project, word: Name | Dotted, scope: Scope) -> list[Part] | None:
    expansion = expand(project, word, scope)
    if expansion is None:
        return None
    with inside(project, expansion, word.span):
        if expansion.cell is not None and not is_ground(project, expansion.words, expansion.scope):
            return [Part(word.span, picture=picture_path(project, expansion.cell.text, word.span))]
        reader = Reader(expansion.words, expansion.scope, word.span)
        parts = _parts(project, reader)
        left_over(project, reader)
        return parts


def _no_ground(project: Project, word: Word | None, span: Span) -> Refused:
    advice = 'a gradient such as `#102040 to #304060`, a picture such as `"room.png"`, or `none`'
    slip = isinstance(word, Name) and (word.text in NOTHING_TOO or nearest(word.text, (NOTHING,)))
    fixes = (instead(span, NOTHING),) if slip else ()
    return project.refuse("FS314", span, fixes=fixes, text=span.text, advice=advice)
