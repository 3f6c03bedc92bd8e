"""The files of an EPUB by their names, and text as its XML may hold it."""

from __future__ import annotations

from html import escape

from facescript.backends.svg.document import UNFIT

HEAD = '<?xml version="1.0" encoding="utf-8"?>\n'

COVER, STYLE, NAVIGATION, PACKAGE = "cover.png", "style.css", "nav.xhtml", "package.opf"


def page(number: int) -> str:
    """The text of a chapter, counted from 1."""
    return f"chapter-{number:03d}.xhtml"


def overlay(number: int) -> str:
    """When each word of a chapter is read."""
    return f"chapter-{number:03d}.smil"


def sound(number: int) -> str:
    return f"chapter-{number:03d}.mp3"


def face(number: int) -> str:
    """The picture of the faces at the head of a chapter."""
    return f"face-{number:03d}.png"


def told(text: str) -> str:
    """A text as it stands in XML, in an attribute too."""
    return escape(UNFIT.sub("\ufffd", text))
