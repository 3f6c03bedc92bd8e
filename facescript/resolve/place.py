"""Where a statement stands: its scope, the face that does it, the faces it may name."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.resolve.project import Project
from facescript.resolve.scope import Scope
from facescript.syntax.tree import Name
from facescript.text import Span

FACELESS = frozenset({"wait", "background", "view", "picture", "link"})
"""Verbs of the scene; all others are done by a face."""


@dataclass(frozen=True, slots=True)
class Place:
    """`face` is who does what stands here (None: nobody is named), `cast` the faces of the scene; `site` is the call of
    the action that these statements come from, where messages about the call point."""

    scope: Scope
    face: str | None
    cast: tuple[str, ...]
    site: Span | None = None

    def within(self, scope: Scope) -> Place:
        return Place(scope, self.face, self.cast, self.site)

    def by(self, face: str) -> Place:
        return Place(self.scope, face, self.cast, self.site)


def doer(project: Project, verb: str, place: Place, span: Span) -> str | None:
    """The face that does a verb, None for verbs of the scene. Raises `Refused` where a line lacks its name."""
    if verb in FACELESS:
        return None
    if place.face is None:
        names = ", ".join(f"`{name}:`" for name in place.cast)
        raise project.refuse("FS212", place.site or span, names=names)
    face = project.faces.get(place.face)
    if face is not None and not face.seen and verb != "say":
        raise project.refuse("FS237", place.site or span, name=place.face, verb=verb)
    return place.face


def face_named(project: Project, name: Name, cast: tuple[str, ...], others: tuple[str, ...] = ()) -> str:
    """The face of a scene that a name is. `others` are words that also stand before a colon. Raises `Refused`."""
    definition = project.names.find(name.text)
    if definition is None or definition.kind != "face":
        known = [*project.names.known("face"), *others]
        if definition is None:
            raise project.unknown("FS203", name.text, known, name.span)
        clause, fixes = project.meant(name.text, known, name.span)
        raise project.refuse("FS203", name.span, fixes=fixes, name=name.text, meant=clause)
    if name.text not in cast:
        raise project.refuse("FS213", name.span, name=name.text)
    return name.text
