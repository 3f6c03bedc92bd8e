"""`picture` and `link` to acts: what stands beside the faces in a book."""

from __future__ import annotations

import re
from urllib.parse import urlsplit

from facescript.ir.acts import AddLink, SetPicture
from facescript.resolve.lines import Line
from facescript.resolve.pictures import picture_path
from facescript.resolve.place import Place
from facescript.resolve.project import Project, Refused
from facescript.resolve.reader import Reader
from facescript.resolve.scope import expand, inside
from facescript.resolve.suggest import replace
from facescript.resolve.sums import left_over
from facescript.resolve.texts import bare_text
from facescript.resolve.words import NOTHING
from facescript.syntax.tree import Dotted, Name, String
from facescript.text import Span

LARGEST = 16 * 1024 * 1024
"""Bytes of a picture beside a face: pages and books carry it as it is."""

LONGEST_ADDRESS = 2000
"""Characters of a link's address."""

UNFIT = re.compile(r"[\s\x00-\x20\x7f<>\"\\^`{|}]")
"""What no address may hold (RFC 3986)."""

BARE = re.compile(r"(?:www\.|[\w-]+(?:\.[\w-]+)*\.(?:com|org|net|edu|gov|io|tw|cn|de|uk)(?:/|$))", re.IGNORECASE)
"""How an address begins that has lost its `https://`."""


def picture(project: Project, line: Line, place: Place) -> SetPicture:
    reader = line.reader()
    reader.next()
    if reader.word(NOTHING):
        line.finish(reader)
        return SetPicture(None)
    path, span = _text(project, reader, 'it is written `picture "PICTURE"` or `picture none`')
    found = picture_path(project, path, span, LARGEST)
    caption = _text(project, reader, "a caption is a text in quotes")[0] if reader.peek() is not None else ""
    line.finish(reader)
    return SetPicture(found, caption)


def link(project: Project, line: Line, place: Place) -> AddLink:
    reader = line.reader()
    reader.next()
    address, span = _text(project, reader, 'it is written `link "ADDRESS" "TEXT"`')
    _check(project, address, span)
    text = _text(project, reader, "the words of a link are a text in quotes")[0] if reader.peek() is not None else ""
    line.finish(reader)
    return AddLink(address, text or address)


def _check(project: Project, address: str, span: Span) -> None:
    """Refuses what is no address that may be opened from a page."""
    reason = _fault(address)
    if reason:
        bare = BARE.match(address) and not _fault(f"https://{address}")
        fixes = (replace(span, f'"https://{address}"'),) if bare and span.text == f'"{address}"' else ()
        raise project.refuse("FS535", span, fixes=fixes, address=address, reason=reason)


def _fault(address: str) -> str:
    """Why a text is no address of a link, nothing where it is one."""
    if len(address) > LONGEST_ADDRESS:
        return f"it has more than {LONGEST_ADDRESS} characters"
    if UNFIT.search(address):
        return "a space or another sign in it can stand in no address"
    try:
        parts = urlsplit(address)
    except ValueError:
        return "it is no address"
    if parts.scheme == "mailto":
        return "" if "@" in parts.path else "behind `mailto:` stands no one's address"
    if parts.scheme not in ("http", "https"):
        return "it begins with none of `https://`, `http://` and `mailto:`"
    return "" if parts.hostname else f"behind `{parts.scheme}://` stands no name of a place"


def _text(project: Project, reader: Reader, advice: str) -> tuple[str, Span]:
    """A text in quotes, or the one that a name or a cell stands for, and where it is written. Raises `Refused`."""
    word = reader.next()
    if isinstance(word, String):
        return bare_text(word), word.span
    expansion = expand(project, word, reader.scope) if isinstance(word, Name | Dotted) else None
    if word is None or expansion is None:
        raise _no_text(project, word.span if word is not None else reader.span, advice)
    if expansion.cell is not None:
        return expansion.cell.text.strip(), word.span
    with inside(project, expansion, word.span):
        inner = Reader(expansion.words, expansion.scope, word.span)
        found = _text(project, inner, advice)
        left_over(project, inner)
        return found[0], word.span


def _no_text(project: Project, span: Span, advice: str) -> Refused:
    return project.refuse("FS312", span, text=span.text, advice=advice)
