"""`picture` and `link` to acts: what stands beside the faces in a book."""

from __future__ import annotations

import re
from urllib.parse import urlsplit

from facescript.ir.acts import AddLink, SetPicture
from facescript.resolve.lines import Line
from facescript.resolve.pictures import picture_path
from facescript.resolve.place import Place
from facescript.resolve.project import Project
from facescript.resolve.quoted import quoted_text
from facescript.resolve.suggest import replace
from facescript.resolve.words import NOTHING
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
    path, span = quoted_text(project, reader, 'it is written `picture "PICTURE"` or `picture none`')
    found = picture_path(project, path, span, LARGEST)
    caption = quoted_text(project, reader, "a caption is a text in quotes")[0] if reader.peek() is not None else ""
    line.finish(reader)
    return SetPicture(found, caption)


def link(project: Project, line: Line, place: Place) -> AddLink:
    reader = line.reader()
    reader.next()
    address, span = quoted_text(project, reader, 'it is written `link "ADDRESS" "TEXT"`')
    _check(project, address, span)
    text = (
        quoted_text(project, reader, "the words of a link are a text in quotes")[0] if reader.peek() is not None else ""
    )
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
