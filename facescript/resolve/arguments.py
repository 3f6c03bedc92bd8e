"""Arguments to parameters: of expressions in brackets, of actions behind their name and by modifiers."""

from __future__ import annotations

from collections.abc import Sequence

from facescript.resolve.project import Project
from facescript.resolve.scope import GLOBAL, Binding, Closure, Scope, Unknown
from facescript.syntax.tree import Name, Parameter, Word
from facescript.text import Span

Given = tuple[Name | None, tuple[Word, ...], Span]
"""An argument: its name where one is written, its words, its span."""


def bind(
    project: Project,
    parameters: tuple[Parameter, ...],
    given: Sequence[Given],
    scope: Scope,
    span: Span,
    called: str,
) -> Scope:
    """The scope of a definition's body: each parameter bound to an argument, or to its default. Raises `Refused`."""
    bindings: dict[str, Binding] = {}
    known = [parameter.name.text for parameter in parameters]
    for place, (name, words, where) in enumerate(given):
        if name is not None and name.text not in known:
            clause, fixes = project.meant(name.text, known, name.span)
            raise project.refuse("FS216", name.span, fixes=fixes, name=name.text, called=called, meant=clause)
        if name is None and place >= len(known):
            raise project.refuse("FS218", where, text=where.text, called=called, count=_counted(len(known)))
        target = name.text if name is not None else known[place]
        if target in bindings:
            raise project.refuse("FS310", where, name=target)
        bindings[target] = Closure(words, scope)
    for parameter in parameters:
        if parameter.name.text not in bindings:
            if parameter.default is None:
                raise project.refuse("FS217", span, name=parameter.name.text, called=called)
            bindings[parameter.name.text] = Closure(parameter.default.words, GLOBAL)
    return Scope(bindings)


def unbound(parameters: tuple[Parameter, ...]) -> Scope:
    """A scope to check a body in that nobody calls: defaults where there are, else nothing known."""
    return Scope(
        {
            parameter.name.text: Unknown() if parameter.default is None else Closure(parameter.default.words, GLOBAL)
            for parameter in parameters
        }
    )


def _counted(count: int) -> str:
    return {0: "no argument", 1: "one argument"}.get(count, f"{count} arguments")
