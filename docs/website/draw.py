"""What a block asks to be shown, to one file: a still or a moving `.webp`, or a plot in `.svg`."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from facescript.backends.frames import pictures
from facescript.backends.job import Job
from facescript.compile import Settings, compile_source
from facescript.ir.play import Film
from facescript.plot.picture import Asked
from facescript.plot.picture import draw as plotted
from facescript.plot.svg import write_svg
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.world import World
from website.fences import Picture

FOLDER = Path(__file__).parents[2] / "examples"
"""Where scripts of the pages stand: what they use and speak from lies there."""

FINE, FINE_MOVING = 2, 1
"""Pixels for a CSS px: of a still, and of what moves, which weighs much more."""

QUALITY, RATE = 82, 15.0
"""Of the `.webp`, and frames a second."""


def suffix(picture: Picture) -> str:
    return ".svg" if picture.kind == "plot" else ".webp"


def draw(picture: Picture, path: Path) -> None:
    """Write the file. Raises `AssertionError` with what is said of a script that has faults."""
    {"picture": _still, "film": _film, "plot": _plot}[picture.kind](picture, path)


def _job(picture: Picture, fine: int) -> Job:
    world, source = World(FOLDER), Source("page.face", picture.script)
    voice = open_studio(world)
    compiled = compile_source(source, world, voice)
    assert compiled.play is not None, [item.message for item in compiled.diagnostics]
    size = _size(compiled.play.film, picture.wide * fine)
    sized = compile_source(source, world, voice, Settings(film=size))
    assert sized.play is not None and sized.score is not None, [item.message for item in sized.diagnostics]
    return Job(sized.play, sized.score, world.read, picture.start, picture.end, jobs=1)


def _size(film: Film, wide: int) -> dict[str, float]:
    """The film's size made `wide` px, with an even height."""
    return {"width": wide, "height": 2 * round(film.height * wide / film.width / 2)}


def _images(picture: Picture, fine: int, times: list[float]) -> list[Image.Image]:
    stage = _job(picture, fine).stage
    frames = pictures(stage, np.array(times))
    return [Image.fromarray(np.ascontiguousarray(frame[..., 2::-1])) for frame in frames]


def _still(picture: Picture, path: Path) -> None:
    (image,) = _images(picture, FINE, [picture.start])
    image.save(path, "WEBP", quality=QUALITY)


def _film(picture: Picture, path: Path) -> None:
    """It begins again for ever; its middle stands beside it for those who want less motion."""
    times = list(np.arange(picture.start, picture.end, 1 / RATE))
    first, *others = _images(picture, FINE_MOVING, times)
    first.save(
        path,
        "WEBP",
        save_all=True,
        append_images=others,
        duration=round(1000 / RATE),
        loop=0,
        quality=QUALITY,
        method=4,
    )
    [first, *others][len(times) // 2].save(calm(path), "WEBP", quality=QUALITY)


def calm(path: Path) -> Path:
    """Where the still of a film stands."""
    return path.with_name(f"{path.stem}-calm.webp")


def _plot(picture: Picture, path: Path) -> None:
    """As wide as it is shown, so that its words can be read, and as high as its panels need."""
    channels = tuple(name.strip() for name in picture.channels.split(",") if name.strip())
    job = _job(picture, 1)
    high = plotted(job, Asked("", channels)).height
    write_svg(plotted(job, Asked("", channels, (picture.wide, high))), path)
