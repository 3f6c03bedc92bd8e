"""A kind of the library, by its name, to the kind as data; read once."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from facescript.diagnostics.model import Diagnostics
from facescript.ir.kind import Kind, KindHead
from facescript.resolve.kinds.kind import head, kind
from facescript.resolve.names import Names
from facescript.resolve.project import Project
from facescript.resources import folder
from facescript.syntax.parser import parse
from facescript.syntax.tree import Declaration
from facescript.text import Source
from facescript.world import World

PEOPLE = ("woman", "man")

FOLDER = "faces"
"""Where the library's kinds lie, below the library, one file each."""


@cache
def kind_names() -> tuple[str, ...]:
    """The kinds of the library: people first, then the others in the order of their names."""
    names = {path.stem for path in (folder("stdlib") / FOLDER).glob("*.face")}
    return (*PEOPLE, *sorted(names.difference(PEOPLE)))


@cache
def library_kind(name: str) -> Kind:
    """A kind of the library. Raises KeyError where there is none."""
    return kind(*_parsed(name, _text(name)))


@cache
def library_head(name: str) -> KindHead:
    """What a face may choose of a kind of the library, from the rows above its shapes. Raises KeyError."""
    return head(*_parsed(name, _text(name).partition("\n    shape ")[0] + "\n"))


def kinds_with(channel: str) -> tuple[str, ...]:
    """The kinds of the library that have a channel, where not every face has it."""
    part = channel.partition(".")[0]
    return tuple(name for name in kind_names() if part in library_head(name).channels)


def _text(name: str) -> str:
    if name not in kind_names():
        raise KeyError(name)
    return (folder("stdlib") / FOLDER / f"{name}.face").read_text("utf-8")


def _parsed(name: str, text: str) -> tuple[Project, Declaration]:
    diagnostics = Diagnostics()
    script = parse(Source(f"stdlib/{FOLDER}/{name}.face", text), diagnostics)
    (node,) = (item for item in script.items if isinstance(item, Declaration) and item.kind == "kind")
    return Project(World(Path()), diagnostics, Names()), node
