"""The scripts that a script uses and the library: read once each, circles found."""

from __future__ import annotations

from functools import lru_cache
from posixpath import normpath

from facescript.diagnostics.model import Diagnostics
from facescript.resolve.files import project_path
from facescript.resolve.project import Project
from facescript.syntax import tree
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World, WorldFailure

DEFINITIONS = (
    tree.ExpressionDefinition,
    tree.ActionDefinition,
    tree.LetDefinition,
    tree.VisemeDefinition,
    tree.Declaration,
    tree.Use,
)
"""What a script that others use brings."""

DEEPEST = 100
"""Scripts by way of which another one may be used."""


def used(project: Project, script: tree.Script) -> list[tree.Script]:
    """All scripts that `script` uses, directly or through others, in the order first met."""
    found: dict[str, tree.Script] = {}
    _follow(project, script, [normpath(script.source.name)], found)
    return list(found.values())


def _follow(project: Project, script: tree.Script, way: list[str], found: dict[str, tree.Script]) -> None:
    for item in script.items:
        if not isinstance(item, tree.Use):
            continue
        name = project_path(item.path.span, item.path.value)
        if name in way:
            chain = " -> ".join([*way[way.index(name) :], name])
            project.report("FS702", item.span, chain=chain)
        elif len(way) > DEEPEST:
            reason = f"it is used by way of more than {DEEPEST} others"
            project.report("FS701", item.path.span, path=item.path.value, reason=reason)
        elif name not in found:
            _read(project, item, name, way, found)


def _read(project: Project, item: tree.Use, name: str, way: list[str], found: dict[str, tree.Script]) -> None:
    try:
        source = project.world.source(name)
    except WorldFailure as failure:
        project.report("FS701", item.path.span, path=item.path.value, reason=failure.args[0])
        return
    inner = project.memo.parse(source, project.diagnostics)
    found[name] = inner
    if any(not isinstance(part, DEFINITIONS) for part in inner.items):
        project.report("FS231", item.span, path=item.path.value)
    _follow(project, inner, [*way, name], found)


def library(world: World) -> tuple[tree.Script, ...]:
    """The library's scripts; parsed once for the same text."""
    return tuple(_parsed(source.name, source.text) for source in world.library())


@lru_cache(maxsize=16)
def _parsed(name: str, text: str) -> tree.Script:
    diagnostics = Diagnostics()
    script = parse(Source(name, text), diagnostics)
    if diagnostics.failed:
        raise AssertionError(f"the library does not parse: {diagnostics.items[0]}")
    return script
