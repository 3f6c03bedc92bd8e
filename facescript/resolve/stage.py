"""`wait`, `view` and `life` to acts."""

from __future__ import annotations

from facescript.ir.acts import SetLife, View, Wait, WaitUntil
from facescript.resolve.lines import Line
from facescript.resolve.lives import life_of
from facescript.resolve.place import Place, face_named
from facescript.resolve.project import Project
from facescript.resolve.reader import over
from facescript.resolve.scope import Scope, expand, inside
from facescript.resolve.sums import moment, read_quantity
from facescript.resolve.units import SHARE, TIME
from facescript.syntax.tree import Name


def wait(project: Project, line: Line, place: Place) -> Wait | WaitUntil:
    reader = line.reader()
    reader.next()
    if reader.word("until"):
        rest = reader.rest()
        return WaitUntil(moment(project, rest, line.scope, over(rest) if rest else reader.span))
    duration = read_quantity(project, reader, TIME)
    line.finish(reader)
    return Wait(duration)


def view(project: Project, line: Line, place: Place) -> View:
    reader = line.reader()
    reader.next()
    face = None
    if not reader.word("all"):
        word = reader.next()
        if not isinstance(word, Name):
            span = word.span if word is not None else reader.span
            raise project.refuse("FS312", span, text=span.text, advice="it is written `view FACE 180%` or `view all`")
        face = _viewed(project, word, line.scope, place)
    zoom = read_quantity(project, reader, SHARE, least=0.01) if reader.peek() is not None else 1.0
    line.finish(reader)
    return View(face, zoom, line.amount("over", TIME) or 0.0)


def life(project: Project, line: Line, place: Place) -> SetLife:
    return SetLife(life_of(project, line), line.amount("over", TIME) or 0.0)


def _viewed(project: Project, word: Name, scope: Scope, place: Place) -> str:
    expansion = expand(project, word, scope)
    if expansion is not None and len(expansion.words) == 1 and isinstance(expansion.words[0], Name):
        with inside(project, expansion, word.span):
            return _viewed(project, expansion.words[0], expansion.scope, place)
    face = face_named(project, word, place.cast)
    if face in project.faces and not project.faces[face].seen:
        raise project.refuse("FS236", word.span, name=face)
    return face
