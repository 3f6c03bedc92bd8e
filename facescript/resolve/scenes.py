"""`scene` blocks, and what stands before them and holds for all."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from itertools import chain

from facescript.ir.acts import Node, Sequence, SetBackground, SetLife, View
from facescript.ir.play import MAIN, Scene
from facescript.resolve.blocks import statements
from facescript.resolve.labels import gather, gather_all
from facescript.resolve.place import Place, face_named
from facescript.resolve.project import Project, Refused
from facescript.resolve.scope import GLOBAL, Labels, Scope
from facescript.resolve.texts import bare_text
from facescript.syntax import tree
from facescript.text import Span

STATEMENTS = (tree.Act, tree.Cast, tree.Group, tree.Repeat, tree.Moment)
SETTINGS = ("background", "view", "life")


@dataclass(slots=True)
class Opening:
    """What is set before the scenes: for every scene anew."""

    background: SetBackground | None = None
    view: View | None = None


def main_scene(project: Project, script: tree.Script) -> Scene:
    """The only scene of a script without `scene`: its lines."""
    body = tuple(item for item in script.items if isinstance(item, STATEMENTS))
    whole = body[0].span.to(body[-1].span) if body else Span(script.source, 0, len(script.source.text))
    cast = tuple(project.faces)
    labels = gather_all(project, body)
    place = Place(Scope({}, labels), cast[0] if len(cast) == 1 else None, cast)
    return Scene(MAIN, cast, Sequence(_nodes(project, body, place, labels, cast), whole, clock=True), whole)


def _nodes(
    project: Project, body: tuple[tree.Statement, ...], place: Place, labels: Labels, given: tuple[object, ...]
) -> tuple[Node, ...]:
    """What statements come to, each by itself; `given` is what they all see besides the project's tables."""
    rows = project.memo.parts(project, "statement", body, given, partial(_statement, project, place), labels.counts)
    return tuple(chain.from_iterable(rows))


def _statement(project: Project, place: Place, statement: tree.Statement) -> tuple[Node, ...]:
    return statements(project, (statement,), place)


def scenes(project: Project, script: tree.Script, opening: Opening) -> list[Scene]:
    """The scenes of a script in order; two of one name are reported."""
    found: dict[str, Scene] = {}
    for item in script.items:
        if not isinstance(item, tree.Scene):
            continue
        name = item.name.text
        if name in found:
            project.report("FS239", item.name.span, name=name)
            continue
        given = opening.background, opening.view
        found[name] = project.memo.part(project, "scene", item, given, partial(_scene, project, item, opening))
    return list(found.values())


def _scene(project: Project, item: tree.Scene, opening: Opening) -> Scene:
    cast = _cast(project, item)
    labels = gather(project, item.body, f"{item.name.text}.")
    place = Place(Scope({}, labels), cast[0] if len(cast) == 1 else None, cast)
    given = (*cast, labels.prefix, *labels.names)
    body = Sequence(_nodes(project, item.body, place, labels, given), item.span, clock=True)
    title = bare_text(item.title) if item.title is not None else ""
    return Scene(item.name.text, cast, body, item.span, opening.background, opening.view, title)


def _cast(project: Project, item: tree.Scene) -> tuple[str, ...]:
    """The faces of a scene in the order declared: all, unless it says `with`."""
    if not item.faces:
        return tuple(project.faces)
    named = set()
    for name in item.faces:
        try:
            named.add(face_named(project, name, tuple(project.faces)))
        except Refused:
            continue
    return tuple(face for face in project.faces if face in named) or tuple(project.faces)


# ------------------------------------------------------------------------------------------------ before the scenes


def opening(project: Project, script: tree.Script) -> Opening:
    """`background`, `view` and lives that stand before the scenes; anything else outside a scene is reported."""
    found = Opening()
    cast = tuple(project.faces)
    place = Place(GLOBAL, cast[0] if len(cast) == 1 else None, cast)
    begun = False
    for item in script.items:
        begun = begun or isinstance(item, tree.Scene)
        if isinstance(item, STATEMENTS):
            if begun or not _sets(item):
                _outside(project, item)
            else:
                _set(project, found, item, place)
    return found


def _sets(item: tree.Statement) -> bool:
    if isinstance(item, tree.Cast):
        return all(_sets(inner) for inner in item.body)
    word = item.phrases[0].words[0] if isinstance(item, tree.Act) else None
    return isinstance(word, tree.Name) and word.text in SETTINGS


def _outside(project: Project, item: tree.Statement) -> None:
    """Reports a statement outside the scenes; a misspelt definition is one too."""
    word = item.phrases[0].words[0] if isinstance(item, tree.Act) else None
    if isinstance(word, tree.Name):
        clause, fixes = project.meant(word.text, DEFINERS, word.span)
        if fixes:
            project.report("FS204", word.span, fixes=fixes, name=word.text, meant=clause)
            return
    span = item.phrases[0].span if isinstance(item, tree.Act) else item.span
    project.report("FS223", _first_line(span))


DEFINERS = (
    *("background", "expression", "action", "target", "event", "film", "face", "life", "let", "scene", "view"),
    "viseme",
)


def _first_line(span: Span) -> Span:
    end = span.source.text.find("\n", span.start, span.end)
    return span if end < 0 else span.part(span.start, end)


def _set(project: Project, found: Opening, item: tree.Statement, place: Place) -> None:
    for node in _flat(statements(project, (item,), place)):
        verb = getattr(node, "verb", None)
        if isinstance(verb, SetBackground):
            found.background = verb
        elif isinstance(verb, View):
            found.view = verb
        elif isinstance(verb, SetLife):
            name = getattr(node, "face", None)
            if name in project.faces:
                project.faces[name] = replace(project.faces[name], life=verb.life)


def _flat(nodes: tuple[object, ...]) -> list[object]:
    flat: list[object] = []
    for node in nodes:
        flat += _flat(node.items) if isinstance(node, Sequence) else [node]
    return flat
