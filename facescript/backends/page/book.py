"""A job to the page of a book: chapters to go to, text beside the faces, pictures and links at their time."""

from __future__ import annotations

import base64
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from html import escape
from urllib.parse import quote

from facescript.backends.chapters import Beside, Chapter, chapters, pictures, speakers
from facescript.backends.job import Job
from facescript.backends.page.document import Page, assembled, placeholders, resource, titled
from facescript.backends.page.words import clock, paragraph
from facescript.ir.acts import AddLink


def book_page(job: Job, folder: str) -> Page:
    """The page; with a `folder`, its pictures, too, are files of that folder. Raises `JobFailure`."""
    found = chapters(job)
    addresses, files = _pictures(job, found, folder)
    parts = placeholders(job, [line for chapter in found for line in chapter.lines])
    ratio = job.stage.width / job.stage.height
    text = "\n".join(["", _head(job, found), *_sections(found, addresses), ""])
    parts |= {"ratio": f"{ratio:.4f}", "text": _TEXT.format(text)}
    made = assembled(job, resource("book.html"), parts, folder, [resource("book.js")])
    return replace(made, files={**made.files, **files})


_TEXT = '<div class="fs-text" data-facescript="text" role="region" aria-label="Text" tabindex="0">{}</div>'


def _pictures(job: Job, found: Sequence[Chapter], folder: str) -> tuple[dict[str, str], dict[str, bytes]]:
    """The addresses of the pictures by their paths in the project, and the files that they are."""
    addresses: dict[str, str] = {}
    files: dict[str, bytes] = {}
    for number, (path, data, kind) in enumerate(pictures(job, found), start=1):
        name = f"picture-{number}.{kind.partition('/')[2]}"
        if folder:
            addresses[path], files[name] = f"{quote(folder)}/{name}", data
        else:
            addresses[path] = f"data:{kind};base64,{base64.b64encode(data).decode('ascii')}"
    return addresses, files


def _head(job: Job, found: Sequence[Chapter]) -> str:
    """The title, who wrote it, and the chapters to go to."""
    author = job.score.film.author
    said = f'<p class="fb-author">{escape(author)}</p>\n' if author else ""
    entries = "\n".join(
        f'<li><a href="#chapter-{number}" data-start="{chapter.start:.3f}">'
        f'<bdi>{escape(chapter.title)}</bdi><span class="fb-time">{clock(chapter.start)}</span></a></li>'
        for number, chapter in enumerate(found, start=1)
    )
    contents = (
        f'<nav class="fb-contents" aria-label="Chapters">\n<ol>\n{entries}\n</ol>\n</nav>' if len(found) > 1 else ""
    )
    return f'<header class="fb-head">\n<h1><bdi>{escape(titled(job))}</bdi></h1>\n{said}</header>\n{contents}'


def _sections(found: Sequence[Chapter], addresses: Mapping[str, str]) -> Iterator[str]:
    names = speakers(found)
    for number, chapter in enumerate(found, start=1):
        flow = (
            _beside(item, addresses) if isinstance(item, Beside) else paragraph(item[1], names.get(item[1].face, ""))
            for item in chapter.flow()
        )
        yield (
            f'<section class="fb-chapter" id="chapter-{number}" aria-labelledby="chapter-{number}-title" '
            f"{_times(chapter.start, chapter.end)}>\n"
            f'<h2 id="chapter-{number}-title"><bdi>{escape(chapter.title)}</bdi></h2>\n'
            + "\n".join(flow)
            + "\n</section>"
        )


def _beside(item: Beside, addresses: Mapping[str, str]) -> str:
    times = _times(item.start, item.end)
    if isinstance(item.shown, AddLink):
        link = f'<a href="{escape(item.shown.address)}" target="_blank" rel="noopener noreferrer">'
        return f'<p class="fb-link" {times}>{link}<bdi>{escape(item.shown.text)}</bdi></a></p>'
    caption = escape(item.shown.caption)
    below = f"<figcaption>{caption}</figcaption>" if caption else ""
    source = addresses[item.shown.picture or ""]
    return f'<figure class="fb-picture" {times}><img src="{source}" alt="{caption}">{below}</figure>'


def _times(start: float, end: float) -> str:
    return f'data-start="{start:.3f}" data-end="{end:.3f}"'
