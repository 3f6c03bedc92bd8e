"""`play "FILE"` to an act: a recorded performance, read from a file of the project."""

from __future__ import annotations

from facescript.ir.acts import Perform, Timing
from facescript.resolve.files import project_path
from facescript.resolve.lines import Line
from facescript.resolve.place import Place
from facescript.resolve.project import Project
from facescript.resolve.quoted import quoted_text
from facescript.resolve.speeds import speed_of
from facescript.resolve.units import TIME
from facescript.shapes.takes.files import LARGEST, read_take
from facescript.shapes.takes.model import Found, NotATake
from facescript.text import Span
from facescript.world import WorldFailure

SLOWEST, FASTEST = 0.1, 10.0
"""The least and the greatest `speed` of a take."""


def play(project: Project, line: Line, place: Place) -> Perform:
    reader = line.reader()
    reader.next()
    path, span = quoted_text(project, reader, 'it is written `play "FILE"`')
    line.finish(reader)
    name, face = project_path(span, path), place.face or ""
    found = project.memo.once(
        project, ("take", name, face), line.head[1], lambda: _read(project, path, name, span, face)
    )
    speed = speed_of(line, SLOWEST, FASTEST, "a recorded face has")
    return Perform(found.take, speed, Timing(lasting=line.amount("for", TIME)))


def _read(project: Project, path: str, name: str, span: Span, face: str) -> Found:
    try:
        found = read_take(name, project.world_of(name).read(name, LARGEST), face)
    except WorldFailure as failure:
        raise project.refuse("FS701", span, path=path, reason=failure.args[0]) from None
    except NotATake as fault:
        where = f"line {fault.line}: " if fault.line else ""
        raise project.refuse("FS730", span, path=path, reason=f"{where}{fault.args[0]}") from None
    if found.lost:
        rows = found.lost + found.take.frames
        project.report("FS731", span, path=path, lost=found.lost, rows=rows)
    return found
