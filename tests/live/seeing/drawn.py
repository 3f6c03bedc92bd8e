"""Pictures of a camera with drawn faces in them, and films of such pictures: a cascade takes them for faces."""

from __future__ import annotations

import subprocess
from collections.abc import Iterable, Sequence
from functools import cache
from math import radians, tan
from pathlib import Path

import imageio_ffmpeg
import numpy as np
from numpy.typing import NDArray

from facescript.canvas.painter import Painter
from facescript.diagnostics.model import Diagnostics
from facescript.ir.values import Point
from facescript.live.seeing.faces import Picture
from facescript.live.seeing.geometry import Camera
from facescript.performance.performance import REST
from facescript.resolve.resolver import resolve
from facescript.rig.rigs import rig as rig_of
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World

WIDE, HIGH, FPS = 640, 480, 30

APART, EYE_X, EYE_Y = 0.165, 0.499, 0.44
"""Of a drawn woman, as parts of the picture's side: from pupil to pupil, and the place between them."""

SIDE = 6.3 / APART
"""cm that the side of her picture stands for: her pupils are 6.3 apart."""

Colours = NDArray[np.float32]


@cache
def woman(side: int) -> Colours:
    """A woman who looks straight ahead, `side` pixels high: array[y, x] of B, G, R, A from 0 to 255, premultiplied."""
    diagnostics = Diagnostics()
    play = resolve(parse(Source("one.face", "face ada = woman\nnod\n"), diagnostics), World(Path()), diagnostics)
    assert play is not None
    rig = rig_of(play.faces[0])
    painter = Painter(side, side, rig.shapes)
    drawn = rig.draw(np.array([REST]))
    nothing = np.zeros((side, side), dtype=np.uint32)
    painter.draw(drawn.points[0] * (side / rig.box[0]), drawn.opacity[0], nothing)
    return painter.pixels.view(np.uint8).reshape(side, side, 4).astype(np.float32)


@cache
def room() -> Colours:
    """An empty room: a wall that is darker above, and some grain."""
    chance = np.random.default_rng(1)
    wall = np.linspace(90, 150, HIGH)[:, None, None] * np.array([1.0, 0.95, 0.9])
    return (wall + chance.normal(0.0, 3.0, (HIGH, WIDE, 1))).astype(np.float32)


def scene(camera: Camera, places: Sequence[Point]) -> Picture:
    """What a camera sees of persons at places (cm), who face it; the furthest is drawn first."""
    found = room().copy()
    for place in sorted(places, key=lambda place: -place.z):
        x, y, scale = projected(camera, place)
        side = round(SIDE * scale)
        paste(found, woman(side), round(x - EYE_X * side), round(y - EYE_Y * side))
    return found.round().astype(np.uint8)


def projected(camera: Camera, place: Point) -> tuple[float, float, float]:
    """Where a place is in the picture, pixels, and how many a centimetre there takes up. The room is turned before the
    camera, which is another way than that which is tested."""
    tilt, away = (
        radians(camera.tilt),
        np.array([place.x, place.y, place.z]) - np.array([camera.place.x, camera.place.y, camera.place.z]),
    )
    forward, up = np.array([0.0, np.sin(tilt), np.cos(tilt)]), np.array([0.0, np.cos(tilt), -np.sin(tilt)])
    scale = WIDE / 2 / tan(radians(camera.fov / 2)) / (away @ forward)
    return WIDE / 2 + scale * (away @ np.cross(forward, up)), HIGH / 2 - scale * (away @ up), scale


def paste(ground: Colours, over: Colours, left: int, top: int) -> None:
    side = len(over)
    here = ground[max(0, top) : max(0, top + side), max(0, left) : max(0, left + side)]
    part = over[max(0, -top) :, max(0, -left) :][: here.shape[0], : here.shape[1]]
    here[...] = here * (1.0 - part[:, :, 3:] / 255.0) + part[:, :, :3]


def film(path: Path, pictures: Iterable[Picture]) -> None:
    """A film of pictures of one size, `FPS` a second."""
    first, *others = pictures
    words = [imageio_ffmpeg.get_ffmpeg_exe(), "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "bgr24"]
    words += ["-s", f"{first.shape[1]}x{first.shape[0]}", "-r", str(FPS), "-i", "-"]
    words += ["-preset", "ultrafast", "-pix_fmt", "yuv420p", str(path)]
    with subprocess.Popen(words, stdin=subprocess.PIPE) as process:
        assert process.stdin is not None
        for picture in (first, *others):
            process.stdin.write(picture.tobytes())
        process.stdin.close()
    assert process.returncode == 0
