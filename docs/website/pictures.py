"""The pictures that pages ask for to files in `build/pictures`: drawn in parallel, kept while what makes them is so.

A file's name is a hash of its block and of all that draws it: the compiler, the library, the examples' folder.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

from website.draw import FOLDER, calm, draw, suffix
from website.fences import Picture

ROOT = Path(__file__).parents[2]
KEPT = ROOT / "build" / "pictures"

APART = ("api", "cli", "diagnostics", "lsp", "preview")
"""Rooms of the compiler that no picture comes from."""


class PictureFault(Exception):
    """A block that cannot be drawn; `args[0]` says why."""


@cache
def _made_by() -> bytes:
    """A hash of whatever may change a picture."""
    seen = hashlib.sha256()
    package = (
        path
        for path in (ROOT / "facescript").rglob("*.py")
        if path.relative_to(ROOT / "facescript").parts[0] not in APART
    )
    others = ((ROOT / "stdlib").rglob("*.face"), (ROOT / "grammar").iterdir(), FOLDER.rglob("*"))
    drawing = (Path(__file__).with_name("draw.py"),)
    for path in sorted(each for group in (package, *others, drawing) for each in group):
        if path.is_file():
            seen.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return seen.digest()


@cache
def place(picture: Picture) -> Path:
    """Where the picture's file stands once it is made."""
    told = "\0".join(
        map(str, (picture.kind, picture.script, picture.start, picture.end, picture.wide, picture.channels))
    )
    name = hashlib.sha256(_made_by() + told.encode()).hexdigest()[:20]
    return KEPT / f"{name}{suffix(picture)}"


def files(picture: Picture) -> tuple[Path, ...]:
    """All files of a picture: of a film its still besides."""
    path = place(picture)
    return (path, calm(path)) if picture.kind == "film" else (path,)


def make(pictures: Iterable[Picture]) -> int:
    """Draw what is not there yet, throw away what no page asks for; how many were drawn. Raises `PictureFault`."""
    KEPT.mkdir(parents=True, exist_ok=True)
    wanted = {place(picture): picture for picture in pictures}
    missing = [picture for picture in wanted.values() if not all(path.is_file() for path in files(picture))]
    kept = {path for picture in wanted.values() for path in files(picture)}
    for path in KEPT.iterdir():
        if path not in kept:
            path.unlink()
    if missing:
        with ProcessPoolExecutor(os.cpu_count()) as hands:
            list(hands.map(_make, missing, chunksize=4))
    return len(missing)


def _make(picture: Picture) -> None:
    """Draw one; a file that is there is whole."""
    path = place(picture)
    part = path.with_name(f"part-{path.name}")
    try:
        draw(picture, part)
    except Exception as fault:
        raise PictureFault(f"{fault}\n{picture.script}") from None
    for made, kept in zip((part, calm(part)), (path, calm(path)), strict=True):
        if made.is_file():
            made.replace(kept)
