"""`facescript list`: what there is, a line each, as names and what they mean; and the texts made for programs."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Iterable
from pathlib import Path

from facescript.backends.registry import backends
from facescript.diagnostics.model import Diagnostics
from facescript.performance.channels import CHANNELS, MUSCLES
from facescript.resolve.kinds.library import kind_names, kinds_with, library_head
from facescript.resolve.meanings import FACES, MUSCLES_DO, comment_of, first_sentence
from facescript.resolve.words import UNSEEN, VERBS, WORDS
from facescript.resources import folder
from facescript.speech.model import VoiceFailure
from facescript.speech.voices.registry import engines
from facescript.syntax.parser import parse
from facescript.syntax.tree import ActionDefinition, Declaration, ExpressionDefinition, Item
from facescript.world import World

Row = tuple[str, str]


def run(options: argparse.Namespace) -> int:
    """Two columns on standard output, in the order of the thing listed; a text as it is."""
    if options.what in TEXTS:
        print(TEXTS[options.what](), end="")
        return 0
    rows = list(LISTS[options.what]())
    width = max((len(name) for name, _ in rows), default=0)
    for name, meaning in rows:
        print(f"{name:{width}}  {meaning}".rstrip())
    return 0


def _library() -> Iterable[Item]:
    """The items of the standard library."""
    for source in World(Path.cwd()).library():
        yield from parse(source, Diagnostics()).items


def _expressions() -> Iterable[Row]:
    for item in _library():
        if isinstance(item, ExpressionDefinition):
            yield item.name.text, " ".join(item.value.span.text.split())


def _actions() -> Iterable[Row]:
    for verb in VERBS.values():
        yield verb.form, verb.help
    for item in _library():
        if isinstance(item, ActionDefinition):
            parameters = "".join(f", {parameter.span.text}" for parameter in item.parameters)
            yield f"{item.name.text}{parameters.replace(',', '', 1)}", first_sentence(comment_of(item.span))


def _lives() -> Iterable[Row]:
    for item in _library():
        if isinstance(item, Declaration) and item.kind == "life":
            yield item.name.text, ", ".join(phrase.span.text for phrase in item.phrases)


def _faces() -> Iterable[Row]:
    for kind in (*kind_names(), UNSEEN):
        yield kind, FACES[kind]


def _looks() -> Iterable[Row]:
    """What each kind of face may choose from: choices, amounts, colours that have a name."""
    for kind in kind_names():
        head = library_head(kind)
        tints = {family: [tint.name for tint in found] for family, found in head.tints}
        for name, choices in head.looks:
            yield f"{kind} {name}", ", ".join((*choices, *tints.pop(name, ())))
        for name, colours in tints.items():
            yield f"{kind} {name}", ", ".join(colours)
        for name, usual in head.amounts:
            yield f"{kind} {name}", f"0% to 100%, {usual:.0%} as drawn"


def _muscles() -> Iterable[Row]:
    for muscle in MUSCLES:
        yield muscle, f"{MUSCLES_DO[muscle]}; `{muscle}.left` and `{muscle}.right` are its sides"


def _channels() -> Iterable[Row]:
    for channel in CHANNELS:
        kinds = ", ".join(kinds_with(channel.name))
        yield channel.name, f"{channel.unit}, {channel.rest:g} at rest" + (f"; only {kinds}" if kinds else "")


def _voices() -> Iterable[Row]:
    """What may stand behind `voice`, engine after engine; of one that cannot speak here, why."""
    for row in engines().values():
        try:
            yield from row.load()(World(Path.cwd())).voices()
        except VoiceFailure as failure:
            yield row.name, f"{row.help}; not here: {failure.args[0]}"


def _backends() -> Iterable[Row]:
    for backend in backends().values():
        yield backend.suffix, backend.help


def _words() -> Iterable[Row]:
    for word in sorted(WORDS):
        yield word, ""


LISTS: dict[str, Callable[[], Iterable[Row]]] = {
    "faces": _faces,
    "looks": _looks,
    "expressions": _expressions,
    "actions": _actions,
    "muscles": _muscles,
    "channels": _channels,
    "voices": _voices,
    "backends": _backends,
    "lives": _lives,
    "words": _words,
}


def _summary() -> str:
    return (folder("docs") / "summary.md").read_text("utf-8")


def _schema() -> str:
    from facescript.ir.json_form import schema  # pydantic: only the schema pays it

    return json.dumps(schema(), ensure_ascii=False, indent=2) + "\n"


TEXTS: dict[str, Callable[[], str]] = {"summary": _summary, "schema": _schema}
