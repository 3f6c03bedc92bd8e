"""The standard library as its pages need it: definitions of a kind, what is said of each, what an expression moves."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from facescript.diagnostics.model import Diagnostics
from facescript.lsp.vocabulary import recipe
from facescript.resolve.definitions import library_names
from facescript.resolve.meanings import comment_of
from facescript.resolve.names import Definition
from facescript.resolve.project import Project
from facescript.resolve.uses import library
from facescript.world import World


@cache
def project() -> Project:
    world = World(Path())
    return Project(world, Diagnostics(), library_names(library(world)))


def defined(kind: str) -> list[Definition]:
    """The library's definitions of a kind: `expression`, `action`, `life`; in their order."""
    return [each for each in project().names.library.values() if each.kind == kind]


def comment(definition: Definition) -> str:
    return comment_of(definition.node.span)


def written(definition: Definition) -> str:
    """As it stands in the library, on one line."""
    return " ".join(definition.node.span.text.partition("  #")[0].split())


def moves(definition: Definition) -> str:
    """What an expression drives in the end: `brow.inner 100% + ...`."""
    return recipe(project(), definition) or ""
