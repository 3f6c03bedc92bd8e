"""The labels of a scope, gathered before its statements are read, so that a name may be used before its line."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.diagnostics.model import Related
from facescript.resolve.project import Project
from facescript.resolve.scope import Labels
from facescript.resolve.words import WORDS
from facescript.syntax import tree


def gather(project: Project, body: tuple[tree.Statement, ...], prefix: str, parent: Labels | None = None) -> Labels:
    """The labels of a scene, an action, a reaction or a pass of a repeat; names that are taken are reported."""
    labels = Labels(prefix, parent=parent)
    for name in named(body):
        _declare(project, labels, name)
    project.notes.labelled |= bool(labels.names)
    return labels


def gather_all(project: Project, body: tuple[tree.Statement, ...]) -> Labels:
    """The labels of a script without scenes."""
    labels = Labels("", project.memo.table(project, "labels"))
    for name in project.memo.follow(body, _named_in):
        _declare(project, labels, name)
    project.memo.settle(labels.names)
    return labels


def _declare(project: Project, labels: Labels, name: tree.Name) -> None:
    if name.text in WORDS:
        project.refuse_word(name.span)
        return
    earlier = labels.names.get(name.text)
    if earlier is None:
        definition = project.names.written.get(name.text)
        earlier = definition.span if definition is not None else None
        if earlier is None:
            labels.names[name.text] = name.span
    if earlier is not None and earlier != name.span:
        project.report("FS208", name.span, related=(Related(earlier, "it is here already"),), name=name.text)
    elif name.text in project.names.library:
        project.report("FS210", name.span, name=name.text, kind=project.names.library[name.text].kind)


def check_free(project: Project, name: tree.Name) -> None:
    """Refuses a name for a pass's row or for a person that is a word of the language or is defined already."""
    if name.text in WORDS:
        raise project.refuse_word(name.span)
    definition = project.names.written.get(name.text)
    if definition is not None:
        related = (Related(definition.span, "it is here already"),)
        raise project.refuse("FS208", name.span, related=related, name=name.text)


def named(body: tuple[tree.Statement, ...]) -> Iterator[tree.Name]:
    """The names given with `as` in a block; a repeat's own belong to its passes."""
    for statement in body:
        if isinstance(statement, tree.Act):
            yield from label(statement.phrases)
            for on in statement.ons:
                yield from named(on.body)
        elif not isinstance(statement, tree.Repeat):
            yield from named(statement.body)


def _named_in(statement: tree.Statement) -> tuple[tree.Name, ...]:
    return tuple(named((statement,)))


def label(phrases: tuple[tree.Phrase, ...]) -> Iterator[tree.Name]:
    """The name that a line gives itself with `as`, where it does."""
    for phrase in phrases:
        words = phrase.words
        for index in range(1 if phrase is phrases[0] else 0, len(words) - 1):
            word, name = words[index], words[index + 1]
            if isinstance(word, tree.Name) and word.text == "as" and isinstance(name, tree.Name):
                yield name
                return
