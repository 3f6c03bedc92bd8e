"""A project's actions to who calls them: other actions, scenes, reactions, and the lines of a script without scenes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from facescript.lsp.names.model import Mention
from facescript.lsp.names.script import ScriptNames
from facescript.lsp.names.symbols import ProjectNames, Symbol
from facescript.syntax import tree
from facescript.text import Span


@dataclass(frozen=True, slots=True)
class Caller:
    """What calls actions: `kind` is action, scene, reaction or script; `head` is its name, `span` the whole of it."""

    kind: str
    name: str
    head: Span
    span: Span


def caller_at(script: ScriptNames, start: int) -> Caller:
    """The action, the scene or the reaction around an offset, else the script itself."""
    for item in script.script.items:
        if item.span.start <= start < item.span.end:
            return _caller(item) or _lines(script)
    return _lines(script)


def _caller(item: tree.Item) -> Caller | None:
    if isinstance(item, tree.ActionDefinition):
        return Caller("action", item.name.text, item.name.span, item.span)
    if isinstance(item, tree.Scene):
        return Caller("scene", item.name.text, item.name.span, item.span)
    if isinstance(item, tree.When):
        return Caller("reaction", f"when {item.event.span.text}", item.event.span, item.span)
    return None


def _lines(script: ScriptNames) -> Caller:
    """A script whose lines stand in no block of a name."""
    source = script.source
    return Caller("script", source.name, Span(source, 0, 0), Span(source, 0, len(source.text)))


def callers(names: ProjectNames, action: Symbol) -> dict[Caller, list[Span]]:
    """Who calls an action, and where."""
    found: dict[Caller, list[Span]] = {}
    for mention in names.mentions(action):
        script = names.script(mention.span.source.name)
        if script is not None and not mention.defines:
            found.setdefault(caller_at(script, mention.span.start), []).append(mention.span)
    return found


def called(names: ProjectNames, script: ScriptNames, caller: Caller) -> dict[Symbol, list[Span]]:
    """The actions that something calls, and where it does."""
    found: dict[Symbol, list[Span]] = {}
    for mention in _inside(script, caller):
        symbol = names.symbol(mention, script.source.name) if mention.space == "name" and not mention.defines else None
        if symbol is not None and symbol.kind == "action":
            found.setdefault(symbol, []).append(mention.span)
    return found


def _inside(script: ScriptNames, caller: Caller) -> Iterator[Mention]:
    for index, item in enumerate(script.script.items):
        own = _caller(item)
        if own == caller or (own is None and caller.kind == "script"):
            yield from script.of(index)
