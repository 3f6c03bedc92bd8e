"""The definitions of a script, of what it uses and of the library into one space of names."""

from __future__ import annotations

from collections.abc import Iterable

from facescript.diagnostics.model import Related
from facescript.resolve.names import Definition, Names
from facescript.resolve.project import Project
from facescript.resolve.words import WORDS
from facescript.syntax import tree

KINDS: dict[type, str] = {
    tree.ExpressionDefinition: "expression",
    tree.ActionDefinition: "action",
    tree.LetDefinition: "let",
}


def _kind(node: object) -> str | None:
    return node.kind if isinstance(node, tree.Declaration) else KINDS.get(type(node))


def library_names(scripts: Iterable[tree.Script]) -> Names:
    """The library's names, not yet used by anybody."""
    names = Names()
    for script in scripts:
        for node in script.items:
            kind = _kind(node)
            if kind is not None:
                name = node.name  # type: ignore[union-attr]
                names.library[name.text] = Definition(kind, name.text, node, name.span, library=True, own=False)  # type: ignore[arg-type]
    return names


def collect(project: Project, script: tree.Script, *, own: bool) -> None:
    """Adds a script's definitions; names that are taken, and words of the language, are reported."""
    for node in script.items:
        kind = _kind(node)
        if kind is not None:
            _add(project, kind, node, own)  # type: ignore[arg-type]


def _add(
    project: Project,
    kind: str,
    node: tree.ExpressionDefinition | tree.ActionDefinition | tree.LetDefinition | tree.Declaration,
    own: bool,
) -> None:
    name = node.name
    if name.text in WORDS:
        _refuse(project, kind, name)
        return
    earlier = project.names.written.get(name.text)
    if earlier is not None:
        related = (Related(earlier.span, f"it is {_article(earlier.kind)} here already"),)
        project.report("FS208", name.span, related=related, name=name.text)
        return
    covered = project.names.library.get(name.text)
    if covered is not None:
        project.report("FS210", name.span, name=name.text, kind=covered.kind)
    project.names.written[name.text] = Definition(kind, name.text, node, name.span, own=own)
    if isinstance(node, tree.ExpressionDefinition | tree.ActionDefinition):
        _parameters(project, node.parameters)


def _refuse(project: Project, kind: str, name: tree.Name) -> None:
    """Refuses a word of the language as a name, so that no more is said where it is used."""
    if kind == "action":
        project.refuse_word(name.span)
        return
    project.report("FS209", name.span, name=name.text)
    project.spoilt[name.text] = True


def _parameters(project: Project, parameters: tuple[tree.Parameter, ...]) -> None:
    seen: dict[str, tree.Name] = {}
    for parameter in parameters:
        name = parameter.name
        if name.text in WORDS:
            project.refuse_word(name.span)
        elif name.text in seen:
            related = (Related(seen[name.text].span, "it is a parameter here already"),)
            project.report("FS208", name.span, related=related, name=name.text)
        seen[name.text] = name


def _article(kind: str) -> str:
    return f"an {kind}" if kind[0] in "ae" else f"a {kind}"
