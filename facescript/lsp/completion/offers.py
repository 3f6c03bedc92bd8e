"""What an author may write next, list by list: names, words, units, files; each compiles in its place."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from posixpath import dirname, relpath

from facescript.lsp.describe import definition_text, head_of, modifier_text, primitive_text, verb_text, word_text
from facescript.lsp.desk import OpenWorld
from facescript.lsp.vocabulary import crowd_size, kind_of_face, parameters_of, recipe
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.meanings import MUSCLES_DO, comment_of, first_sentence
from facescript.resolve.names import Definition
from facescript.resolve.project import Project
from facescript.resolve.units import EXAMPLES, SHARE, UNITS
from facescript.resolve.words import DIRECTIONS, PARTS, UNIT_NAME, UNSEEN, VALUE, VERBS, Modifier, Opener
from facescript.speech.model import VoiceFailure
from facescript.speech.voices.registry import engines
from facescript.syntax import tree
from facescript.world import World

MOST_ENTRIES, DEEPEST = 2000, 4
"""Entries of folders that are looked at for names of files, and folders in each other."""


@dataclass(frozen=True, slots=True)
class Offer:
    """Something that may be written: `name` is shown, `text` is put in ("" for the name); `kind` is of what kind it
    is, `says` a few words about it. `more` is told where an author asks: Markdown, or a definition to describe."""

    name: str
    kind: str
    says: str = ""
    text: str = ""
    more: str | Definition = ""


def described(project: Project, offer: Offer) -> str:
    """All that is said of an offer, in Markdown."""
    return definition_text(project, offer.more) if isinstance(offer.more, Definition) else offer.more


def plain(names: Iterable[str], kind: str = "word", says: str = "") -> Iterator[Offer]:
    """Words of the language, with what they mean."""
    for name in names:
        more = word_text(name) or ""
        yield Offer(name, kind, says or more.partition(": ")[2], more=more)


def openers(rows: Mapping[str, Opener]) -> Iterator[Offer]:
    for row in rows.values():
        text = f"{row.name}:" if row.form == f"{row.name}:" else row.name
        yield Offer(text, "word", row.help, more=word_text(row.name) or "")


def verbs(names: Iterable[str]) -> Iterator[Offer]:
    for name in names:
        yield Offer(name, "verb", VERBS[name].help, more=verb_text(VERBS[name]))


def defined(project: Project, *kinds: str) -> Iterator[Offer]:
    """Definitions of these kinds."""
    for definition in project.names.all(*kinds):
        yield defined_as(definition, definition.name)


def defined_as(definition: Definition, text: str) -> Offer:
    return Offer(text, definition.kind, _says(definition), more=definition)


def _says(definition: Definition) -> str:
    return first_sentence(comment_of(definition.node.span)) or head_of(definition)


# ------------------------------------------------------------------------------------------------ what is looked at


def aims(project: Project, faces: Collection[str], looker: str, people: bool) -> Iterator[Offer]:
    """What can be looked at by one of the faces of a scene."""
    yield from plain(("camera",))
    if people:
        yield Offer("people.nearest", "word", "the nearest person who is there")
    for definition in project.names.all("target"):
        size = crowd_size(definition)
        members = (f".{each}" for each in ("nearest", *range(1, min(size, 9) + 1))) if size else ("",)
        yield from (defined_as(definition, f"{definition.name}{member}") for member in members)
    for definition in project.names.all("face"):
        if definition.name in faces and definition.name != looker and kind_of_face(definition) != UNSEEN:
            yield defined_as(definition, definition.name)
            yield from (defined_as(definition, f"{definition.name}.{part}") for part in PARTS)


def crowds(project: Project, people: bool) -> Iterator[Offer]:
    if people:
        yield from plain(("people",))
    yield from (defined_as(each, each.name) for each in project.names.all("target") if crowd_size(each))


def directions(taken: Collection[str] = ()) -> Iterator[Offer]:
    """Directions that may be joined to those that are there: one aside, one up or down."""
    for pair in (DIRECTIONS[:2], DIRECTIONS[2:]):
        if not set(pair) & set(taken):
            yield from plain(pair)


# ------------------------------------------------------------------------------------------------ sums


def terms(project: Project, word: str) -> Iterator[Offer]:
    """What a sum is of; sides only where the word that is being written goes that far."""
    yield from plain(("neutral",))
    for definition in project.names.all("expression"):
        yield from _expression(project, definition, word)
    for name, primitive in PRIMITIVES.items():
        base = name.removesuffix(".left").removesuffix(".right")
        if base not in PRIMITIVES or base == name or word.startswith(f"{base}."):
            text = "" if primitive.kind == SHARE else f"{name} {EXAMPLES[primitive.kind]}"
            kind = "muscle" if base in MUSCLES_DO else "channel"
            yield Offer(name, kind, MUSCLES_DO.get(base, ""), text, primitive_text(name))


def _expression(project: Project, definition: Definition, word: str) -> Iterator[Offer]:
    name = definition.name
    says = _says(definition)
    if UNIT_NAME.fullmatch(name) and isinstance(definition.node, tree.ExpressionDefinition):
        says = f"{says}: {' '.join(definition.node.value.span.text.split())}"
    missing = [each for each in parameters_of(definition) if each.default is None]
    text = f"{name}({', '.join('50%' for _ in missing)})" if missing else ""
    yield Offer(name, "expression", says, text, definition)
    if word.startswith(f"{name}.") and not missing:
        for side in ("left", "right"):
            if recipe(project, definition, side):
                yield Offer(f"{name}.{side}", "expression", says, more=definition)


# ------------------------------------------------------------------------------------------------ modifiers


def modifiers(rows: Iterable[Modifier], taken: Collection[str], direct: bool) -> Iterator[Offer]:
    """Modifiers that may follow, by their leading words; `taken` are the names and groups that are there."""
    for row in rows:
        lead = row.pattern[: row.pattern.index(VALUE)] if VALUE in row.pattern else row.pattern
        if lead and row.direct == direct and not {row.name, row.group} & set(taken):
            yield Offer(" ".join(lead), "modifier", row.help, more=modifier_text(row))


def units(number: str, kind: str) -> Iterator[Offer]:
    """A number with each unit that fits a kind of quantity, "" for any."""
    for unit, row in UNITS.items():
        if not kind or row.kind == kind:
            yield Offer(f"{number}{unit}", "unit", row.called)


# ------------------------------------------------------------------------------------------------ voices and files


def voices(said: tuple[str, ...]) -> Iterator[Offer]:
    """What may stand behind `voice` and the words that are there: a language, a variant or an engine, its voice."""
    seen = set(said)
    for words, meaning in _voices():
        variant = meaning == VARIANT
        if variant and len(said) == 1:
            words = (*said, *words)
        if (variant and not said) or len(words) <= len(said) or words[: len(said)] != said:
            continue
        word = words[len(said)]
        if word not in seen and _WORD.fullmatch(word):
            seen.add(word)
            yield Offer(word, "voice", meaning)
    if len(said) == 1:
        yield from (Offer(sex, "voice", f"a {sex} voice") for sex in ("female", "male") if sex not in seen)


VARIANT = "variant"
"""What engines say a voice is that goes with every language."""

_WORD = re.compile(r'[A-Za-z][\w-]*|"[^"]*"')


@lru_cache(maxsize=1)
def _voices() -> tuple[tuple[tuple[str, ...], str], ...]:
    """All voices of this machine by their words; asked once, for it starts the engines."""
    found: list[tuple[tuple[str, ...], str]] = []
    for row in engines().values():
        with suppress(VoiceFailure):
            found += [(tuple(name.split()), meaning) for name, meaning in row.load()(World(Path())).voices()]
    return tuple(found)


def files(world: OpenWorld, script: str, suffixes: tuple[str, ...]) -> Iterator[Offer]:
    """Files of the project with these suffixes, saved or open, as the script would name them."""
    for name in dict.fromkeys((*world.opened(), *_found(world.root))):
        if name != script and name.casefold().endswith(suffixes):
            yield Offer(relpath(name, dirname(script) or "."), "file")


def _found(root: Path) -> Iterator[str]:
    """The names of files below a folder, nearest first; hidden ones and links are left out."""
    waiting = [(root, 0)]
    seen = 0
    while waiting and seen < MOST_ENTRIES:
        folder, depth = waiting.pop(0)
        with suppress(OSError), os.scandir(folder) as entries:
            for entry in sorted(entries, key=lambda entry: entry.name)[: MOST_ENTRIES - seen]:
                seen += 1
                if entry.name.startswith(".") or entry.is_symlink():
                    continue
                if entry.is_file():
                    yield Path(entry.path).relative_to(root).as_posix()
                elif depth < DEEPEST:
                    waiting.append((Path(entry.path), depth + 1))
