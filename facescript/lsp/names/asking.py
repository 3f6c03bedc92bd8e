"""A place in an editor to the name that stands there, and what it means to a place that an editor can open."""

from __future__ import annotations

from lsprotocol.types import Location, Position
from pygls.uris import from_fs_path

from facescript.lsp.desk import Analysis, Desk
from facescript.lsp.names.model import Mention
from facescript.lsp.names.script import names_of
from facescript.lsp.names.symbols import ProjectNames, Symbol, library_path
from facescript.lsp.places import offset, range_of
from facescript.text import Span
from facescript.world import World, WorldFailure


def asked(desk: Desk, uri: str) -> Analysis | None:
    """A document as it stands; None for one that is neither open nor a file."""
    try:
        return desk.analysis(uri)
    except (OSError, TypeError, ValueError):
        return None


def mention_at(analysis: Analysis, place: Position) -> Mention | None:
    """The name at a position of the document."""
    return names_of(analysis.compiled.script).at(offset(analysis.source, place))


def symbol_at(analysis: Analysis, place: Position) -> tuple[ProjectNames, Symbol] | None:
    """What the name at a position means, and the project that it is of."""
    mention = mention_at(analysis, place)
    if mention is None:
        return None
    names = ProjectNames(analysis.world, analysis.compiled.script)
    symbol = names.symbol(mention, analysis.source.name)
    return (names, symbol) if symbol is not None else None


def location(analysis: Analysis, span: Span) -> Location | None:
    """Where a span is, in the project or in the library."""
    uri = analysis.uri_of(span.source)
    if uri is None:
        path = library_path(span.source.name)
        uri = from_fs_path(str(path)) if path.is_file() else None
    return Location(uri, range_of(span)) if uri is not None else None


def uri_in(world: World, name: str) -> str | None:
    """The address of a file of a project."""
    try:
        return from_fs_path(str(world.path(name))) or None
    except WorldFailure:
        return None
