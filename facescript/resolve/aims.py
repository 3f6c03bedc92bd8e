"""Words to what is looked at: targets, members of a crowd, faces and their parts, the camera, directions, persons."""

from __future__ import annotations

from facescript.ir.play import Crowd
from facescript.ir.values import Aim, Amount, AtCamera, AtFace, AtPerson, AtTarget, Away, Towards
from facescript.resolve.arithmetic import scaled
from facescript.resolve.names import Definition
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader, spelled
from facescript.resolve.scope import Scope, expand, inside, person
from facescript.resolve.sums import read_quantity
from facescript.resolve.units import ANGLE, article
from facescript.resolve.words import DIRECTIONS, PARTS
from facescript.syntax.tree import Bracket, Dotted, Name, Operator, Quantity, Word
from facescript.text import Span

USUAL_TURN = 20.0
"""Degrees of `look left` where no angle is written."""

SIGNS = {"left": (1.0, 0.0), "right": (-1.0, 0.0), "up": (0.0, 1.0), "down": (0.0, -1.0)}
"""Yaw and pitch of a direction: the face's own left is the viewer's right, which is positive."""


def read_aim(project: Project, reader: Reader, looker: str | None) -> Aim:
    """Reads one word that is looked at. `looker` is the face that looks. Raises `Refused`."""
    word = reader.next()
    if isinstance(word, Name | Dotted):
        return _named(project, word, reader.scope, looker)
    raise project.refuse("FS312", word.span if word else reader.span, text=_text(word, reader), advice=_advice())


def read_direction(project: Project, reader: Reader) -> Aim | None:
    """Reads `left 20deg`, `up 5deg`, `away`; None where the next word is no direction. Raises `Refused`."""
    if reader.word("away"):
        return Away()
    turns: dict[int, Amount] = {}
    while (word := reader.peek()) is not None and isinstance(word, Name) and word.text in DIRECTIONS:
        reader.next()
        yaw, pitch = SIGNS[word.text]
        axis = 0 if yaw else 1
        if axis in turns:
            raise project.refuse("FS310", word.span, name=word.text)
        angle = read_quantity(project, reader, ANGLE) if _angle_follows(reader) else USUAL_TURN
        turns[axis] = scaled(angle, yaw or pitch)
    return Towards(turns.get(0, 0.0), turns.get(1, 0.0)) if turns else None


def _angle_follows(reader: Reader) -> bool:
    word = reader.peek()
    if isinstance(word, Name):
        return word.text not in (*DIRECTIONS, "eyes", "head")
    return isinstance(word, Quantity | Bracket | Dotted) or (word is not None and not isinstance(word, Operator))


def _named(project: Project, word: Name | Dotted, scope: Scope, looker: str | None) -> Aim:
    guest = person(word, scope)
    if guest is not None:
        return AtPerson(guest.name)
    expansion = expand(project, word, scope)
    if expansion is not None:
        with inside(project, expansion, word.span):
            return _substituted(project, Reader(expansion.words, expansion.scope, word.span), looker)
    name = word.text if isinstance(word, Name) else str(word.parts[0])
    parts = word.parts[1:] if isinstance(word, Dotted) else ()
    if name == "camera" and not parts:
        return AtCamera()
    if name == "people":
        return _one_of_people(project, word, parts)
    definition = project.names.find(name)
    if definition is None:
        known = ["camera", "people", *project.names.known("target", "face"), *scope.bindings]
        raise project.unknown("FS202", name, known, word.span)
    if definition.kind == "face":
        return _face(project, word, definition, parts, looker)
    if definition.kind == "target":
        return _target(project, word, definition, parts)
    raise project.refuse("FS214", word.span, name=name, kind=article(definition.kind), wanted="a target or a face")


def _substituted(project: Project, reader: Reader, looker: str | None) -> Aim:
    aim = read_direction(project, reader) or read_aim(project, reader, looker)
    if reader.peek() is not None:
        raise project.refuse("FS312", reader.span, text=reader.span.text, advice=_advice())
    return aim


def _face(
    project: Project, word: Name | Dotted, definition: Definition, parts: tuple[str | int, ...], looker: str | None
) -> Aim:
    if definition.name == looker:
        raise project.refuse("FS226", word.span, name=looker)
    part = str(parts[0]) if parts else "eyes"
    if part not in PARTS or len(parts) > 1:
        raise project.refuse("FS235", word.span, text=spelled(word), name=definition.name)
    face = project.faces.get(definition.name)
    if face is not None and not face.seen:
        raise project.refuse("FS236", word.span, name=definition.name)
    return AtFace(definition.name, part)


def _target(project: Project, word: Name | Dotted, definition: Definition, parts: tuple[str | int, ...]) -> Aim:
    target = project.targets.get(definition.name)
    if target is None:
        raise Refused
    name = definition.name
    if not isinstance(target, Crowd):
        if parts:
            raise project.refuse("FS224", word.span, text=spelled(word), advice=f"`{name}` is one place")
        return AtTarget(name)
    if not parts:
        advice = f"`{name}` are several: `{name}.nearest`, `{name}.1`, or `scan {name}`"
        raise project.refuse("FS224", word.span, text=name, advice=advice)
    member = parts[0]
    fits = member == "nearest" or (isinstance(member, int) and 1 <= member <= len(target.members))
    if not fits or len(parts) > 1:
        advice = f"`{name}` are `{name}.1` to `{name}.{len(target.members)}`, and `{name}.nearest`"
        raise project.refuse("FS224", word.span, text=spelled(word), advice=advice)
    return AtTarget(name, member)


def _one_of_people(project: Project, word: Name | Dotted, parts: tuple[str | int, ...]) -> Aim:
    if parts != ("nearest",):
        advice = "`people` are several: `people.nearest`, or `scan people`"
        raise project.refuse("FS224", word.span, text=spelled(word), advice=advice)
    require_people(project, word.span)
    return AtTarget("people", "nearest")


def read_crowd(project: Project, reader: Reader) -> str:
    """Reads the name of a crowd; `people` is one. Raises `Refused`."""
    word = reader.next()
    if not isinstance(word, Name | Dotted):
        raise project.refuse("FS312", word.span if word else reader.span, text=_text(word, reader), advice=_advice())
    expansion = expand(project, word, reader.scope)
    if expansion is not None:
        with inside(project, expansion, word.span):
            return read_crowd(project, Reader(expansion.words, expansion.scope, word.span))
    name = spelled(word)
    if name == "people":
        require_people(project, word.span)
        return name
    definition = project.names.find(name)
    if definition is None:
        known = ["people", *(name for name, target in project.targets.items() if isinstance(target, Crowd))]
        raise project.unknown("FS202", name, known, word.span)
    target = project.targets.get(definition.name)
    if definition.kind != "target" or (target is not None and not isinstance(target, Crowd)):
        wanted = "a crowd: `target NAME of (...) (...)`"
        kind = article(definition.kind)
        raise project.refuse("FS214", word.span, name=name, kind=kind, wanted=wanted)
    if target is None:
        raise Refused
    return name


def require_people(project: Project, span: Span) -> None:
    """Tells of `people` where no scripted event brings any: in a build nobody is there."""
    if "arrives" not in project.scripted:
        project.report("FS806", span)


def _text(word: Word | None, reader: Reader) -> str:
    return word.span.text if word is not None else reader.span.text


def _advice() -> str:
    return "a target, a face, `camera`, a direction (`left 20deg`) or `away` belongs here"
