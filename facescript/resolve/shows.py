"""`show`, `add`, `drop` and the gestures to acts."""

from __future__ import annotations

from typing import Literal, cast

from facescript.ir.acts import Add, Drop, Gesture, Manner, Show, Timing
from facescript.ir.play import Face
from facescript.ir.values import Amount, Mix, Term
from facescript.performance.channels import channels_of
from facescript.resolve.arithmetic import bounds
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.kinds.library import kinds_with
from facescript.resolve.lines import Line
from facescript.resolve.mixes import expression_mix, find_expression, read_mix
from facescript.resolve.place import Place
from facescript.resolve.project import Project
from facescript.resolve.reader import Reader, spelled
from facescript.resolve.scope import Scope, expand, inside
from facescript.resolve.suggest import nearest
from facescript.resolve.sums import read_quantity
from facescript.resolve.units import SHARE, TIME
from facescript.resolve.words import EASES, MANNERS
from facescript.syntax.tree import Call, Dotted, Name, Word

POSES = {"nod": "nodding", "shake": "shaking", "tilt": "tilting", "blink": "blinking", "wink": "winking"}
"""The library's expression that is each gesture's far pose."""


def show(project: Project, line: Line, place: Place) -> Show:
    return Show(_mix(project, line, place), timing(line))


def add(project: Project, line: Line, place: Place) -> Add:
    return Add(_mix(project, line, place), timing(line))


def drop(project: Project, line: Line, place: Place) -> Drop:
    reader = line.reader()
    reader.next()
    word = reader.next()
    if not isinstance(word, Name | Dotted | Call):
        span = word.span if word is not None else reader.span
        raise project.refuse("FS312", span, text=span.text, advice="it is written `drop NAME`")
    name = _dropped(project, word, line.scope)
    line.finish(reader)
    return Drop(name, timing(line))


def gesture(project: Project, line: Line, place: Place) -> Gesture:
    reader = line.reader()
    verb = reader.next()
    assert isinstance(verb, Name)
    kind = cast(Literal["nod", "shake", "tilt", "blink", "wink"], verb.text)
    side = _side(project, reader, kind) if kind in ("tilt", "wink") else ""
    degree: Amount = 1.0
    word = reader.peek()
    if word is not None and not (isinstance(word, Name) and word.text in line.rows):
        degree = read_quantity(project, reader, SHARE)
        if bounds(degree)[1] > 1.0:
            project.report("FS305", word.span, name=kind, text=word.span.text)
    line.finish(reader)
    return Gesture(kind, degree, _pose(project, kind, side, verb), timing(line))


def timing(line: Line) -> Timing:
    """`over T for T back in T ease NAME, MANNER` of a line. Raises `Refused`."""
    if not line.parts:
        return PLAIN
    ease = line.name("ease")
    if ease is not None and ease.text not in EASES:
        candidate = nearest(ease.text, EASES)
        known = ", ".join(f"`{name}`" for name in EASES)
        clause = f"did you mean `{candidate}`?" if candidate else f"there are {known}."
        raise line.project.refuse("FS329", ease.span, name=ease.text, what="curve", meant=clause)
    over, lasting, back = (line.amount(name, TIME) for name in ("over", "for", "back"))
    if back is not None and lasting is None:
        raise line.project.refuse("FS333", line.spans["back"])
    manner = next((name for name in MANNERS if name in line.parts), "")
    return Timing(over, lasting, back, ease.text if ease else None, cast(Manner, manner))


PLAIN = Timing()


def _mix(project: Project, line: Line, place: Place) -> Mix:
    reader = line.reader()
    reader.next()
    mix = read_mix(project, reader)
    line.finish(reader)
    if place.face in project.faces:
        _tell_of_lacking(project, line, project.faces[place.face], mix)
    return mix


def _tell_of_lacking(project: Project, line: Line, face: Face, mix: Mix) -> None:
    """Tells of channels in a sum that the face does not have. What expressions hold of them is for other faces."""
    has = channels_of(face.parts)
    for term in mix.terms:
        lacks = [name for name in PRIMITIVES[term.name].names if kinds_with(name)] if term.name in PRIMITIVES else []
        if lacks and lacks[0] not in has:
            kinds = ", ".join(f"`{kind}`" for kind in kinds_with(lacks[0]))
            project.report("FS250", line.span, face=face.name, name=term.name, kinds=kinds)


def _side(project: Project, reader: Reader, kind: str) -> str:
    for side in ("left", "right"):
        if reader.word(side):
            return side
    raise project.refuse(
        "FS312", reader.here(), text=reader.here().text, advice=f"write `{kind} left` or `{kind} right`"
    )


def _pose(project: Project, kind: str, side: str, verb: Name) -> Mix:
    """The far pose at 100 %: one eye's wink, and to the right a tilt to the left turned round."""
    mix = expression_mix(project, POSES[kind], side if kind == "wink" else "", 1.0, verb.span)
    if kind == "tilt" and side == "right":
        return Mix(tuple(Term(term.name, -1.0, term.drivers) for term in mix.terms))
    return mix


def _dropped(project: Project, word: Word, scope: Scope) -> str:
    """What `drop` lets go: a label's full name, or a term's name as it is written. Raises `Refused`."""
    if isinstance(word, Call):
        word = word.name
    if not isinstance(word, Name | Dotted):
        raise project.refuse("FS312", word.span, text=word.span.text, advice="it is written `drop NAME`")
    name = spelled(word)
    label = scope.label(name)
    if label is not None:
        return label
    if name in PRIMITIVES:
        return name
    expansion = expand(project, word, scope)
    if expansion is not None:
        with inside(project, expansion, word.span):
            return _dropped(project, expansion.words[0], expansion.scope)
    if project.names.find(name) is None and scope.labels is not None and isinstance(word, Name):
        known = [*scope.labels.seen(), *project.names.known("expression"), *PRIMITIVES]
        raise project.unknown("FS238", name, known, word.span)
    find_expression(project, word)
    return name
