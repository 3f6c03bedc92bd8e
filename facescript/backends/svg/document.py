"""A performance to an animated `.svg`: one element a shape, its outline animated by SMIL, the sound inside."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import IO

from lxml import etree

from facescript.backends.job import Job, quiet
from facescript.backends.svg.animation import Animation, animation
from facescript.backends.svg.layers import PLAYED, STOOD, picture_groups, showings
from facescript.backends.svg.paint import RULES
from facescript.backends.svg.sound import sound_address
from facescript.backends.svg.telling import telling_moment
from facescript.backends.svg.track import SVG, Clock, svg

XHTML = "http://www.w3.org/1999/xhtml"
PLAYER = Path(__file__).with_name("player.js")
UNFIT = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What XML cannot hold."""

CALM = (
    "@media (prefers-reduced-motion:reduce){"
    f"svg:not(.asked) .{PLAYED}{{display:none}}svg:not(.asked) .{STOOD}{{display:inline}}}}"
)
"""Where motion is not wanted the still picture shows, until play is asked for (`player.js`)."""


def write_svg(job: Job, path: Path, sound: bool = True) -> None:
    """The film, or the moment `job.at`, as one file that plays by itself. Raises `JobFailure`.

    SMIL plays it without script; where scripts run, `player.js` keeps it to the sound's clock.
    """
    with path.open("wb") as out:
        write_document(job, out, sound and job.at is None)


def write_document(job: Job, out: IO[bytes], sound: bool) -> None:
    length = 0.0 if job.at is not None else job.end - job.start
    played = animation(job)
    still = replace(job, at=telling_moment(job), progress=quiet) if job.at is None else None
    stood = animation(still, played.curved) if still else None
    address = sound_address(job.heard) if sound else None
    with etree.xmlfile(out, encoding="utf-8") as file:
        file.write_declaration()
        with file.element(f"{{{SVG}}}svg", _head(job, length), nsmap={None: SVG}):
            for element in _body(job, played, stood, Clock.around(length), address):
                file.write(element)
    out.write(b"\n")


def _head(job: Job, length: float) -> dict[str, str]:
    width, height = job.stage.width, job.stage.height
    return {
        "viewBox": f"0 0 {width} {height}",
        "width": str(width),
        "height": str(height),
        "role": "img",
        "data-duration": f"{length:.3f}",
    }


def _body(
    job: Job, played: Animation, stood: Animation | None, clock: Clock, address: str | None
) -> Iterator[etree._Element]:
    shown, rules = showings(played, stood), list[str]()
    picture = [*picture_groups(job.stage, shown, clock, rules)]
    yield _text("title", " and ".join(face.name for face in job.score.faces if face.seen) or "FaceScript")
    yield _text("desc", _description(job))
    yield _text("style", RULES % "".join(rules) + (CALM if stood else ""), type="text/css")
    yield from picture
    if address:
        yield from _player((job.stage.width, job.stage.height), address)


def _description(job: Job) -> str:
    """Who is seen, and who says what, a line each."""
    faces = [f"{face.name}, {face.kind}" for face in job.score.faces if face.seen]
    return "\n".join([*faces, *(f"{face}: {text}" for face, text in job.spoken())])


def _player(size: tuple[int, int], address: str) -> Iterator[etree._Element]:
    """The sound, a sign to click, and the script that joins picture and sound."""
    holder = svg("foreignObject", width="1", height="1")
    etree.SubElement(holder, f"{{{XHTML}}}audio", {"src": address, "preload": "auto"}, nsmap={None: XHTML})
    yield holder
    place = f"translate({size[0] / 2:g} {size[1] / 2:g}) scale({min(size) / 12:.2f})"
    sign = {"role": "button", "tabindex": "0", "cursor": "pointer", "aria_label": "play"}
    button = svg("g", class_="play", visibility="hidden", transform=place, **sign)
    button.append(svg("circle", r="1", fill="#1d1d1d", fill_opacity="0.6"))
    button.append(svg("path", d="M-.35-.5 .6 0-.35 .5z", fill="#ffffff"))
    yield button
    script = svg("script", type="text/javascript")
    script.text = PLAYER.read_text("utf-8")
    yield script


def _text(tag: str, text: str, **attributes: str) -> etree._Element:
    element = svg(tag, **attributes)
    element.text = UNFIT.sub("\ufffd", text)
    return element
