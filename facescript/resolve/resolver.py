"""Turns a script's tree into a play: names, units, defaults and the library resolved, faults reported."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from functools import partial

from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostics
from facescript.ir.acts import Life
from facescript.ir.play import Event, Play, Reaction, Target
from facescript.resolve import events
from facescript.resolve.blocks import statements
from facescript.resolve.checks import check_definitions, check_unused
from facescript.resolve.definitions import collect, library_names
from facescript.resolve.faces import default_face, define_default, drawn, face
from facescript.resolve.film import film
from facescript.resolve.lives import preset
from facescript.resolve.marks import check_marks
from facescript.resolve.memo import Memo
from facescript.resolve.names import Definition
from facescript.resolve.project import EACH, Project, Refused, TooMuch
from facescript.resolve.scenes import main_scene, opening, scenes
from facescript.resolve.spoilt import spoilt
from facescript.resolve.targets import target
from facescript.resolve.uses import DEFINITIONS, library, used
from facescript.resolve.visemes import viseme
from facescript.syntax import tree
from facescript.syntax.parser import parse_phrases
from facescript.text import Source, Span
from facescript.world import World

NOTHING: Mapping[str, str] = {}


def resolve(
    script: tree.Script,
    world: World,
    diagnostics: Diagnostics,
    overrides: Mapping[str, str] = NOTHING,
    memo: Memo | None = None,
) -> Play | None:
    """The play of a script, or None where something in it is an error (then `diagnostics` says what).

    `overrides` are values of `let`s by name, as text of the language (`--set NAME=VALUE`); `memo` knows what the states
    of a script came to that is edited.
    """
    project = begun(script, world, diagnostics, memo or Memo())
    return play_of(project, script, overrides)


def begun(script: tree.Script, world: World, diagnostics: Diagnostics, memo: Memo) -> Project:
    """The project of a script of which nothing is resolved yet."""
    project = Project(world, diagnostics, library_names(library(world)), memo)
    project.memo.begin(project, script)
    project.most += EACH * script.source.text.count("\n")
    return project


def play_of(project: Project, script: tree.Script, overrides: Mapping[str, str] = NOTHING) -> Play | None:
    """`resolve` in a project that was begun for it, and that knows the script's names from then on."""
    try:
        play = _resolved(project, script, overrides)
    except TooMuch as fault:
        span, most, what = fault.args
        project.diagnostics.add(diagnose("FS322", span, most=most, what=what))
        project.memo.forget()
        return None
    return None if project.diagnostics.failed else play


def _resolved(project: Project, script: tree.Script, overrides: Mapping[str, str]) -> Play:
    define(project, script, overrides)
    settings = [item for item in script.items if isinstance(item, tree.Setting)]
    project.film = film(project, [item for item in settings if item.kind == "film"])
    nobody = _default(project, script)
    project.memo.settle(project.names.written, project.spoilt)
    _people(project, nobody)
    for item in project.sounds:
        with suppress(Refused):
            viseme(project, item)
    scripted = _events(project, [item for item in settings if item.kind == "event"])
    project.scripted.update((event.kind, True) for event in scripted)
    before = opening(project, script) if _has_scenes(script) else None
    project.memo.settle(project.scripted, project.faces, project.targets)
    played = scenes(project, script, before) if before is not None else [main_scene(project, script)]
    reactions = _reactions(project, script, scripted)
    check_marks(project)
    check_definitions(project, statements, tuple(project.faces))
    if any(not isinstance(item, DEFINITIONS) for item in script.items):
        check_unused(project, script)
    return Play(
        project.film,
        tuple(project.faces.values()),
        tuple(found for found in project.targets.values() if found is not None),
        tuple(played),
        tuple(reactions),
        tuple(scripted),
        before.background if before is not None else None,
        before.view if before is not None else None,
        _lives(project),
        tuple(project.visemes.values()),
    )


def _has_scenes(script: tree.Script) -> bool:
    return any(isinstance(item, tree.Scene) for item in script.items)


# ------------------------------------------------------------------------------------------------ definitions


def define(project: Project, script: tree.Script, overrides: Mapping[str, str] = NOTHING) -> None:
    """Gives the project the names that a script and what it uses define; `overrides` as for `resolve`."""
    others = used(project, script)
    project.spoilt_lines, names = spoilt(project.diagnostics)
    project.spoilt.update(dict.fromkeys(names.union(script.lost, *(other.lost for other in others)), True))
    for other in others:
        collect(project, other, own=False)
    collect(project, script, own=True)
    for one in (*others, script):
        project.sounds += (item for item in one.items if isinstance(item, tree.VisemeDefinition))
    for name, text in overrides.items():
        _override(project, name, text)


def _override(project: Project, name: str, text: str) -> None:
    """Gives a `let` another value, from the command line."""
    source = Source("--set", f"{name}={text}")
    span = Span(source, 0, len(source.text))
    definition = project.names.written.get(name)
    if definition is None or not isinstance(definition.node, tree.LetDefinition):
        clause, _ = project.meant(name, project.names.known("let"), span)
        project.report("FS232", span, name=name, meant=clause)
        return
    value = Span(source, len(name) + 1, len(source.text))
    phrases = parse_phrases(value, project.diagnostics)
    if phrases is None:
        return
    if len(phrases) != 1:
        project.report("FS312", value, text=text, advice="one value such as `2s`, `40%` or `smile 40%` belongs here")
        return
    definition.node = replace(definition.node, value=phrases[0])


def _default(project: Project, script: tree.Script) -> Definition | None:
    """The definition of the face of a script that declares none."""
    if any(True for _ in project.names.all("face")):
        return None
    return define_default(project, Span(script.source, 0, 0))


def _people(project: Project, nobody: Definition | None) -> None:
    """Faces, and targets, whose definitions may be anywhere in the files."""
    for definition in list(project.names.written.values()):
        node, name = definition.node, definition.name
        if definition is nobody or not isinstance(node, tree.Declaration):
            continue
        if definition.kind == "kind":
            drawn(project, node)
        elif definition.kind == "face":
            project.faces[name] = project.memo.part(project, "face", node, None, partial(face, project, node))
        elif definition.kind == "target":
            project.targets[name] = project.memo.part(project, "target", node, None, partial(_target, project, node))
    if nobody is not None:
        only = default_face(project, nobody.span)
        project.faces[only.name] = only


def _target(project: Project, node: tree.Declaration) -> Target | None:
    with suppress(Refused):
        return target(project, node)
    return None


def _lives(project: Project) -> tuple[tuple[str, Life], ...]:
    found = []
    for definition in project.names.written.values():
        if definition.kind == "life":
            with suppress(Refused):
                found.append((definition.name, preset(project, definition.name, definition.span)))
    return tuple(found)


# ------------------------------------------------------------------------------------------------ events


def _events(project: Project, settings: list[tree.Setting]) -> list[Event]:
    found = []
    for setting in settings:
        with suppress(Refused):
            found.append(events.event(project, setting))
    return found


def _reactions(project: Project, script: tree.Script, scripted: list[Event]) -> list[Reaction]:
    found: list[tuple[tree.When, Reaction]] = []
    cast = tuple(project.faces)
    for node in (item for item in script.items if isinstance(item, tree.When)):
        number = len(found) + 1
        work = partial(_reaction, project, node, cast, number)
        reaction = project.memo.part(project, "reaction", node, (cast, number), work)
        if reaction is not None:
            found.append((node, reaction))
    events.check_reached(project, found, scripted)
    return [reaction for _, reaction in found]


def _reaction(project: Project, node: tree.When, cast: tuple[str, ...], number: int) -> Reaction | None:
    with suppress(Refused):
        return events.reaction(project, node, cast, number)
    return None
