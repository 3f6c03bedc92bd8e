"""A performance to an animated `.svg`: one element a shape, its outline animated by SMIL, the sound inside."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import IO

from lxml import etree

from facescript.backends.job import Job
from facescript.backends.svg.animation import QUANTUM, Animation, animation
from facescript.backends.svg.paint import Paints
from facescript.backends.svg.sound import sound_address
from facescript.backends.svg.track import SVG, Clock, Track, animate, carry, svg
from facescript.rig.picture import Shape
from facescript.stage.actor import BACKDROP

XHTML = "http://www.w3.org/1999/xhtml"
PLAYER = Path(__file__).with_name("player.js")
UNFIT = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What XML cannot hold."""


def write_svg(job: Job, path: Path, sound: bool = True) -> None:
    """The film, or the moment `job.at`, as one file that plays by itself. Raises `JobFailure`.

    SMIL plays it without script; where scripts run, `player.js` keeps it to the sound's clock.
    """
    with path.open("wb") as out:
        write_document(job, out, sound and job.at is None)


def write_document(job: Job, out: IO[bytes], sound: bool) -> None:
    shapes = job.stage.shapes
    moving = animation(job, shapes)
    length = 0.0 if job.at is not None else job.end - job.start
    address = sound_address(job.heard) if sound else None
    with etree.xmlfile(out, encoding="utf-8") as file:
        file.write_declaration()
        with file.element(f"{{{SVG}}}svg", _head(job, length), nsmap={None: SVG}):
            for element in _body(job, shapes, moving, Clock.around(length), address):
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
    job: Job, shapes: tuple[Shape, ...], moving: Animation, clock: Clock, address: str | None
) -> Iterator[etree._Element]:
    paints = Paints()
    size = job.stage.width, job.stage.height
    ground = list(moving.behind.elements(size, job.pictures, paints, clock))
    picture = list(_faces(job, shapes, moving, paints, clock))
    yield _text("title", " and ".join(face.name for face in job.score.faces if face.seen) or "FaceScript")
    yield _text("desc", "\n".join(f"{face}: {text}" for face, text in job.spoken()))
    yield _definitions(shapes, paints)
    yield from ground
    yield from picture
    if address:
        yield from _player(size, address)


def _definitions(shapes: tuple[Shape, ...], paints: Paints) -> etree._Element:
    """Gradients, and a clip for every set of shapes that bound others."""
    definitions = svg("defs")
    definitions.extend(paints.elements())
    for clip in dict.fromkeys(shape.clip for shape in shapes if shape.clip):
        element = svg("clipPath", id=_clip_name(clip))
        element.extend(svg("use", href=f"#{name}") for name in clip)
        definitions.append(element)
    return definitions


def _faces(
    job: Job, shapes: tuple[Shape, ...], moving: Animation, paints: Paints, clock: Clock
) -> Iterator[etree._Element]:
    """A group a face, in it a group a layer, in it a path a shape."""
    rows = list(zip(job.stage.owners, shapes, moving.outlines, moving.opacities, moving.carried, strict=True))
    clips = {name for shape in shapes for name in shape.clip}
    for (owner, backdrop), part in groupby(rows, key=lambda row: (row[0], row[1].group == BACKDROP)):
        face = svg("g", class_="backdrop" if backdrop else "figure", data_face=owner, transform=f"scale({QUANTUM})")
        for number, carried in groupby(part, key=lambda row: row[4]):
            carrier = svg("g")
            carry(carrier, moving.carriers[number], clock)
            for group, layer in groupby(carried, key=lambda row: row[1].group):
                element = svg("g", class_=group)
                for _, shape, outline, opacity, _ in layer:
                    if shape.id in clips or not (opacity.still and opacity.values[0] == "0"):
                        element.append(_path(shape, outline, opacity, paints, clock))
                carrier.append(element)
            face.append(carrier)
        yield face


def _path(shape: Shape, outline: Track, opacity: Track, paints: Paints, clock: Clock) -> etree._Element:
    clip = {"clip_path": f"url(#{_clip_name(shape.clip)})"} if shape.clip else {}
    path = svg("path", id=shape.id, fill=paints.fill(shape.fill), **clip)
    animate(path, "d", outline, clock)
    if not (opacity.still and opacity.values[0] == "1"):
        animate(path, "opacity", opacity, clock)
    return path


def _clip_name(clip: tuple[str, ...]) -> str:
    return "clip-" + "-".join(clip)


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
    script = svg("script")
    script.text = PLAYER.read_text("utf-8")
    yield script


def _text(tag: str, text: str) -> etree._Element:
    element = svg(tag)
    element.text = UNFIT.sub("\ufffd", text)
    return element
