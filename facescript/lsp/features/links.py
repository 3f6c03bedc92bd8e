"""A document to its links: the files of the project that it names, and the addresses that it gives."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from lsprotocol import types
from pygls.uris import from_fs_path

from facescript.lsp.desk import Analysis
from facescript.lsp.places import range_of
from facescript.lsp.server import FaceServer
from facescript.lsp.walk import Node, inside, phrases
from facescript.resolve.files import project_path
from facescript.syntax import tree
from facescript.text import Span
from facescript.world import WorldFailure

BEFORE_FILES = frozenset(("from", "timed", "ssml", "text", "background", "picture", "play", "in", "piper"))
"""Words behind which a text in quotes names a file."""

ADDRESSES = ("https://", "http://", "mailto:")
"""How an address begins that an editor may open; others, such as `command:`, might do anything there."""


def links(analysis: Analysis) -> list[types.DocumentLink]:
    """In the order written; a file that is not there has none."""
    found = []
    for node in analysis.compiled.script.items:
        for string, is_file in _named(node):
            target = _file(analysis, string) if is_file else _address(string)
            if target:
                within = Span(string.span.source, string.span.start + 1, string.span.end - 1)
                found.append(types.DocumentLink(range_of(within), target))
    return found


def _named(node: Node) -> Iterator[tuple[tree.String, bool]]:
    """The texts in quotes that are paths, or (False) addresses."""
    if isinstance(node, tree.Use):
        yield node.path, True
    for phrase in phrases(node):
        for before, word in pairwise(phrase.words):
            if isinstance(word, tree.String) and isinstance(before, tree.Name):
                if before.text in BEFORE_FILES:
                    yield word, True
                elif before.text == "link":
                    yield word, False
    for inner in inside(node):
        yield from _named(inner)


def _address(string: tree.String) -> str | None:
    return string.value if string.value.startswith(ADDRESSES) else None


def _file(analysis: Analysis, string: tree.String) -> str | None:
    name = project_path(string.span, string.value)
    if not analysis.world.exists(name):
        return None
    try:
        uri: str | None = from_fs_path(str(analysis.world.path(name)))
    except WorldFailure:
        return None
    return uri


def register(server: FaceServer) -> None:
    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_LINK)
    def asked(_: FaceServer, params: types.DocumentLinkParams) -> list[types.DocumentLink]:
        return links(server.desk.analysis(params.text_document.uri))
