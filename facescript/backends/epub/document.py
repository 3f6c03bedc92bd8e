"""A performance to an `.epub`: a chapter a scene, with its sound, its words' times and the faces that read it."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from uuid import UUID

import numpy as np

from facescript.backends.audio import write_mp3
from facescript.backends.chapters import Chapter, chapters, pictures, speakers
from facescript.backends.epub import names
from facescript.backends.epub.archive import Archive
from facescript.backends.epub.chapter import Setting, chapter_page
from facescript.backends.epub.overlay import overlay_document
from facescript.backends.epub.package import CONTAINER, Description, Item, navigation, package_document
from facescript.backends.job import Job
from facescript.backends.page.document import called, titled
from facescript.backends.page.words import html_language
from facescript.backends.stills import written
from facescript.backends.svg.telling import telling_moment
from facescript.stage.stage import Stage

STYLE = Path(__file__).with_name(names.STYLE)

WIDEST = 960
"""Pixels of a picture of the faces."""

XHTML, SMIL, MP3, PNG = "application/xhtml+xml", "application/smil+xml", "audio/mpeg", "image/png"


def write_epub(job: Job, path: Path) -> None:
    """The book of a job's stretch, the same bytes each time. Raises `JobFailure`."""
    found = chapters(job)
    with Archive(path) as archive, tempfile.TemporaryDirectory(prefix="facescript-") as folder:
        _Writer(job, found, archive, Path(folder)).write()


class _Writer:
    """Puts the parts of a book into an archive, the package last: it tells of all the others."""

    def __init__(self, job: Job, found: Sequence[Chapter], archive: Archive, folder: Path) -> None:
        self._job, self._chapters, self._archive, self._folder = job, found, archive, folder
        self._items: list[Item] = []
        self._durations: dict[str, float] = {}
        self._languages = _languages(job, found)

    def write(self) -> None:
        self._archive.put("META-INF/container.xml", CONTAINER.encode())
        self._text(Item("style", names.STYLE, "text/css"), STYLE.read_text("utf-8"))
        self._faces()
        setting = Setting(self._languages[0], speakers(self._chapters), self._pictures())
        for number, chapter in enumerate(self._chapters, start=1):
            self._chapter(number, chapter, setting)
            self._job.progress(number, len(self._chapters))
        titles = [chapter.title for chapter in self._chapters]
        told = navigation(titled(self._job), self._languages[0], titles)
        self._text(Item("nav", names.NAVIGATION, XHTML, "nav"), told)
        self._package()

    def _chapter(self, number: int, chapter: Chapter, setting: Setting) -> None:
        overlay = ""
        if any(line.words for line in chapter.lines):
            overlay = f"overlay-{number}"
            file = self._folder / names.sound(number)
            write_mp3(self._job.sound.between(*self._span(chapter)), file)
            self._put(Item(f"sound-{number}", names.sound(number), MP3), file)
            document = overlay_document(chapter, names.page(number), names.sound(number))
            self._text(Item(overlay, names.overlay(number), SMIL), document)
            self._durations[overlay] = round(chapter.duration, 3)
        page = chapter_page(chapter, setting, names.face(number), _seen(self._job, chapter))
        self._text(Item(f"chapter-{number}", names.page(number), XHTML, overlay=overlay), page)

    def _span(self, chapter: Chapter) -> tuple[float, float]:
        """A chapter's stretch of the film."""
        return self._job.start + chapter.start, self._job.start + chapter.end

    def _faces(self) -> None:
        """The cover, and a picture of the faces for each chapter."""
        spans = [(self._job.start, self._job.end), *map(self._span, self._chapters)]
        moments = np.array([telling_moment(self._job, start, end) for start, end in spans])
        files = [names.COVER, *(names.face(number) for number in range(1, len(spans)))]
        drawn = written(_smaller(self._job), moments, [self._folder / file for file in files])
        for number, file in enumerate(drawn):
            about = {"id": f"face-{number}"} if number else {"id": "cover", "properties": "cover-image"}
            self._put(Item(name=file.name, kind=PNG, **about), file)

    def _pictures(self) -> dict[str, str]:
        """The files of the pictures beside the faces by their paths in the project."""
        files: dict[str, str] = {}
        for path, data, kind in pictures(self._job, self._chapters):
            files[path] = f"picture-{len(files) + 1:03d}.{kind.partition('/')[2]}"
            self._bytes(Item(f"picture-{len(files)}", files[path], kind), data)
        return files

    def _package(self) -> None:
        identifier = UUID(bytes=self._archive.digest()[:16], version=5)
        film = self._job.score.film
        book = Description(titled(self._job), film.author, str(identifier), self._languages, self._durations)
        spine = [f"chapter-{number}" for number in range(1, len(self._chapters) + 1)]
        self._archive.put(f"EPUB/{names.PACKAGE}", package_document(book, self._items, spine).encode())

    def _text(self, item: Item, text: str) -> None:
        self._bytes(item, text.encode())

    def _bytes(self, item: Item, data: bytes) -> None:
        self._archive.put(f"EPUB/{item.name}", data, packed=item.kind in (XHTML, SMIL, "text/css"))
        self._items.append(item)

    def _put(self, item: Item, file: Path) -> None:
        """A file of the folder, which is not needed any more."""
        self._archive.put_file(f"EPUB/{item.name}", file)
        file.unlink()
        self._items.append(item)


def _smaller(job: Job) -> Stage:
    """The job's stage in a size that suits the page of a book."""
    film = job.score.film
    share = min(1.0, WIDEST / film.width)
    film = replace(film, width=round(film.width * share), height=round(film.height * share))
    return Stage(replace(job.score, film=film), job.performance, job.pictures)


def _languages(job: Job, found: Sequence[Chapter]) -> tuple[str, ...]:
    """The languages that are read, the one of most lines first; that of the faces where nobody speaks."""
    spoken = [line.language for chapter in found for line in chapter.lines]
    spoken = spoken or [html_language(face.voice.language) for face in job.score.faces]
    return tuple(sorted(dict.fromkeys(spoken), key=lambda language: -spoken.count(language))) or ("en",)


def _seen(job: Job, chapter: Chapter) -> str:
    """Who is seen in a chapter."""
    return ", ".join(called(face.name) for face in job.score.faces if face.seen and face.name in chapter.faces)
