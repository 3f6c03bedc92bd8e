"""A script to what its words mean to an editor: keyword, face, target, expression, and so on, by their texts.

The words come from the language's tables, the names from the script, from what it uses and from the library.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from enum import IntEnum
from functools import cache

from facescript.diagnostics.model import Diagnostics
from facescript.lsp.desk import Analysis
from facescript.lsp.walk import Node, inside, name_of
from facescript.performance.channels import CHANNELS
from facescript.resolve.definitions import library_names
from facescript.resolve.events import PERSONAL, TEXTUAL
from facescript.resolve.kinds.library import kind_names
from facescript.resolve.names import Names
from facescript.resolve.project import Project
from facescript.resolve.resolver import define
from facescript.resolve.uses import library
from facescript.resolve.words import EASES, FACE, FILM, MODIFIERS, UNSEEN, VALUE, WORDS
from facescript.syntax import tree


class Meaning(IntEnum):
    """What a word is; in the order of `offered.TOKEN_TYPES`."""

    KEYWORD = 0
    FACE = 1
    TARGET = 2
    EXPRESSION = 3
    ACTION = 4
    LABEL = 5
    SCENE = 6
    PARAMETER = 7
    LET = 8
    KIND = 9
    PROPERTY = 10
    STRING = 11
    NUMBER = 12
    COLOUR = 13
    COMMENT = 14
    OPERATOR = 15


DEFINED, CONSTANT, LIBRARY = 1, 2, 4
"""Bits of what else is so: it is defined here, it cannot change, it is the library's."""

Meant = tuple[Meaning, int]

OF_KIND: dict[str, Meant] = {
    "face": (Meaning.FACE, 0),
    "target": (Meaning.TARGET, 0),
    "expression": (Meaning.EXPRESSION, 0),
    "action": (Meaning.ACTION, 0),
    "let": (Meaning.LET, CONSTANT),
    "life": (Meaning.KIND, 0),
    "kind": (Meaning.KIND, 0),
}
"""What each kind of definition makes of its name."""


def meanings(analysis: Analysis) -> dict[str, Meant]:
    """What each word and each name of a document means wherever it stands, but for parameters."""
    names = _names(analysis)
    return {
        **_words(),
        **dict.fromkeys(_labels(analysis.compiled.script.items), (Meaning.LABEL, 0)),
        **{found.name: _meant(found.kind, found.library) for found in names.all(*OF_KIND)},
    }


def _meant(kind: str, of_library: bool) -> Meant:
    meaning, bits = OF_KIND[kind]
    return meaning, bits | (LIBRARY if of_library else 0)


def _names(analysis: Analysis) -> Names:
    """The names that a script may use; what is wrong with them is told elsewhere."""
    project = Project(analysis.world, Diagnostics(), library_names(library(analysis.world)))
    define(project, analysis.compiled.script)
    return project.names


def _labels(nodes: Iterable[Node]) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, tree.Act) and (name := name_of(node)) is not None:
            yield name.text
        yield from _labels(inside(node))


@cache
def _words() -> dict[str, Meant]:
    """The language's own words; those of modifiers may be names as well, and are then the names."""
    rows = (*MODIFIERS.values(), *FACE.values(), *FILM.values())
    own = {word for row in rows for word in row.pattern if word != VALUE}.union(EASES, TEXTUAL, PERSONAL)
    return {
        **dict.fromkeys(channel_parts(), (Meaning.PROPERTY, 0)),
        **dict.fromkeys((*own, *WORDS.difference(channel_parts())), (Meaning.KEYWORD, 0)),
        **dict.fromkeys((*kind_names(), UNSEEN), (Meaning.KIND, LIBRARY)),
    }


@cache
def channel_parts() -> frozenset[str]:
    """The first words of the names of channels and muscles: `brow`, `head`."""
    return frozenset(channel.name.partition(".")[0] for channel in CHANNELS)
