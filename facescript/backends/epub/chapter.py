"""A chapter to its page of an EPUB: XHTML with an id for each word, and the pictures and links between the lines."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from facescript.backends.chapters import Beside, Chapter
from facescript.backends.epub.names import HEAD, STYLE, told
from facescript.backends.page.words import Line
from facescript.ir.acts import AddLink

TITLE = "title"
"""The id of a chapter's heading."""


@dataclass(frozen=True, slots=True)
class Setting:
    """What the pages of a book have in common: its language, the names of those who speak where they are several, and
    the files of its pictures by their paths in the project."""

    language: str
    speakers: Mapping[str, str]
    pictures: Mapping[str, str]


def chapter_page(chapter: Chapter, setting: Setting, face: str, seen: str) -> str:
    """The page; `face` is the file of a picture of the faces, `seen` who they are."""
    body = "\n".join(_body(chapter, setting))
    language = told(setting.language)
    return (
        f'{HEAD}<!DOCTYPE html>\n<html xmlns="http://www.w3.org/1999/xhtml" '
        f'xmlns:epub="http://www.idpf.org/2007/ops" lang="{language}" xml:lang="{language}">\n'
        f"<head>\n<title>{told(chapter.title)}</title>\n"
        f'<link rel="stylesheet" type="text/css" href="{STYLE}"/>\n</head>\n<body epub:type="bodymatter">\n'
        f'<section epub:type="chapter" role="doc-chapter" aria-labelledby="{TITLE}">\n'
        f'<h1 id="{TITLE}">{told(chapter.title)}</h1>\n'
        f'<figure class="face"><img src="{face}" alt="{told(seen)}"/></figure>\n'
        f"{body}\n</section>\n</body>\n</html>\n"
    )


def word_id(line: int, word: int) -> str:
    """The id of a word in its page; lines and words count from 1."""
    return f"w{line}-{word}"


def line_id(line: int) -> str:
    return f"l{line}"


def _body(chapter: Chapter, setting: Setting) -> Iterator[str]:
    for item in chapter.flow():
        yield _element(item, setting) if isinstance(item, Beside) else _paragraph(*item, setting)


def _element(beside: Beside, setting: Setting) -> str:
    if isinstance(beside.shown, AddLink):
        return f'<p class="link"><a href="{told(beside.shown.address)}">{told(beside.shown.text)}</a></p>'
    assert beside.shown.picture is not None
    source, caption = setting.pictures[beside.shown.picture], told(beside.shown.caption)
    below = f"<figcaption>{caption}</figcaption>" if caption else ""
    return f'<figure><img src="{source}" alt="{caption}"/>{below}</figure>'


def _paragraph(number: int, line: Line, setting: Setting) -> str:
    language = told(line.language)
    other = f' lang="{language}" xml:lang="{language}"' if line.language != setting.language else ""
    who = setting.speakers.get(line.face)
    speaker = f'<span class="who">{told(who)}</span> ' if who else ""
    return f'<p id="{line_id(number)}"{other}>{speaker}{"".join(_words(number, line))}</p>'


def _words(number: int, line: Line) -> Iterator[str]:
    """The text as it was written, with a span around each word."""
    at = 0
    for place, word in enumerate(line.words, start=1):
        yield told(line.text[at : word.first])
        yield f'<span id="{word_id(number, place)}">{told(line.text[word.first : word.last])}</span>'
        at = word.last
    yield told(line.text[at:])
