"""A performance to an `.html`: the face, its sound, its words and the player, in one file or with files beside it."""

from __future__ import annotations

import base64
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from html import escape
from pathlib import Path, PurePosixPath
from urllib.parse import quote

from facescript.backends.audio import opus, write_opus
from facescript.backends.job import Job
from facescript.backends.output import Outputs
from facescript.backends.page.figure import figure
from facescript.backends.page.motion import Motion, motion
from facescript.backends.page.still import still
from facescript.backends.page.template import filled, policy, with_end, with_head
from facescript.backends.page.words import Line, lines, transcript

HERE = Path(__file__).parent

SOUND = "sound.webm"
"""The sound's file in the folder of a page in several files."""


@dataclass(frozen=True, slots=True)
class Page:
    """A page's text, and the files beside it by their names in a folder (none where all is in the page)."""

    text: str
    files: Mapping[str, bytes] = field(default_factory=dict)


def write_html(job: Job, path: Path) -> None:
    """The page in one file, the same bytes each time. Raises `JobFailure`."""
    path.write_text(page(job).text, "utf-8", newline="\n")


def write_split(job: Job, target: Path, batch: Outputs) -> None:
    """The page, and beside it a folder with its sound and motion, which come to their places with the batch. Raises
    `JobFailure`, `OSError`."""
    name = f"{target.stem}-files"
    made = page(job, name)
    batch.place(target).write_text(made.text, "utf-8", newline="\n")
    folder = batch.folder(target.with_name(name))
    for file, data in made.files.items():
        batch.place(folder / file).write_bytes(data)
    if not job.heard.silent:
        write_opus(job.heard, batch.place(folder / SOUND))


def page(job: Job, folder: str = "") -> Page:
    """The page of a job; with a `folder`, sound and motion are files of that folder beside it. Raises `JobFailure`."""
    wish = job.page
    if wish.template == "book":
        from facescript.backends.page.book import book_page  # it is made of what is here

        return book_page(job, folder)
    template = resource(f"{wish.template}.html") if wish.brought is None else wish.brought
    return assembled(job, template, placeholders(job, lines(job.score, job.start, job.end)), folder)


def placeholders(job: Job, said: Sequence[Line]) -> dict[str, str]:
    """What stands for each of a template's placeholders, as HTML."""
    title = titled(job)
    names = {face.name: called(face.name) for face in job.score.faces}
    return {
        "title": escape(title),
        "author": escape(job.score.film.author),
        "language": escape(said[0].language if said else "en"),
        "script": escape(job.page.script),
        "face": _face(job, title),
        "controls": resource("controls.html"),
        "text": '<div class="fs-text" data-facescript="text" role="region" aria-label="Text">\n'
        f"{transcript(said, names, [scene.title for scene in job.score.scenes])}\n</div>",
    }


def assembled(job: Job, template: str, parts: Mapping[str, str], folder: str = "", scripts: Sequence[str] = ()) -> Page:
    """A template with its placeholders' `parts`, the player, further `scripts`, and the film they play."""
    player = "\n".join(resource(name) for name in ("drawing.js", "face.js", "player.js"))
    script = f'(() => {{\n"use strict";\n{player}\n}})();\n'
    moved = motion(job)
    film = {
        **figure(job.stage, moved),
        "duration": round(job.end - job.start, 3),
        "folder": quote(folder),
        "headlines": _headlines(job),
    }
    address, files, motions = _beside(job, moved, quote(folder)) if folder else _within(job, moved)
    end = [
        '<div class="fs-hidden" role="status" data-facescript="told"></div>',
        f'<audio preload="auto" data-facescript="sound" src="{address}"></audio>' if address else "",
        f'<script type="application/json" id="facescript-film">{_json(film)}</script>',
        motions,
        *(f"<script>{text}</script>" for text in (script, *scripts)),
    ]
    rule = policy([script, *scripts], job.page.brought is not None, bool(folder))
    head = (
        f'<meta http-equiv="Content-Security-Policy" content="{rule}">\n'
        f'<meta name="generator" content="FaceScript">\n<style>\n{resource("player.css")}</style>\n'
    )
    text = with_end(with_head(filled(template, parts), head), "\n".join(filter(None, end)) + "\n")
    return Page(text, files)


def titled(job: Job) -> str:
    """The title that the script gives, or the script's name in words."""
    acts = job.score.acts
    name = acts[0].span.source.name if acts else "FaceScript"
    return job.score.film.title or called(PurePosixPath(name).stem)


def _headlines(job: Job) -> list[tuple[float, str]]:
    """The titles of the scenes from the moments on in which they begin, and before the first one the page's own."""
    title = titled(job)
    scenes = [(round(scene.start - job.start, 3), scene.title or title) for scene in job.score.scenes]
    return [(-1.0, title), *(scene for scene in scenes if scene[0] < job.end - job.start)]


def called(name: str) -> str:
    """A name of the script as people write it."""
    words = name.replace("_", " ").replace("-", " ").strip()
    return words[:1].upper() + words[1:]


def resource(name: str) -> str:
    """The text of a file of this folder."""
    return (HERE / name).read_text("utf-8")


def _face(job: Job, title: str) -> str:
    """The place of the face: its first frame as a picture that needs no script, captions, a button to begin."""
    width, height = job.stage.width, job.stage.height
    return (
        f'<div class="fs-face" data-facescript="face" data-label="{escape(title)}" '
        f'style="aspect-ratio:{width}/{height}">\n'
        f'<div class="fs-still" aria-hidden="true">{still(job, job.start)}</div>\n'
        f'<div class="fs-caption" data-facescript="caption" aria-hidden="true"></div>\n'
        f'<button class="fs-begin" type="button" data-facescript="play" data-key="space" aria-label="Play">'
        '<svg viewBox="0 0 24 24" aria-hidden="true"><path d="M6 4v16l14-8z"/></svg></button>\n</div>'
    )


def _within(job: Job, moved: Motion) -> tuple[str, dict[str, bytes], str]:
    """Sound and motion in the page: the sound's address, no files, and the parts as elements."""
    sound = opus(job.heard)
    address = f"data:audio/webm;base64,{base64.b64encode(sound).decode('ascii')}" if sound else ""
    parts = (
        f'<script type="text/plain" id="facescript-part-{number}">{part.rows}</script>'
        for number, part in enumerate(moved.parts)
    )
    return address, {}, "\n".join(parts)


def _beside(job: Job, moved: Motion, folder: str) -> tuple[str, dict[str, bytes], str]:
    """Motion in files of the folder, as scripts: a page that lies on a disk may not fetch data. The sound's address is
    that of a file which is still to be written: hours of it are not held."""
    files = {
        f"{number}.js": f'facescript.part({number},"{part.rows}")\n'.encode() for number, part in enumerate(moved.parts)
    }
    return "" if job.heard.silent else f"{folder}/{SOUND}", files, ""


def _json(value: object) -> str:
    """As JSON that may stand in a script."""
    return json.dumps(value, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")
