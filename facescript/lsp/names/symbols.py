"""The scripts of a project to what their names mean: each definition once, and all that mean it, over the files."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import islice
from pathlib import Path

from facescript.lsp.desk import OpenWorld
from facescript.lsp.names.elsewhere import elsewhere
from facescript.lsp.names.model import Local, Mention
from facescript.lsp.names.script import ScriptNames, names_in, names_of
from facescript.resolve.definitions import library_names
from facescript.resolve.files import project_path
from facescript.resolve.kinds.library import FOLDER, kind_names
from facescript.resolve.uses import library
from facescript.resolve.words import WORDS
from facescript.resources import folder
from facescript.syntax import tree
from facescript.text import Source, Span
from facescript.world import World, WorldFailure

MOST_SCRIPTS = 200
"""Scripts of one project in which names are sought."""

MOST_FOLDERS = 2_000
"""Folders in which scripts are sought."""


@dataclass(frozen=True, slots=True)
class Symbol:
    """What a name means: `span` is the name in its definition, `parameters` those of an expression or an action."""

    kind: str
    name: str
    span: Span
    library: bool = False
    parameters: tuple[tree.Parameter, ...] = ()

    @property
    def key(self) -> tuple[str, int]:
        """The same for what is one and the same: the file and the offset."""
        return self.span.source.name, self.span.start

    @property
    def is_local(self) -> bool:
        return self.kind in ("parameter", "row", "person", "label")


class ProjectNames:
    """The names of a project; of the script `own` the tree is known already."""

    def __init__(self, world: OpenWorld, own: tree.Script | None = None) -> None:
        self.world = world
        self.own = own
        self._scripts: dict[str, ScriptNames | None] = {own.source.name: names_of(own)} if own is not None else {}
        self._written: dict[str, dict[str, Symbol]] = {}
        self._roots: dict[str, list[str]] = {}

    # -------------------------------------------------------------------------------------------- files

    def script(self, name: str) -> ScriptNames | None:
        """A script of the project or of the library; None where it cannot be read."""
        if name not in self._scripts:
            try:
                self._scripts[name] = names_in(self.world.source(name))
            except WorldFailure:
                found = _library_scripts().get(name)
                self._scripts[name] = names_of(found) if found is not None else None
        return self._scripts[name]

    @cached_property
    def found(self) -> tuple[tuple[str, ...], bool]:
        """The scripts in the project's folder by name, and whether these are all."""
        root = self.world.root.resolve()
        walk = (Path(top, file).relative_to(root).as_posix() for top, files in _folders(root) for file in files)
        open_ones = (name for name in self.world.opened() if name.endswith(".face"))
        own = [self.own.source.name] if self.own is not None else []
        names = list(dict.fromkeys((*own, *sorted(open_ones), *islice(walk, MOST_SCRIPTS + 1))))
        return tuple(names[:MOST_SCRIPTS]), len(names) <= MOST_SCRIPTS

    def closure(self, name: str) -> list[str]:
        """A script and all that it uses, directly or through others, in the order in which they are read."""
        found: dict[str, None] = {}
        waiting = [name]
        while waiting:
            one = waiting.pop()
            if one not in found:
                found[one] = None
                waiting += reversed(self._used(one))
        return [*(other for other in found if other != name), name]

    def _used(self, name: str) -> list[str]:
        """The scripts that a script uses itself, those that can be read."""
        script = self.script(name)
        uses = (item for item in script.script.items if isinstance(item, tree.Use)) if script else ()
        others = (project_path(item.path.span, item.path.value) for item in uses)
        return [other for other in others if self.script(other) is not None]

    def roots(self, name: str) -> list[str]:
        """The scripts that use one, directly or through others, and itself."""
        if name not in self._roots:
            self._roots[name] = [other for other in self.found[0] if other == name or name in self.closure(other)]
        return self._roots[name]

    def related(self, symbol: Symbol) -> list[str]:
        """The scripts that may mention a symbol."""
        if symbol.library:
            return list(dict.fromkeys((*self.found[0], *_library_scripts())))
        home = symbol.span.source.name
        if symbol.is_local and symbol.kind != "parameter":
            return [home]
        return list(dict.fromkeys([home, *(name for root in self.roots(home) for name in self.closure(root))]))

    # -------------------------------------------------------------------------------------------- meanings

    def written(self, name: str) -> dict[str, Symbol]:
        """The definitions that a script and what it uses bring; of two of one name the first."""
        if name not in self._written:
            found: dict[str, Symbol] = {}
            for other in self.closure(name):
                script = self.script(other)
                for symbol in definitions(script.script) if script else ():
                    found.setdefault(symbol.name, symbol)
            self._written[name] = found
        return self._written[name]

    def defined(self, name: str, where: str) -> Symbol | None:
        """What a name of the shared space means in a script: by itself, by the library, or by those that use it."""
        symbol = self.written(where).get(name) or library_symbols().get(name)
        if symbol is not None or name in WORDS:
            return symbol
        others = (self.written(root).get(name) for root in self.roots(where))
        return next((found for found in others if found is not None), None)

    def symbol(self, mention: Mention, where: str) -> Symbol | None:
        """What a mention in a script means; None where nothing is defined that it could mean."""
        if mention.local is not None:
            return None if mention.space != "name" else local_symbol(mention.local)
        if mention.defines:
            symbol = self.written(where).get(mention.name) if mention.space == "name" else None
            same = symbol is not None and symbol.key == (mention.span.source.name, mention.span.start)
            return symbol if same else Symbol(mention.defines, mention.name, mention.span)
        if mention.space == "name":
            return self.defined(mention.name, where)
        if mention.space == "kind":
            return self._kind(mention.name, where)
        return self._argument(mention, where) if mention.space == "argument" else None

    def _kind(self, name: str, where: str) -> Symbol | None:
        symbol = self.written(where).get(name)
        return symbol if symbol is not None and symbol.kind == "kind" else _library_kind(name)

    def _argument(self, mention: Mention, where: str) -> Symbol | None:
        owner = self.defined(mention.owner, where)
        parameters = owner.parameters if owner is not None else ()
        names = (parameter.name for parameter in parameters if parameter.name.text == mention.name)
        name = next(names, None)
        library = owner is not None and owner.library
        return Symbol("parameter", name.text, name.span, library) if name is not None else None

    def mentions(self, symbol: Symbol) -> Iterator[Mention]:
        """All places that mean a symbol, its definition among them."""
        for name in self.related(symbol):
            script = self.script(name)
            for mention in self._candidates(script, symbol) if script else ():
                found = self.symbol(mention, name)
                if found is not None and found.key == symbol.key:
                    yield mention

    def _candidates(self, script: ScriptNames, symbol: Symbol) -> Iterator[Mention]:
        yield from script.named(symbol.name)
        if not symbol.is_local:
            yield from (mention for mention in elsewhere(self.world, script) if mention.name == symbol.name)


def _folders(root: Path) -> Iterator[tuple[str, list[str]]]:
    """The folders of a project, hidden ones left out, and the names of the scripts in each."""
    for top, folders, files in islice(os.walk(root), MOST_FOLDERS):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name.isprintable())
        yield top, sorted(name for name in files if name.endswith(".face") and name.isprintable())


def local_symbol(local: Local) -> Symbol:
    return Symbol(local.kind, local.name, local.span)


def definitions(script: tree.Script) -> list[Symbol]:
    """The definitions of the shared space in a script."""
    found = []
    for item in script.items:
        if isinstance(item, tree.ExpressionDefinition | tree.ActionDefinition):
            kind = "expression" if isinstance(item, tree.ExpressionDefinition) else "action"
            found.append(Symbol(kind, item.name.text, item.name.span, False, item.parameters))
        elif isinstance(item, tree.LetDefinition | tree.Declaration):
            kind = item.kind if isinstance(item, tree.Declaration) else "let"
            found.append(Symbol(kind, item.name.text, item.name.span))
    return found


@cache
def _library_scripts() -> dict[str, tree.Script]:
    return {script.source.name: script for script in library(World(Path()))}


@cache
def library_symbols() -> dict[str, Symbol]:
    """The library's definitions by name."""
    names = library_names(_library_scripts().values())
    return {
        found.name: Symbol(found.kind, found.name, found.span, True, getattr(found.node, "parameters", ()))
        for found in names.library.values()
    }


@cache
def _library_kind(name: str) -> Symbol | None:
    """A kind of face of the library; its file is not read as a script, for it is long and only its name is asked."""
    if name not in kind_names():
        return None
    source = Source(f"stdlib/{FOLDER}/{name}.face", library_path(f"stdlib/{FOLDER}/{name}.face").read_text("utf-8"))
    start = source.text.index(f"kind {name} ") + len("kind ")
    return Symbol("kind", name, Span(source, start, start + len(name)), True)


def library_path(name: str) -> Path:
    """The file of the library that a source is, by the source's name."""
    return folder("stdlib") / name.removeprefix("stdlib/")
