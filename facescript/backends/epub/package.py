"""A book's parts to the files that tell of them: the package document, the table of contents, the container."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from facescript.backends.epub import names
from facescript.backends.epub.names import HEAD, told

MODIFIED = "1980-01-01T00:00:00Z"
"""When it was made: the same always, as a book with other contents has another identifier."""

ACTIVE = "-epub-media-overlay-active"
"""The class that players give to what is read."""

CONTAINER = f"""{HEAD}<container version="1.0" xmlns="urn:oasis:names:tc:opendocument:xmlns:container">
<rootfiles>
<rootfile full-path="EPUB/{names.PACKAGE}" media-type="application/oebps-package+xml"/>
</rootfiles>
</container>
"""

OPEN = ("textual", "visual"), ("auditory", "textual", "visual")
"""The ways into a book without sound and with it (schema.org's `accessMode`)."""


@dataclass(frozen=True, slots=True)
class Item:
    """A file of the book; `overlay` is the id of what says when its words are read, `properties` what EPUB calls so."""

    id: str
    name: str
    kind: str
    properties: str = ""
    overlay: str = ""


@dataclass(frozen=True, slots=True)
class Description:
    """What is said of a book: `identifier` is its UUID, `durations` the seconds of each overlay by its item's id."""

    title: str
    author: str
    identifier: str
    languages: tuple[str, ...]
    durations: dict[str, float]


def package_document(book: Description, items: Sequence[Item], spine: Iterable[str]) -> str:
    """The package; `spine` are the ids of its pages in order."""
    manifest = "\n".join(_item(item) for item in items)
    order = "\n".join(f'<itemref idref="{page}"/>' for page in spine)
    return (
        f'{HEAD}<package xmlns="http://www.idpf.org/2007/opf" version="3.0" unique-identifier="id" '
        f'xml:lang="{told(book.languages[0])}">\n'
        f'<metadata xmlns:dc="http://purl.org/dc/elements/1.1/">\n{"".join(_metadata(book))}</metadata>\n'
        f"<manifest>\n{manifest}\n</manifest>\n<spine>\n{order}\n</spine>\n</package>\n"
    )


def navigation(title: str, language: str, chapters: Sequence[str]) -> str:
    """The table of contents: the titles of the chapters in order."""
    entries = "\n".join(
        f'<li><a href="{names.page(number)}">{told(chapter)}</a></li>' for number, chapter in enumerate(chapters, 1)
    )
    return (
        f'{HEAD}<!DOCTYPE html>\n<html xmlns="http://www.w3.org/1999/xhtml" '
        f'xmlns:epub="http://www.idpf.org/2007/ops" lang="{told(language)}" xml:lang="{told(language)}">\n'
        f"<head>\n<title>{told(title)}</title>\n"
        f'<link rel="stylesheet" type="text/css" href="{names.STYLE}"/>\n</head>\n<body>\n'
        f'<h1>{told(title)}</h1>\n<nav epub:type="toc" role="doc-toc" aria-label="{told(title)}">\n'
        f"<ol>\n{entries}\n</ol>\n</nav>\n</body>\n</html>\n"
    )


def _metadata(book: Description) -> Iterable[str]:
    yield f'<dc:identifier id="id">urn:uuid:{book.identifier}</dc:identifier>\n'
    yield f"<dc:title>{told(book.title)}</dc:title>\n"
    yield from (f"<dc:language>{told(language)}</dc:language>\n" for language in book.languages)
    if book.author:
        yield f"<dc:creator>{told(book.author)}</dc:creator>\n"
    yield _meta("dcterms:modified", MODIFIED)
    yield from (_meta("schema:accessMode", way) for way in OPEN[bool(book.durations)])
    yield _meta("schema:accessModeSufficient", "textual")
    yield _meta("schema:accessibilityFeature", "tableOfContents")
    yield _meta("schema:accessibilityHazard", "none")
    if book.durations:
        yield _meta("schema:accessibilityFeature", "synchronizedAudioText")
        yield _meta("media:active-class", ACTIVE)
        yield from (_meta("media:duration", _clock(long), f"#{item}") for item, long in book.durations.items())
        yield _meta("media:duration", _clock(sum(book.durations.values())))


def _meta(name: str, value: str, refines: str = "") -> str:
    of = f' refines="{refines}"' if refines else ""
    return f'<meta property="{name}"{of}>{value}</meta>\n'


def _clock(seconds: float) -> str:
    """`1:02:03.456`."""
    whole = round(seconds * 1000)
    return f"{whole // 3_600_000}:{whole // 60_000 % 60:02d}:{whole // 1000 % 60:02d}.{whole % 1000:03d}"


def _item(item: Item) -> str:
    properties = f' properties="{item.properties}"' if item.properties else ""
    overlay = f' media-overlay="{item.overlay}"' if item.overlay else ""
    return f'<item id="{item.id}" href="{item.name}" media-type="{item.kind}"{properties}{overlay}/>'
