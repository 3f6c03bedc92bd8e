"""A performance to an animated `.svg`: one element a shape, its outline animated by SMIL, the sound inside."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from typing import IO

from lxml import etree

from facescript.backends.job import Job
from facescript.backends.svg_animation import QUANTUM, Animation, animation
from facescript.backends.svg_paint import Paints
from facescript.backends.svg_sound import sound_address
from facescript.backends.svg_track import SVG, Clock, animate
from facescript.rig.picture import Shape

XHTML = "http://www.w3.org/1999/xhtml"
PLAYER = Path(__file__).with_name("svg_player.js")
UNFIT = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What XML cannot hold."""


def write_svg(job: Job, path: Path, sound: bool = True) -> None:
    """The film, or the moment `job.at`, as one file that plays by itself. Raises `JobFailure`.

    SMIL plays it without script; where scripts run, `svg_player.js` keeps it to the sound's clock.
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
    yield _definitions(shapes, moving, paints)
    yield from ground
    yield from picture
    if address:
        yield from _player(size, address)


def _definitions(shapes: tuple[Shape, ...], moving: Animation, paints: Paints) -> etree._Element:
    """Gradients, and a clip for every set of shapes that bound others."""
    definitions = etree.Element(f"{{{SVG}}}defs")
    definitions.extend(paints.elements())
    for clip in dict.fromkeys(shape.clip for shape in shapes if shape.clip):
        element = etree.SubElement(definitions, f"{{{SVG}}}clipPath", id=_clip_name(clip))
        for name in clip:
            etree.SubElement(element, f"{{{SVG}}}use", href=f"#{name}")
    return definitions


def _faces(
    job: Job, shapes: tuple[Shape, ...], moving: Animation, paints: Paints, clock: Clock
) -> Iterator[etree._Element]:
    """A group a face, in it a group a layer, in it a path a shape."""
    owners = job.stage.owners
    rows = list(zip(owners, shapes, moving.outlines, moving.opacities, strict=True))
    clips = {name for shape in shapes for name in shape.clip}
    for owner, part in groupby(rows, key=lambda row: (row[0], row[1].group == "background")):
        kind = "backdrop" if owner[1] else "face"
        face = etree.Element(f"{{{SVG}}}g", {"class": kind, "data-face": owner[0], "transform": f"scale({QUANTUM})"})
        for group, layer in groupby(part, key=lambda row: row[1].group):
            element = etree.SubElement(face, f"{{{SVG}}}g", {"class": group})
            for _, shape, outline, opacity in layer:
                if shape.id in clips or not (opacity.still and opacity.values[0] == "0"):
                    path = etree.SubElement(element, f"{{{SVG}}}path", id=shape.id, fill=paints.fill(shape.fill))
                    if shape.clip:
                        path.set("clip-path", f"url(#{_clip_name(shape.clip)})")
                    animate(path, "d", outline, clock)
                    if not (opacity.still and opacity.values[0] == "1"):
                        animate(path, "opacity", opacity, clock)
        yield face


def _clip_name(clip: tuple[str, ...]) -> str:
    return "clip-" + "-".join(clip)


def _player(size: tuple[int, int], address: str) -> Iterator[etree._Element]:
    """The sound, a sign to click, and the script that joins picture and sound."""
    holder = etree.Element(f"{{{SVG}}}foreignObject", width="1", height="1")
    etree.SubElement(holder, f"{{{XHTML}}}audio", {"src": address, "preload": "auto"}, nsmap={None: XHTML})
    yield holder
    middle, side = (size[0] / 2, size[1] / 2), min(size) / 12
    sign = {"class": "play", "visibility": "hidden", "role": "button", "tabindex": "0", "cursor": "pointer"}
    place = f"translate({middle[0]:g} {middle[1]:g}) scale({side:.2f})"
    button = etree.Element(f"{{{SVG}}}g", {**sign, "aria-label": "play", "transform": place})
    etree.SubElement(button, f"{{{SVG}}}circle", {"r": "1", "fill": "#1d1d1d", "fill-opacity": "0.6"})
    etree.SubElement(button, f"{{{SVG}}}path", d="M-.35-.5 .6 0-.35 .5z", fill="#ffffff")
    yield button
    script = etree.Element(f"{{{SVG}}}script")
    script.text = PLAYER.read_text("utf-8")
    yield script


def _text(tag: str, text: str) -> etree._Element:
    element = etree.Element(f"{{{SVG}}}{tag}")
    element.text = UNFIT.sub("\ufffd", text)
    return element
